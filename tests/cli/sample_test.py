"""velum-batch sample."""
import pathlib
import re
import unittest

from velum_cli import CliTest


class Sample(CliTest):
    def names(self):
        said = self.run_batch("sample", "--help").stdout.decode()
        found = re.search(r"((?:[a-z-]+, )+[a-z-]+)", said[said.index("Positionals"):].replace("\n", " "))
        return [name for name in re.split(r",\s+", found.group(1)) if name not in ("virion", "brain")]  # a model, and a store

    def test_every_name_makes_a_volume_with_labels(self):
        names = self.names()
        self.assertGreaterEqual(len(names), 7)
        for name in names:
            with self.subTest(name=name):
                report = self.report("sample", name, "-o", f"out/{name}.nrrd", "--voxels", "32")
                self.assertEqual(report["name"], name)
                self.assertEqual(len(report["files"]), 2)
                volume, labels = (self.report("info", file) for file in report["files"])
                self.assertEqual(volume["kind"], "volume")
                self.assertEqual(labels["kind"], "labels")
                self.assertEqual(volume["dims"], labels["dims"])
                self.assertGreater(len(labels["structures"]), 0)

    def test_a_virion_is_a_model(self):
        report = self.report("sample", "virion", "-o", "out")
        self.assertEqual([pathlib.Path(file).name for file in report["files"]], ["virion.cif"])
        model = self.report("info", report["files"][0])
        self.assertEqual(model["kind"], "model")
        self.assertGreaterEqual(model["types"], 20)
        lipids = sum(row["instances"] for row in model["perType"] if row["kind"] == "lipid")
        self.assertGreaterEqual(model["instances"] - lipids, 20000)
        self.refuse("sample", "virion", "-o", "a.cif", "--voxels", "32", code=1)
        self.refuse("sample", "virion", "-o", "a.nrrd", code=1)

    def test_a_brain_is_a_store_of_any_size(self):
        report = self.report("sample", "brain", "-o", "out", "--voxels", "200")
        self.assertEqual([pathlib.Path(file).name for file in report["files"]], ["brain.ome.zarr"])
        brain = self.report("info", report["files"][0])
        self.assertEqual(brain["dims"], [154, 200, 115])
        self.assertGreaterEqual(len(brain["levels"]), 2)
        self.refuse("sample", "brain", "-o", "a.nrrd", code=1)
        self.refuse("sample", "brain", "-o", "a.ome.zarr", "--voxels", "20", code=1)
        self.refuse("sample", "brain", "-o", "b.ome.zarr", "--time-steps", "2", code=1)

    def test_labels_are_nifti_where_the_volume_is(self):
        for suffix, of_labels in ((".nii", ".nii"), (".nii.gz", ".nii.gz"), (".vti", ".seg.nrrd")):
            report = self.report("sample", "two-spheres", "-o", "x" + suffix, "--voxels", "24")
            self.assertEqual([pathlib.Path(file).name for file in report["files"]], ["x" + suffix, "x_labels" + of_labels])

    def test_the_same_name_and_size_give_the_same_bytes(self):
        for name in ("a.nrrd", "b.nrrd"):
            self.run_batch("sample", "vessels", "-o", name, "--voxels", "40")
        self.assertEqual((self.folder / "a.nrrd").read_bytes(), (self.folder / "b.nrrd").read_bytes())

    def test_a_heart_has_as_many_time_steps_as_asked_for(self):
        for suffix in (".nrrd", ".nii.gz"):
            report = self.report("sample", "heart", "-o", "beat" + suffix, "--voxels", "24", "--time-steps", "3")
            volume, labels = (self.report("info", file) for file in report["files"])
            self.assertEqual(volume["frames"], 3)
            self.assertAlmostEqual(volume["frameSeconds"], 0.28, places=5)
            self.assertEqual(volume["dims"], labels["dims"])
        self.refuse("sample", "torso", "-o", "x.nrrd", "--voxels", "24", "--time-steps", "3", code=1, words=["torso", "3"])
        self.refuse("sample", "heart", "-o", "x.nrrd", "--time-steps", "1000", code=1, words=["1000"])
        self.refuse("sample", "heart", "-o", "x.vti", "--voxels", "24", code=2, words=["time step"])

    def test_unknown_names_and_sizes_exit_1(self):
        self.assertIn("torso", self.refuse("sample", "nothing", "-o", "x.nrrd", code=1, words=["nothing"]))
        for voxels in ("3", "-1", "100000"):
            self.refuse("sample", "torso", "-o", "x.nrrd", "--voxels", voxels, code=1, words=[voxels])


if __name__ == "__main__":
    unittest.main()
