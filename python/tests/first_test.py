"""The lines that somebody types first, as they stand, on a phantom and on a patient's CT."""
import json
import os
import pathlib
import unittest
import zipfile

from support import PROGRAM, Case, numpy

import velum

DATA = pathlib.Path(os.environ.get("VELUM_TEST_DATA", ""))
DICOM = DATA / "volumes/ct_thorax_lidc0314_dicom.zip"

LINES = """
import velum
s = velum.open("ct/")
s.cut(shape="plane", axis=(0,-1,0))
s.protect(values=(200, 3000))
s.grow(seed=SEED, range=(200, 3000))
s["cuts[0].face"] = "section"
image = s.render(1280, 960)
layers = s.layers()
counts = s.count()
table = s.measure()
s.save()
"""


def seed_in(data):
    """A place whose value is of the range."""
    with velum.open(data) as s:
        voxels = s.voxels
    values = voxels.array * voxels.scale + voxels.offset
    inside = numpy.argwhere((values > 400) & (values < 2000))
    z, y, x = inside[len(inside) // 2]
    return tuple(float(part) for part in (voxels.affine @ [x, y, z, 1])[:3])


class First(Case):
    def setUp(self):
        super().setUp()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)

    def expect_lines_run(self, lines, data):
        names = {"SEED": seed_in(data)}
        exec(compile(lines, "first lines", "exec"), names)
        s, image, layers = names["s"], names["image"], names["layers"]
        self.addCleanup(s.close)
        self.assertEqual((image.shape, image.dtype), ((960, 1280, 3), numpy.uint8))
        self.assertGreater(image.std(), 5)
        self.assertEqual(s["cuts.0.face"], "section")
        self.assertEqual([cut["shape"] for cut in s["cuts"]], ["plane", "membrane"])
        self.assertEqual(layers["Z"].shape, (720, 1280))
        self.assertGreater(numpy.isfinite(layers["Z"]).mean(), 0.02)
        self.assertGreater((s.labels.array > 0).sum(), 100)
        self.assertGreater(sum(row["total"] for row in names["counts"]), 0)
        self.assertEqual(names["table"]["marks"], [])
        scene = json.loads(pathlib.Path("ct.json").read_text())
        self.assertEqual(scene["volume"]["source"]["path"], data.rstrip("/"))
        # What was saved opens again, and shows the same picture.
        with velum.open("ct.json") as again:
            numpy.testing.assert_array_equal(again.render(96, 72, samples=1), s.render(96, 72, samples=1))

    def test_on_a_phantom(self):
        self.run_program(PROGRAM, "sample", "torso", "-o", "ct.nrrd", "--voxels", 48)
        self.expect_lines_run(LINES.replace("ct/", "ct.nrrd"), "ct.nrrd")

    @unittest.skipUnless(DICOM.exists(), "set VELUM_TEST_DATA to the folder of test volumes")
    def test_on_a_patient(self):
        with zipfile.ZipFile(DICOM) as archive:
            archive.extractall("ct")
        self.expect_lines_run(LINES, "ct/")

    def test_a_file_that_nobody_named_is_not_written_over(self):
        pathlib.Path("ct.json").write_text("mine")
        with velum.open(self.sample()) as s:
            s.save()
            self.assertTrue(pathlib.Path("two-spheres.json").exists())
            s.save()  # where it was saved last
        pathlib.Path("two-spheres.json").write_text("mine")
        with velum.open("two-spheres.nrrd") as s, self.assertRaisesRegex(velum.InputError, "there already"):
            s.save()
        self.assertEqual(pathlib.Path("two-spheres.json").read_text(), "mine")
        with self.assertRaisesRegex(velum.ArgumentError, "path"):
            velum.Session().save()


if __name__ == "__main__":
    unittest.main()
