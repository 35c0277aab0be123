"""velum-batch info."""
import json
import struct
import unittest

from velum_cli import CliTest


class Info(CliTest):
    def test_says_what_a_volume_is(self):
        report = self.report("info", self.sample("torso", 48))
        self.assertKeys(report, "kind", "dims", "type", "spacingMm", "originMm", "direction", "range", "channels", "frames")
        self.assertEqual(report["kind"], "volume")
        self.assertEqual(max(report["dims"]), 48)
        self.assertEqual(len(report["direction"]), 9)
        self.assertLess(report["range"][0], report["range"][1])

    def test_a_raw_file_is_what_its_layout_says(self):
        (self.folder / "a.raw").write_bytes(bytes(7) + struct.pack(">24H", *range(24)))
        report = self.report("info", "a.raw", "--raw", "2x3x4:uint16:be:+7", "--spacing", "0.5,1,2")
        self.assertEqual(report["dims"], [2, 3, 4])
        self.assertEqual(report["type"], "uint16")
        self.assertEqual(report["range"], [0, 23])
        self.assertEqual(report["spacingMm"], [0.5, 1, 2])
        (self.folder / "b.raw").write_bytes(bytes(range(24)))
        for dims, kind, channels in (("2x2x2", "rgb", 3), ("3x2x1", "rgba", 4)):
            report = self.report("info", "b.raw", "--raw", f"{dims}:uint8:{kind}")
            self.assertEqual(report["channels"], channels)
            self.assertTrue(report["color"])

    def test_a_large_file_is_described_and_not_read(self):
        with open(self.folder / "large.raw", "wb") as file:
            file.truncate(1 << 36)
        report = self.report("info", "large.raw", "--raw", "4096x4096x2048:uint16")
        self.assertEqual(report["dims"], [4096, 4096, 2048])
        self.assertIsNone(report["range"])
        self.assertEqual(report["levels"][0]["bytes"], 1 << 36)
        said = self.run_batch("info", "large.raw", "--raw", "4096x4096x2048:uint16").stdout.decode()
        self.assertIn("range is not known", said)

    def test_labels_and_their_names(self):
        self.sample("torso", 48)
        report = self.report("info", "torso_labels.seg.nrrd")
        self.assertEqual(report["kind"], "labels")
        self.assertGreater(len(report["structures"]), 5)
        self.assertKeys(report["structures"][0], "id", "name", "color", "opacity", "voxels", "volumeMl", "surfaceCm2")

    def test_structures_have_volume_and_surface(self):
        self.sample("two-spheres", 64)  # of 26 mm radius
        for ball in self.report("info", "two-spheres_labels.seg.nrrd")["structures"]:
            self.assertAlmostEqual(ball["volumeMl"], 73.6, delta=0.8)
            self.assertAlmostEqual(ball["surfaceCm2"], 84.9, delta=2.5)

    def test_a_scan_with_labels_says_its_values_in_each_structure(self):
        scan = self.sample("torso", 48)
        report = self.report("info", scan, "torso_labels.seg.nrrd")
        self.assertEqual(report["kind"], "volume")
        labels = report["labels"]
        self.assertEqual(labels["valueUnit"], "HU")
        rows = {row["name"]: row for row in labels["structures"]}
        liver, fat = rows["liver"]["values"], rows["subcutaneous fat"]["values"]
        self.assertEqual(liver["voxels"], rows["liver"]["voxels"])
        for values in (liver, fat):
            self.assertLessEqual(values["min"], values["mean"])
            self.assertLessEqual(values["mean"], values["max"])
        self.assertLess(fat["mean"], 0)
        self.assertGreater(liver["mean"], 20)
        shown = self.run_batch("info", scan, "torso_labels.seg.nrrd").stdout.decode()
        self.assertRegex(shown, r"liver .* ml .* cm2  mean .* max .* HU")
        self.refuse("info", scan, "torso_labels.seg.nrrd", scan, code=1, words=["a scan and labels"])

    def test_a_scene_and_a_picture_give_their_scene(self):
        path = self.sample()
        self.run_batch("render", path, "-o", "a.png", "--size", "40x30", "--save-scene", "a.json")
        for name in ("a.png", "a.json"):
            report = self.report("info", name)
            self.assertEqual(report["kind"], "scene")
            self.assertIn("two-spheres", report["scene"]["volume"]["source"]["path"])

    def test_a_model(self):
        atom = "ATOM  {:>5}  CA  ALA A{:>4}    {:8.3f}   0.000   0.000  1.00  0.00           C\n"
        (self.folder / "a.pdb").write_text("".join(atom.format(i, i, 3.8 * i) for i in range(5)))
        report = self.report("info", "a.pdb")
        self.assertKeys(report, "kind", "types", "instances", "atoms", "bounds", "perType", "fibres", "added")
        self.assertEqual((report["kind"], report["types"], report["instances"], report["atoms"]), ("model", 1, 1, 5))
        self.assertKeys(report["perType"][0], "name", "path", "instances", "atoms", "mass")
        self.assertEqual(report["perType"][0]["mass"], 550)
        self.assertLess(report["bounds"][0][0], 0)
        self.assertGreater(report["bounds"][1][0], 15.2)
        self.assertIn("1 of 1 types", self.run_batch("info", "a.pdb").stdout.decode())
        (self.folder / "b.pdb").write_text(atom.format(1, 1, 1)[:40])
        self.refuse("info", "b.pdb", code=2)

    def test_a_surface(self):
        (self.folder / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        report = self.report("info", "a.obj")
        self.assertEqual((report["kind"], report["triangles"]), ("surface", 1))

    def test_the_colour_of_a_surface_is_taken_into_the_scene(self):
        points = "".join(f"{p} 255 51 0\n" for p in ("0 0 0", "1 0 0", "0 1 0"))
        axes = "".join(f"property float {a}\n" for a in "xyz")
        colours = "".join(f"property uchar {c}\n" for c in ("red", "green", "blue"))
        (self.folder / "a.ply").write_text(
            f"ply\nformat ascii 1.0\nelement vertex 3\n{axes}{colours}element face 1\n"
            f"property list uchar int vertex_indices\nend_header\n{points}3 0 1 2")
        for got, wanted in zip(self.report("info", "a.ply")["color"], (1, 0.2, 0)):
            self.assertAlmostEqual(got, wanted, 6)
        self.run_batch("render", "a.ply", "-o", "a.png", "--size", "40x30", "--save-scene", "a.json")
        scene = json.loads((self.folder / "a.json").read_text())
        for got, wanted in zip(scene["surfaces"][0]["color"], (1, 0.2, 0)):
            self.assertAlmostEqual(got, wanted, 6)

    def test_formats_and_presets(self):
        report = self.report("info", "--formats", "--presets")
        self.assertTrue(any(row["name"] == "NIfTI" for row in report["formats"]))
        self.assertTrue(any(row["name"] == "ct-bone" for row in report["presets"]))

    def test_for_people_it_is_text(self):
        said = self.run_batch("info", self.sample()).stdout.decode()
        for words in ("two-spheres: volume", "voxels", "32 x 32 x 32", " mm"):
            self.assertIn(words, said)
        with self.assertRaises(ValueError):
            json.loads(said)
        labels = self.run_batch("info", self.folder / "two-spheres_labels.seg.nrrd").stdout.decode()
        for words in ("labels", " ml", " cm2"):
            self.assertIn(words, labels)
        # Every number is one that people write.
        self.assertNotRegex(said + labels, r"\d\.\d+e[+-]\d|\d\.\d{6,}|null|\[")

    def test_a_name_that_is_no_utf8_still_gives_json(self):
        path = self.sample()
        strange = bytes(self.folder) + b"/caf\xe9.nrrd"
        with open(path, "rb") as a, open(strange, "wb") as b:
            b.write(a.read())
        import subprocess
        from velum_cli import PROGRAM
        done = subprocess.run([PROGRAM.encode(), b"info", strange, b"--json"], capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        json.loads(done.stdout)


if __name__ == "__main__":
    unittest.main()
