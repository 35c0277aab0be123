"""Arrays in and out: numpy is the oracle."""
import unittest

from support import Case, ball, numpy

import velum


class Volumes(Case):
    def test_every_type_of_voxels_comes_out_as_it_went_in(self):
        random = numpy.random.default_rng(1)
        for name in ("uint8", "int8", "uint16", "int16", "uint32", "int32", "float32", "float64"):
            array = (random.random((5, 4, 3)) * 100).astype(name)
            out = velum.Volume(array).array
            self.assertEqual(out.dtype, array.dtype)
            numpy.testing.assert_array_equal(out, array)
        for given, held in (("bool", "uint8"), ("float16", "float32"), (">u2", "uint16"), (">f8", "float64")):
            array = (random.random((5, 4, 3)) * 100).astype(given)
            out = velum.Volume(array).array
            self.assertEqual(out.dtype, numpy.dtype(held), given)
            numpy.testing.assert_array_equal(out, array.astype(held))

    def test_any_strides(self):
        array = numpy.arange(2 * 6 * 8 * 10).reshape(2 * 6, 8, 10).astype("int16")
        views = [array[::-1], array[:, ::-2, ::3], array.T, numpy.asfortranarray(array), array[::2, 1:-1],
                 numpy.broadcast_to(array[0], (4, 8, 10)), numpy.moveaxis(array, 2, 0)]
        for view in views:
            numpy.testing.assert_array_equal(velum.Volume(view).array, view)

    def test_channels_and_time_steps(self):
        for shape in ((2, 3, 4, 2), (5, 2, 3, 4, 1), (5, 2, 3, 4, 3)):
            array = numpy.arange(numpy.prod(shape)).reshape(shape).astype("uint16")
            numpy.testing.assert_array_equal(velum.Volume(array).array, array)
        color = numpy.zeros((2, 3, 4, 3), "uint8")
        self.assertTrue(velum.Volume(color, color=True).color)

    def test_facts_and_places(self):
        array = ball()
        volume = velum.Volume(array, spacing=(1, 2, 3), origin=(10, 20, 30), unit="HU", modality="CT", name="a ball", lengthUnit="angstrom")
        numpy.testing.assert_array_equal(volume.affine, [[1, 0, 0, 10], [0, 2, 0, 20], [0, 0, 3, 30], [0, 0, 0, 1]])
        self.assertEqual((volume.spacing, volume.origin), ((1, 2, 3), (10, 20, 30)))
        self.assertEqual((volume.unit, volume.modality, volume.name, volume.lengthUnit), ("HU", "CT", "a ball", "angstrom"))
        self.assertEqual(volume.range, (0, 1000))
        affine = numpy.array([[0, 2, 0, 5], [-1, 0, 0, 6], [0, 0, 3, 7], [0, 0, 0, 1.0]])
        numpy.testing.assert_array_equal(velum.Volume(array, affine=affine).affine, affine)
        self.assertEqual(velum.Volume(array, affine=affine).spacing, (1, 2, 3))

    def test_the_range_leaves_out_what_is_no_number(self):
        array = ball(dtype="float32")
        array[0, 0, :3] = numpy.nan, numpy.inf, -numpy.inf
        self.assertEqual(velum.Volume(array).range, (0, 1000))

    def test_what_comes_out_is_no_copy_and_stays(self):
        volume = velum.Volume(ball())
        array, again = volume.array, volume.array
        self.assertEqual(array.ctypes.data, again.ctypes.data)
        self.assertFalse(array.flags.writeable)
        del volume
        numpy.testing.assert_array_equal(array, ball())
        with velum.open(array) as session:
            out = session.voxels.array
        numpy.testing.assert_array_equal(out, ball())

    def test_numpy_takes_them_and_copies_only_where_it_may(self):
        volume, labels = velum.Volume(ball()), velum.Labels(ball(inside=3))
        self.assertEqual(volume.__array__(copy=False).ctypes.data, volume.array.ctypes.data)
        self.assertEqual(volume.__array__("int16", copy=False).ctypes.data, volume.array.ctypes.data)
        self.assertTrue(volume.__array__(copy=True).flags.writeable)
        self.assertEqual(volume.__array__("float32").dtype, numpy.float32)
        numpy.testing.assert_array_equal(numpy.asarray(labels), ball(inside=3))
        for data, dtype in ((volume, "float32"), (labels, None), (labels, "uint16")):
            with self.subTest(dtype=dtype), self.assertRaises(ValueError):
                data.__array__(dtype, copy=False)

    def test_what_goes_in_is_copied(self):
        array = ball()
        volume = velum.Volume(array)
        array[:] = 7
        self.assertEqual(volume.range, (0, 1000))
        numpy.testing.assert_array_equal(volume.array, ball())

    def test_files_hold_the_same(self):
        volume = velum.Volume(ball(), spacing=(1, 2, 3), origin=(4, 5, 6))
        for name in ("ball.nrrd", "ball.nii.gz"):
            volume.save(self.folder / name)
            with velum.open(self.folder / name) as session:
                numpy.testing.assert_array_equal(session.voxels.array, ball())
                numpy.testing.assert_allclose(session.voxels.affine, volume.affine, atol=1e-6)

    def test_what_is_no_volume_is_refused(self):
        rows = [((numpy.zeros((3, 3)),), {}, "shape"), ((numpy.zeros((0, 3, 3)),), {}, "shape"), ((numpy.zeros((2, 2, 2), "int64"),), {}, "int64"),
                ((numpy.zeros((2, 2, 2), "complex64"),), {}, "complex64"), ((ball(),), {"spacing": (1, 0, 1)}, "spacing"),
                ((ball(),), {"spacing": 2}, "spacing"), ((ball(),), {"affine": numpy.zeros((4, 4))}, "affine"),
                ((ball(),), {"affine": numpy.eye(3)}, "affine"), ((ball(),), {"affine": numpy.eye(4), "origin": (1, 2, 3)}, "affine"),
                ((ball(),), {"lengthUnit": "inch"}, "inch"), ((ball(),), {"modality": "X"}, "modality"), ((ball(),), {"color": True}, "colours")]
        for arguments, named, word in rows:
            with self.subTest(word=word, named=named), self.assertRaises(velum.ArgumentError) as caught:
                velum.Volume(*arguments, **named)
            self.assertIn(word, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))


class Labels(Case):
    def test_numbers_of_any_type(self):
        array = ball(inside=3)
        for name in ("uint8", "int16", "uint16", "int64", "uint64", "bool"):
            given = array.astype(name)[::-1].T
            labels = velum.Labels(given, spacing=(2, 2, 2))
            self.assertEqual(labels.array.dtype, numpy.uint16)
            numpy.testing.assert_array_equal(labels.array, given)
        self.assertEqual(velum.Labels(array, names={5: "nowhere"}).names, {3: velum.Labels(array).names[3], 5: "nowhere"})
        labels = velum.Labels(array, names={3: "ball"}, colors={3: (1, 0, 0.5)})
        self.assertEqual((labels.names, labels.colors), ({3: "ball"}, {3: (1, 0, 0.5)}))

    def test_what_is_no_label_is_refused(self):
        for array, named, word in ((ball(dtype="float32"), {}, "float32"), (ball(inside=-1), {}, "-1"), (ball(inside=65536, dtype="int32"), {}, "65536"),
                                   (ball(), {"names": {0: "x"}}, "0 is no label"), (ball(), {"colors": {5: (1, 0, 0)}}, "5"), (numpy.zeros((3, 3), "uint8"), {}, "shape")):
            with self.subTest(word=word), self.assertRaises(velum.ArgumentError) as caught:
                velum.Labels(array, **named)
            self.assertIn(word, str(caught.exception))

    def test_they_lie_on_the_volume(self):
        with velum.open(ball(), spacing=(1, 2, 3)) as session:
            session.labels = ball(inside=7) > 0
            numpy.testing.assert_array_equal(session.labels.array, ball(inside=1))
            numpy.testing.assert_array_equal(session.labels.affine, session.voxels.affine)
            session.undo()
            self.assertIsNone(session.labels)
            session.labels = velum.Labels(ball(inside=2), names={2: "ball"}, affine=session.voxels.affine)
            self.assertEqual(session["labels.structures.0.name"], "ball")
            (row,) = session.measure(structures=True)["structures"]
            self.assertEqual(row["name"], "ball")
            with self.assertRaises(velum.ArgumentError):
                session.labels = numpy.zeros((2, 2, 2), "uint8")

    def test_files_hold_the_same(self):
        labels = velum.Labels(ball(inside=9), names={9: "a ball"})
        labels.save(self.folder / "ball.seg.nrrd")
        with velum.open(ball()) as session:
            session.add(self.folder / "ball.seg.nrrd")
            numpy.testing.assert_array_equal(session.labels.array, ball(inside=9))
            self.assertEqual(session.labels.names, {9: "a ball"})


if __name__ == "__main__":
    unittest.main()
