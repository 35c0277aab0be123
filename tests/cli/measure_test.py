"""velum-batch measure."""
import csv
import io
import json
import math
import unittest

from velum_cli import CliTest


class Measure(CliTest):
    def table(self, *arguments):
        done = self.run_batch("measure", *arguments, "-o", "-")
        self.assertTrue(done.stdout.endswith(b"\r\n"))
        return list(csv.DictReader(io.StringIO(done.stdout.decode(), newline="")))

    def test_marks_of_the_command_line(self):
        path = self.sample()
        rows = self.table(path, "--mark", 'distance points=0,0,0;3,4,0 text="Width, or so"', "--mark",
                          "circle points=0,0,0;9,0,0", "--mark", "angle points=50,0,0;0,0,0;0,50,0")
        self.assertEqual([row["kind"] for row in rows], ["distance", "circle", "angle"])
        self.assertEqual(rows[0]["name"], "Width, or so")
        self.assertEqual((float(rows[0]["value"]), rows[0]["unit"]), (5.0, "mm"))
        self.assertGreater(int(rows[1]["voxels"]), 10)
        self.assertEqual(float(rows[2]["value"]), 90.0)
        self.assertIn(b"distance 1 Width, or so: 5 mm", self.run_batch(
            "measure", path, "--mark", 'distance points=0,0,0;3,4,0 text="Width, or so"').stdout)

    def test_marks_of_a_scene(self):
        path = self.sample()
        marks = [{"id": 4, "kind": "distance", "points": [[0, 0, 0], [0, 0, 7]]},
                 {"id": 9, "kind": "profile", "points": [[-20, 0, 0], [20, 0, 0]]}]
        sets = ["--set", f"lettering.marks={json.dumps(marks)}"]
        rows = self.table(path, *sets, "--profiles", "p.csv")
        self.assertEqual([row["id"] for row in rows], ["4", "9"])
        with open(self.folder / "p.csv", newline="") as file:
            samples = list(csv.DictReader(file))
        self.assertGreater(len(samples), 20)
        self.assertEqual({s["mark"] for s in samples}, {"9"})
        self.assertAlmostEqual(float(samples[-1]["distance"]), 40.0)
        self.run_batch("measure", path, *sets, "-o", "t.json")
        report = json.loads((self.folder / "t.json").read_text())
        self.assertEqual(report["marks"][0]["length"], {"value": 7.0, "unit": "mm"})
        self.assertEqual(len(report["marks"][1]["profile"]), len(samples))
        self.assertEqual(self.report("measure", path, *sets), report)

    def test_structures_and_faces_honour_cuts(self):
        path = self.sample(voxels=64)
        labels = self.folder / "two-spheres_labels.seg.nrrd"
        whole = self.table("--labels", labels, "--structures")
        self.assertGreaterEqual(len(whole), 2)
        self.assertEqual({row["share"] for row in whole}, {"100.00"})
        cut = ["--set", 'cuts=[{"id": 3, "shape": "plane", "axis": [0, 0, 1], "centre": [0, 0, 0]}]']
        rows = self.table("--labels", labels, *cut, "--structures", "--faces")
        left = {row["id"]: float(row["value"]) for row in rows if row["kind"] == "structure"}
        for row in whole:
            self.assertLess(left[row["id"]], float(row["value"]))
        faces = [row for row in rows if row["kind"] == "face"]
        self.assertTrue(faces)
        self.assertEqual({row["id"] for row in faces}, {"3"})
        self.assertGreater(min(float(row["value"]) for row in faces), 0.0)

    def test_bad_words_are_one_line(self):
        path = self.sample()
        self.refuse("measure", path, code=1, words=["--mark"])
        self.refuse("measure", path, "--mark", "distanse points=0,0,0;1,0,0", code=1, words=["distance"])
        self.refuse("measure", path, "--mark", "distance points=0,0;1,0,0", code=1, words=["--mark"])
        self.refuse("measure", path, "--mark", "distance points=0,0,0", code=1, words=["2 points"])
        self.refuse("measure", path, "--mark", "distance place=0,0,0", code=1, words=["points"])
        self.refuse("measure", path, "--mark", "region", code=1, words=["structure"])
        self.refuse("measure", path, "--mark", "distance points=0,0,0;1,0,nan", code=1, words=["--mark"])
        self.refuse("measure", path, "--structures", code=2, words=["labels"])
        self.refuse("measure", path, "--mark", "distance points=0,0,0;1,0,0", "-o", "x.txt", code=2, words=[".csv or .json"])
        self.refuse("measure", path, "--mark", "distance points=0,0,0;1,0,0", "-o", "no/such/x.csv", code=2)
        self.refuse("measure", "absent.nrrd", "--structures", code=2, words=["absent.nrrd"])

    def test_what_cannot_be_measured_says_why(self):
        rows = self.table(self.sample(), "--mark", "circle points=900,0,0;901,0,0")
        self.assertTrue(rows[0]["problem"])
        self.assertEqual(rows[0]["voxels"], "")

    def test_models_are_told_in_nanometres(self):
        self.run_batch("sample", "virion", "-o", "v.cif.gz")
        rows = self.table("v.cif.gz", "--mark", "distance points=0,0,0;100,0,0")
        self.assertEqual((float(rows[0]["value"]), rows[0]["unit"]), (10.0, "nm"))


if __name__ == "__main__":
    unittest.main()
