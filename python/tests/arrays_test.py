"""Arrays in and out: numpy is the oracle."""
import gc
import sys
import unittest
import weakref

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

    def test_what_goes_in_is_shared_and_cannot_be_written_to(self):
        for shape in ((6, 5, 4), (3, 4, 5, 2), (2, 3, 4, 5, 1)):
            array = numpy.arange(numpy.prod(shape), dtype="uint16").reshape(shape).copy()
            for copy in (None, False):
                volume = velum.Volume(array, copy=copy)
                self.assertTrue(numpy.shares_memory(volume.array, array))
                numpy.testing.assert_array_equal(volume.array, array)
            with self.assertRaisesRegex(ValueError, "read-only"):
                array[0] = 7
        array = ball()
        with velum.open(array, copy=False) as session:
            self.assertTrue(numpy.shares_memory(session.voxels.array, array))

    def test_what_lies_otherwise_is_copied(self):
        array = numpy.arange(6 * 8 * 10, dtype="int16").reshape(6, 8, 10).copy()
        shifted = numpy.frombuffer(bytearray(8 * 24 + 1), "float64", 24, offset=1).reshape(2, 3, 4)
        rows = [(array[::-1], "one after"), (array.T, "one after"), (array[:, ::2], "one after"), (numpy.broadcast_to(array[0], (3, 8, 10)), "one after"),
                (array.astype(">i2"), "byte order"), (array.astype("float16"), "type"), (array > 3, "type"), (shifted, "aligned"),
                (array[1:3], "larger array"), (numpy.frombuffer(bytearray(24), "uint8").reshape(2, 3, 4), "numpy's")]
        for given, reason in rows:
            with self.subTest(reason=reason):
                was = given.flags.writeable
                volume = velum.Volume(given)
                self.assertFalse(numpy.shares_memory(volume.array, given))
                numpy.testing.assert_array_equal(volume.array, given)
                self.assertEqual(given.flags.writeable, was)
                with self.assertRaisesRegex(velum.ArgumentError, f"^copy=False: .*{reason}"):
                    velum.Volume(given, copy=False)
        self.assertTrue(array.flags.writeable)

    def test_copies_on_request_stay_ones_own(self):
        array = ball()
        volume = velum.Volume(array, copy=True)
        array[:] = 7
        self.assertEqual(volume.range, (0, 1000))
        numpy.testing.assert_array_equal(volume.array, ball())
        labels = ball(inside=3)
        held = velum.Labels(labels)
        labels[:] = 0  # labels are always converted
        numpy.testing.assert_array_equal(held.array, ball(inside=3))

    def test_what_an_array_is_a_view_of_is_locked_too(self):
        flat = numpy.arange(4 * 5 * 6, dtype="float32")
        volume = velum.Volume(flat.reshape(4, 5, 6))
        self.assertTrue(numpy.shares_memory(volume.array, flat))
        self.assertFalse(flat.flags.writeable)
        class Other(numpy.ndarray):
            pass

        other = ball().view(Other)
        with velum.open(other, copy=False), self.assertRaisesRegex(ValueError, "read-only"):
            other[0] = 7
        still = numpy.arange(6 * 8 * 10, dtype="int16").reshape(6, 8, 10)[2:4]
        still.base.flags.writeable = False  # a part of what nobody can write to
        self.assertTrue(numpy.shares_memory(velum.Volume(still, copy=False).array, still))

    def test_files_that_are_mapped_are_not_read_into_memory(self):
        numpy.save(self.folder / "ball.npy", numpy.stack([ball(), ball()]))
        for mode in ("r", "r+", "c"):
            mapped = numpy.load(self.folder / "ball.npy", mmap_mode=mode)
            volume = velum.Volume(mapped.reshape(64, 32, 32), copy=False)
            self.assertTrue(numpy.shares_memory(volume.array, mapped))
        half = numpy.load(self.folder / "ball.npy", mmap_mode="r")[1]
        with velum.open(half, copy=False) as session:
            del half
            numpy.testing.assert_array_equal(session.voxels.array, ball())
            self.assertEqual(session.render(48, 36, samples=1).shape, (36, 48, 3))

    def test_an_array_is_kept_as_long_as_its_volume(self):
        for where in ("volume", "session", "array"):
            with self.subTest(where=where):
                array = ball()
                gone = weakref.ref(array)
                kept = velum.Volume(array)
                if where == "session":
                    kept = velum.open(kept)
                    kept.cut("plane")
                    kept.render(48, 36, samples=1)
                elif where == "array":
                    kept = kept.array
                del array
                gc.collect()
                self.assertFalse(gone() is None)
                numpy.testing.assert_array_equal(kept.voxels.array if where == "session" else kept, ball())
                if where == "session":
                    kept.open(self.sample())
                    kept.render(48, 36, samples=1)  # the session's own thread lets go
                    self.assertTrue(gone() is None)
                    kept.close()
                del kept
                gc.collect()
                self.assertTrue(gone() is None)
        array = ball()
        count = sys.getrefcount(array)
        for _ in range(3):
            with velum.open(array, unit="HU") as session:
                session.labels = array > 3
        gc.collect()
        self.assertEqual(sys.getrefcount(array), count)

    def test_the_end_of_python_with_arrays_in_use(self):
        said = self.run_python("""
import numpy, velum, threading
array = numpy.zeros((8, 8, 8), "uint8")
array[2:5] = 9
volume = velum.Volume(array)
s = velum.open(volume)
t = velum.open(array[:])
threading.Thread(target=t.close).start()
s.cut("plane")
print("end")
""")
        self.assertEqual(said, "end\n")

    def test_units_of_length_are_those_of_files(self):
        for name, factor in (("mm", 1), ("millimeter", 1), ("um", 1e-3), ("\u00b5m", 1e-3), ("micron", 1e-3), ("nm", 1e-6), ("nanometre", 1e-6), ("cm", 10), ("m", 1000), ("meters", 1000)):
            volume = velum.Volume(ball(), spacing=(1, 2, 3), origin=(4, 5, 6), lengthUnit=name)
            self.assertEqual(volume.lengthUnit, "mm")
            numpy.testing.assert_allclose(volume.affine, [[factor, 0, 0, 4 * factor], [0, 2 * factor, 0, 5 * factor], [0, 0, 3 * factor, 6 * factor], [0, 0, 0, 1]],
                                          rtol=1e-12)
            labels = velum.Labels(ball(inside=1), spacing=(1, 2, 3), origin=(4, 5, 6), lengthUnit=name)
            numpy.testing.assert_array_equal(labels.affine, volume.affine)
        for name in ("angstrom", "\u00c5"):
            volume = velum.Volume(ball(), spacing=(1, 2, 3), lengthUnit=name)
            self.assertEqual((volume.lengthUnit, volume.spacing), ("angstrom", (1, 2, 3)))
        with velum.open(ball(), spacing=(4, 4, 40), lengthUnit="nm") as session:
            session.labels = ball(inside=1)
            volume = session.measure(structures=True)["structures"][0]["volume"]
            self.assertEqual((session["unit"], volume["unit"]), ("mm", "nm\u00b3"))
            numpy.testing.assert_allclose(volume["value"], (ball() > 0).sum() * 4 * 4 * 40)

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
                ((ball(),), {"lengthUnit": "ell"}, "ell"), ((ball(),), {"lengthUnit": 5}, "lengthUnit 5"), ((ball(),), {"name": b"x"}, "name"),
                ((ball(),), {"spacing": "wide"}, "three numbers"), ((ball(),), {"timeStepSeconds": "long"}, "a number"), ((ball(),), {"modality": "X"}, "modality"), ((ball(),), {"color": True}, "colours")]
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
                                   (ball(), {"names": {0: "x"}}, "0 is no label"), (ball(), {"colors": {5: (1, 0, 0)}}, "5"),
                                   (ball(inside=3), {"colors": {3: (1, 0, 0, 1)}}, "red, green and blue"), (ball(inside=3), {"names": {"a": "b"}}, "a whole number"),
                                   (ball(inside=3), {"names": {3: 5}}, "a text"), (numpy.zeros((3, 3), "uint8"), {}, "shape")):
            with self.subTest(word=word), self.assertRaises(velum.ArgumentError) as caught:
                velum.Labels(array, **named)
            self.assertIn(word, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))

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
