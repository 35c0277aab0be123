"""velum-batch membrane: what it reports, what it writes, what it refuses."""
import json
import unittest

from velum_cli import CliTest


class Membrane(CliTest):
    def test_reports_what_it_did(self):
        path = self.sample("two-spheres", 64)
        report = self.report("membrane", path, "--protect", "500,2000", "--axis", "0,0,1", "--limit")
        self.assertKeys(report, "rule", "kernels", "particles", "steps", "atRest", "stepMs", "cutAreaPlane", "cutAreaMembrane",
                        "ratio", "meanDistance", "limit", "limitMeanDistance")
        self.assertEqual(report["rule"], "sided")
        self.assertTrue(report["atRest"])
        self.assertGreater(report["cutAreaPlane"], 100)
        self.assertEqual(report["ratio"], 0)
        self.assertAlmostEqual(sum(report["shares"].values()), 1)
        self.assertEqual(report["shares"]["cut"], 0)
        # It hangs where both are kept; in the middle one is removed whole.
        self.assertGreater(report["protected"]["kept"], 0.99)
        self.assertAlmostEqual(sum(report["protected"].values()), 1)
        self.assertNotIn("advice", report)

    def test_says_what_is_removed_whole_and_what_would_keep_it(self):
        path = self.sample("two-spheres", 64)
        report = self.report("membrane", path, "--protect", "500,2000", "--axis", "0,0,1", "--position", "0.5", "--save-scene", "m.json")
        self.assertGreater(report["shares"]["kept"], 0.4)
        self.assertGreater(report["shares"]["removed"] + report["protected"]["removed"], 0)
        self.run_batch("membrane", path, "--protect", "500,2000", "--axis", "0,0,1", "--position", "0.05", "--save-scene", "lost.json")
        lost = self.report("membrane", "lost.json")
        self.assertGreater(lost["protected"]["removed"], 0.9)
        self.assertIn("moveToKeep", [step["step"] for step in lost["advice"]])
        for step in lost["advice"]:
            self.assertKeys(step, "step", "reason", "centre", "reach", "protected", "cut")
        self.assertIn("is removed whole", str(self.run_batch("membrane", "lost.json").stdout))
        moved = self.report("membrane", "lost.json", "--move", "--save-scene", "kept.json")
        self.assertGreater(moved["protected"]["kept"], 0.9)
        self.assertGreater(self.report("membrane", "kept.json")["protected"]["kept"], 0.9)
        self.assertEqual(self.report("membrane", "kept.json", "--reach", "33")["reach"], 33)
        self.refuse("membrane", "kept.json", "--reach", "0", code=1, words=["--reach"])

    def test_hangs_across_the_axis_that_is_asked_for(self):
        path = self.sample("two-spheres", 32)
        self.run_batch("membrane", path, "--axis", "2,0.6,-1", "--save-scene", "o.json")
        axis = json.loads((self.folder / "o.json").read_text())["cuts"][0]["axis"]
        for is_, wanted in zip(axis, (2, 0.6, -1)):
            self.assertAlmostEqual(is_, wanted / 5.36 ** 0.5, places=6)
        self.refuse("membrane", path, "--axis", "0,0,0", code=1, words=["--axis"])

    def test_told_nothing_it_keeps_what_the_scene_shows_most(self):
        report = self.report("membrane", self.sample("two-spheres", 32), "--axis", "0,0,1")
        self.assertGreater(report["cutAreaPlane"], 0)

    def test_either_rule(self):
        path = self.sample("two-spheres", 64)
        report = self.report("membrane", path, "--protect", "500,2000", "--axis", "0,0,1", "--rule", "paper")
        self.assertEqual(report["rule"], "paper")
        self.assertEqual(report["particles"], [50, 50])
        self.assertLess(report["ratio"], 0.2)

    def test_writes_sheet_volume_and_scene(self):
        path = self.sample("two-spheres", 48)
        self.run_batch("membrane", path, "--protect", "500,2000", "--axis", "0,0,1", "--sheet", "s.ply", "--clipped", "c.nrrd",
                       "--save-scene", "m.json")
        before, after = self.report("info", path), self.report("info", "c.nrrd")
        self.assertEqual(before["dims"], after["dims"])
        self.assertTrue((self.folder / "s.ply").stat().st_size > 1000)
        again = self.report("membrane", "m.json")
        self.assertLess(again["ratio"], 0.01)
        look = ["--size", "60x60", "--samples", "1"]
        self.run_batch("render", "m.json", "-o", "a.png", *look)
        self.run_batch("render", "m.json", "-o", "b.png", *look)
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())
        self.run_batch("render", "m.json", "-o", "plane.png", "--set", "cuts[Membrane].shape=plane", *look)
        self.run_batch("compare", "a.png", "plane.png", code=4)

    def test_pins_and_kernels_move_the_sheet(self):
        path = self.sample("two-spheres", 32)
        info = self.report("info", path)
        middle = [o + s * (n - 1) / 2 for o, s, n in zip(info["originMm"], info["spacingMm"], info["dims"])]
        edge = info["spacingMm"][2] * info["dims"][2]
        place = f"{middle[0]},{middle[1]},{middle[2] + 0.06 * edge}"

        def highest(*options):  # nothing is protected
            self.run_batch("membrane", path, "--protect", "5000,6000", *options, "--axis", "0,0,1", "--sheet", "s.obj", "--save-scene", "h.json")
            lines = (self.folder / "s.obj").read_text().splitlines()
            return max(float(line.split()[3]) for line in lines if line.startswith("v ")) - middle[2]

        self.assertAlmostEqual(highest("--pin", place), 0.06 * edge, delta=1e-4 * edge)
        self.assertGreater(highest("--kernel", f"{place},{0.1 * edge},-1000"), 0.04 * edge)
        below = f"{middle[0]},{middle[1]},{middle[2] - 0.03 * edge}"
        self.assertGreater(highest("--kernel", f"{below},{0.1 * edge},500", "--pin", below), -0.02 * edge)
        self.assertEqual(self.report("membrane", "h.json", "--pin", place)["name"], "Membrane")

    def test_without_a_word_it_protects_what_is_shown_most(self):
        self.assertGreater(self.report("membrane", self.sample("two-spheres", 32))["kernels"], 0)

    def test_strokes_protect_what_lies_under_them(self):
        path = self.sample("two-spheres", 64)
        info = self.report("info", path)
        # Along the middle of the volume, through both spheres; the brush spills into what is around them.
        middle = [o + 0.5 * (n - 1) * s for o, n, s in zip(info["originMm"], info["dims"], info["spacingMm"])]
        step = 0.4 * info["dims"][0] * info["spacingMm"][0]
        stroke = ":".join(f"{middle[0] + k * step / 4},{middle[1]},{middle[2]}" for k in range(-4, 5)) + "@3"
        report = self.report("membrane", path, "--sketch", stroke, "--axis", "0,0,1", "--save-scene", "s.json")
        self.assertGreater(report["cutAreaPlane"], 100)
        self.assertEqual(report["ratio"], 0)
        field = json.loads((self.folder / "s.json").read_text())["cuts"][0]["membrane"]["field"]
        self.assertEqual(len(field["strokes"]), 1)
        self.assertEqual(len(field["strokes"][0]["path"]), 9)
        self.assertEqual(field["strokes"][0]["radius"], 3)
        self.assertGreater(len(field["byValue"]), 1)
        # The same stroke avoids: of what the curve protects only blurred borders are left.
        whole = self.report("membrane", path, "--protect", "500,2000", "--axis", "0,0,1")
        rest = self.report("membrane", path, "--protect", "500,2000", "--avoid", stroke, "--axis", "0,0,1")
        self.assertLess(rest["cutAreaPlane"], 0.5 * whole["cutAreaPlane"])
        self.refuse("membrane", "s.json", "--avoid", stroke, code=1, words=["--avoid", "--sketch"])

    def test_specks_of_noise_do_not_count(self):
        path = self.sample("fibres", 64)
        values = ["--protect", "1300,60000", "--axis", "0,0,1", "--position", "0.5"]
        self.run_batch("membrane", path, *values, "--save-scene", "n.json")
        left = self.report("membrane", path, *values)["leftOut"]
        self.assertGreater(left["leastPiece"], 2)
        self.assertGreater(left["pieces"], 100)
        self.assertGreaterEqual(left["voxels"], left["pieces"])
        self.assertTrue(0 < left["share"] < 1)
        info = self.report("info", path)
        voxel = info["spacingMm"][0] * info["spacingMm"][1] * info["spacingMm"][2]
        self.assertAlmostEqual(left["leastPieceVolume"] / (left["leastPiece"] * voxel), 1, places=3)
        whole = self.report("membrane", "n.json", "--least-piece", "1", "--save-scene", "all.json")
        self.assertEqual(whole["leftOut"], {"leastPiece": 1, "leastPieceVolume": whole["leftOut"]["leastPieceVolume"],
                                            "pieces": 0, "voxels": 0, "share": 0})
        self.assertEqual(json.loads((self.folder / "all.json").read_text())["cuts"][0]["membrane"]["field"]["leastPiece"], 1)
        more = self.report("membrane", "all.json", "--least-piece", "40")["leftOut"]
        self.assertGreater(more["voxels"], left["voxels"])
        self.assertEqual(self.report("membrane", "all.json", "--least-piece", "auto")["leftOut"], left)
        self.assertIn("pieces of fewer than", str(self.run_batch("membrane", "n.json").stdout))
        for wrong in ("0", "2.5", "many"):
            self.refuse("membrane", path, "--least-piece", wrong, code=1, words=["--least-piece", "auto"])

    def test_a_streamed_volume_is_worked_out_in_the_voxels_of_its_finest_level(self):
        whole = self.sample("vessels", 160, "v.nrrd")
        self.run_batch("convert", whole, "v.ome.zarr")
        streamed = {"VELUM_WHOLE_MB": "1"}
        asked = ["--protect", "700,3000", "--axis", "0,0,1", "--position", "0.5", "--reach", "20", "--least-piece", "1"]
        reports = [self.report("membrane", file, *asked, "--limit", env=streamed) for file in ("v.nrrd", "v.ome.zarr")]
        self.assertGreater(reports[0]["cutAreaPlane"], 500)
        for key in ("level", "cutAreaPlane", "cutAreaMembrane", "ratio", "meanDistance", "limit", "particles"):
            self.assertEqual(reports[0][key], reports[1][key], key)
        self.assertEqual(reports[1]["level"], 0)
        self.assertIn("come from level 0 of 0 to", str(self.run_batch("membrane", "v.ome.zarr", *asked, env=streamed).stdout))
        # A picture of the scene waits for the finest, too.
        self.run_batch("membrane", "v.ome.zarr", *asked, "--save-scene", "m.json", env=streamed)
        self.run_batch("render", "m.json", "-o", "m.png", "--size", "64x48", env=streamed)
        # A store that lost a piece: one line.
        for shard in (self.folder / "v.ome.zarr" / "0").rglob("*"):
            if shard.is_file() and shard.stat().st_size > 5000:
                shard.write_bytes(shard.read_bytes()[:4000])
        done = self.run_batch("membrane", "v.ome.zarr", *asked, code=2, env=streamed)
        self.assertIn("v.ome.zarr", done.stderr.decode())

    def test_noise_is_taken_out_where_a_click_needs_it(self):
        path = self.sample("fibres", 64)
        values = ["--protect", "1200,60000", "--axis", "0,0,1", "--position", "0.5"]
        noisy = self.report("membrane", path, *values, "--least-piece", "1")["cutAreaPlane"]
        calm = self.report("membrane", path, *values, "--least-piece", "1", "--denoise")["cutAreaPlane"]
        self.assertNotEqual(noisy, calm)

    def test_refuses_with_words(self):
        path = self.sample("two-spheres", 32)
        self.refuse("membrane", path, "--pin", "1,2", code=1, words=["--pin", "x,y,z"])
        self.refuse("membrane", path, "--pin", "1,2,x", code=1, words=["--pin", "x,y,z"])
        self.refuse("membrane", path, "--pin", "9999,0,0", "--axis", "0,0,1", code=1, words=["--pin", "frame"])
        self.refuse("membrane", path, "--kernel", "1,2,3,0,5", code=1, words=["--kernel", "radius"])
        self.refuse("membrane", path, "--kernel", "1,2,3", code=1, words=["--kernel", "strength"])
        self.refuse("membrane", path, "--protect", "9,3", code=1, words=["--protect"])
        self.refuse("membrane", path, "--protect-at", "1000,0,0", code=1, words=["outside"])
        self.refuse("membrane", path, "--sketch", "1,2", code=1, words=["--sketch", "1,2", "x,y,z"])
        self.refuse("membrane", path, "--sketch", "1,2,3@0", code=1, words=["radius"])
        self.refuse("membrane", path, "--sketch", "1000,0,0@2", code=1, words=["outside"])
        self.refuse("membrane", path, "--protect", "9,30", "--sketch", "1,2,3@2", code=1, words=["--protect"])
        self.refuse("membrane", path, "--protect", "500,2000", "--sheet", "s.xyz", code=2, words=["s.xyz", ".ply"])
        self.refuse("membrane", "missing.nrrd", code=2, words=["missing.nrrd"])


if __name__ == "__main__":
    unittest.main()
