"""velum-batch render and bench."""
import json
import pathlib
import re
import struct
import unittest

from velum_cli import CliTest

# Light costs seconds on a software driver and most tests here are not about it.
FAST = ["--samples", "1", "--set", "lighting.shaded=false"]
PNG = b"\x89PNG\r\n\x1a\n"


class Render(CliTest):
    def test_report_and_picture(self):
        report = self.report("render", self.sample(), "-o", "x.png", "--size", "60x40", *FAST)
        self.assertKeys(report, "renderer", "size", "frameMs", "samples")
        self.assertEqual(report["size"], [60, 40])
        data = (self.folder / "x.png").read_bytes()
        self.assertTrue(data.startswith(PNG))
        self.assertEqual(struct.unpack(">II", data[16:24]), (60, 40))

    def test_a_variable_says_how_to_draw(self):
        path = self.sample()
        for kind, library in (("egl", "libEGL"), ("osmesa", "libOSMesa")):
            said = self.folder / f"libraries-{kind}"
            self.run_batch("render", path, "-o", f"{kind}.png", "--size", "60x40", *FAST,
                           env={"VELUM_CONTEXT": kind, "LD_DEBUG": "libs", "LD_DEBUG_OUTPUT": said})
            begun = "".join(file.read_text() for file in self.folder.glob(f"{said.name}.*"))
            loaded = set(re.findall(r"calling init: .*/(libEGL|libOSMesa)\.so", begun))
            self.assertEqual(loaded, {library})
        self.run_batch("compare", "egl.png", "osmesa.png", "--max-diff", "2", "--max-fraction", "0")
        done = self.run_batch("render", path, "-o", "x.png", code=1, env={"VELUM_CONTEXT": "vulkan"})
        self.assertRegex(done.stderr, rb"VELUM_CONTEXT: 'vulkan' is not one of auto, egl, osmesa")

    def test_stdout_is_the_same_picture(self):
        path = self.sample()
        done = self.run_batch("render", path, "-o", "-", "--size", "48x48", *FAST)
        self.assertTrue(done.stdout.startswith(PNG))
        self.run_batch("render", path, "-o", "x.png", "--size", "48x48", *FAST)
        (self.folder / "y.png").write_bytes(done.stdout)
        self.run_batch("compare", "x.png", "y.png", "--max-diff", "0", "--max-fraction", "0")
        with_report = self.run_batch("render", path, "-o", "-", "--size", "48x48", "--json", *FAST)
        self.assertTrue(with_report.stdout.startswith(PNG))
        self.assertKeys(json.loads(with_report.stderr), "renderer", "samples")

    def test_pictures_of_every_format_keep_the_camera_of_their_scene(self):
        small = ["--size", "48x48"]
        self.run_batch("render", self.sample(), "-o", "a.png", "--view", "left", *small, *FAST)
        for name in ("b.tif", "c.PNG", "d.exr"):
            with self.subTest(name=name):
                self.run_batch("render", "a.png", "-o", name, *small)
                self.run_batch("render", name, "-o", "again.png", *small)
                self.run_batch("compare", "a.png", "again.png", "--max-diff", "0", "--max-fraction", "0")

    def test_layers_are_in_an_exr_whatever_the_case_of_its_ending(self):
        path = self.sample()
        for name in ("x.exr", "y.EXR"):
            self.run_batch("render", path, "-o", name, "--layers", "--size", "48x48", *FAST)
        # The header names the channels.
        self.assertEqual((self.folder / "x.exr").read_bytes()[:400], (self.folder / "y.EXR").read_bytes()[:400])

    def test_a_finish_takes_ones_own_paper(self):
        path = self.sample()
        small = ["--size", "48x48", *FAST]
        self.run_batch("render", path, "-o", "paper.png", *small, "--set", "background.top=1,0,0", "--set", "background.bottom=0,0,1")
        self.run_batch("render", path, "-o", "plain.png", *small)
        self.run_batch("render", path, "-o", "own.png", *small, "--set", "finish.paper=paper.png", "--save-scene", "scene.json")
        self.run_batch("compare", "plain.png", "own.png", code=4)
        finish = json.loads((self.folder / "scene.json").read_text())["finish"]
        self.assertEqual((finish["paper"], finish["ownPaper"]["source"]["path"]), ("own", "paper.png"))
        self.run_batch("render", "scene.json", "-o", "again.png", "--size", "48x48")
        self.run_batch("compare", "own.png", "again.png", "--max-diff", "0", "--max-fraction", "0")
        for name, code in (("gone.png", 2), (path, 2), ("crayon", 1), ("own", 1)):
            with self.subTest(paper=name):
                self.refuse("render", path, "-o", "x.png", *small, "--set", f"finish.paper={name}", code=code)
        self.assertFalse((self.folder / "x.png").exists())

    def test_the_same_command_gives_the_same_bytes(self):
        path = self.sample()
        for name in ("a.png", "b.png"):
            self.run_batch("render", path, "-o", name, "--size", "64x48", *FAST)
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_a_grey_window_has_a_name_or_numbers(self):
        path = self.sample("torso", 48)
        common = ["render", path, "--section", "axial", "--size", "70x50", "--save-scene", "s.json"]
        for window, level, width in (("lung", -600, 1500), ("400,50", 50, 400), ("W 1500 L -600", -600, 1500)):
            self.run_batch(*common, "-o", "a.png", "--window", window)
            volume = json.loads((self.folder / "s.json").read_text())["volume"]
            self.assertEqual((volume["windowLevel"], volume["windowWidth"]), (level, width))
        self.refuse(*common, "-o", "b.png", "--window", "spleen", code=1, words=["spleen", "abdomen"])
        self.refuse(*common, "-o", "b.png", "--window", "suv-5", code=1, words=["SUVbw", "HU"])
        self.refuse(*common, "-o", "b.png", "--window", "0,50", code=1, words=["0,50", "width and level"])

    def test_a_section_is_a_picture_of_its_scene(self):
        path = self.sample()
        section_options = ["--section", "coronal", "--size", "70x50", "--set", "cuts.+.axis=0,0,1"]
        report = self.report("render", path, "-o", "x.png", *section_options)
        self.assertKeys(report, "section", "crosshair", "size", "frameMs")
        self.run_batch("render", "x.png", "-o", "y.png", "--section", "coronal", "--size", "70x50")
        self.assertEqual((self.folder / "x.png").read_bytes(), (self.folder / "y.png").read_bytes())
        self.run_batch("render", path, "-o", "z.png", *section_options, "--set", "sections.crosshair=0,20,0")
        self.run_batch("compare", "x.png", "z.png", code=4)

    def test_a_picture_opens_as_its_scene(self):
        path = self.sample("torso", 40)
        for first, second in (("x.png", "y.png"), ("x.exr", "y.exr")):
            with self.subTest(first=first):
                self.run_batch("render", path, "-o", first, "--size", "64x64", "--preset", "ct-skin", "--view", "oblique", *FAST,
                               "--set", "cuts.+.axis=0.3,-1,0", "--set", "rayCast.samplesPerPixel=2")
                self.run_batch("render", first, "-o", second, "--size", "64x64")
                self.run_batch("compare", first, second, "--max-diff", "0", "--max-fraction", "0")
                self.assertEqual((self.folder / first).read_bytes(), (self.folder / second).read_bytes())

    def test_a_saved_scene_travels_with_its_data(self):
        data = self.folder / "a"
        data.mkdir()
        self.sample(file="a/two-spheres.nrrd")
        self.run_batch("render", "a/two-spheres.nrrd", "-o", "x.png", "--size", "48x48", "--save-scene", "a/scene.json", *FAST)
        scene = json.loads((data / "scene.json").read_text())
        self.assertEqual(scene["volume"]["source"]["path"], "two-spheres.nrrd")
        data.rename(self.folder / "b")
        self.run_batch("render", "b/scene.json", "-o", "y.png", "--size", "48x48")
        self.run_batch("compare", "x.png", "y.png", "--max-diff", "0", "--max-fraction", "0")

    def test_a_view_that_is_asked_for_goes_before_the_scenes(self):
        path = self.sample()
        self.run_batch("render", path, "-o", "left.png", "--size", "48x48", "--view", "left", "--save-scene", "scene.json", *FAST)
        self.run_batch("render", path, "-o", "above.png", "--size", "48x48", "--view", "superior", *FAST)
        self.run_batch("render", "scene.json", "-o", "again.png", "--size", "48x48")
        self.run_batch("render", "scene.json", "-o", "moved.png", "--size", "48x48", "--view", "superior")
        self.run_batch("compare", "left.png", "again.png", "--max-diff", "0", "--max-fraction", "0")
        self.run_batch("compare", "above.png", "moved.png", "--max-diff", "0", "--max-fraction", "0")
        self.run_batch("compare", "left.png", "above.png", code=4)

    def test_brute_force_is_the_same_picture(self):
        path = self.sample("vessels", 48)
        self.run_batch("render", path, "-o", "fast.png", "--size", "64x64", *FAST)
        self.run_batch("render", path, "-o", "slow.png", "--size", "64x64", "--brute-force", *FAST)
        self.run_batch("compare", "fast.png", "slow.png", "--max-diff", "1", "--max-fraction", "0")

    def test_layers_lie_beside_or_in_the_exr(self):
        path = self.sample()
        self.run_batch("render", path, "-o", "x.png", "--size", "32x32", "--layers", *FAST)
        for layer in ("alpha", "normal", "depth", "id", "position"):
            self.assertTrue((self.folder / f"x.{layer}.png").exists(), layer)
        self.run_batch("render", path, "-o", "x.exr", "--size", "32x32", "--layers", *FAST)
        data = (self.folder / "x.exr").read_bytes()
        for channel in (b"position.X", b"normal.Z", b"id", b"instance", b"Z"):
            self.assertIn(channel, data[:4000])

    def test_an_inlay_has_layers_to_put_together(self):
        self.sample("two-spheres", 32)
        self.run_batch("membrane", "two-spheres.nrrd", "--protect", "500,2000", "--axis", "0,0,1", "--save-scene", "m.json")
        look = ["--size", "32x32", "--layers", "--set", "cuts[Membrane].membrane.use=inlay", *FAST]
        self.run_batch("render", "m.json", "-o", "x.png", *look)
        for layer in ("front", "inlay", "behind"):
            self.assertEqual((self.folder / f"x.{layer}.png").read_bytes()[25], 6, f"{layer}: PNG colour type RGBA")
        self.run_batch("render", "m.json", "-o", "x.exr", *look)
        self.assertIn(b"inlay.A", (self.folder / "x.exr").read_bytes()[:4000])

    def test_a_structure_is_called_by_its_name_or_id(self):
        path = self.sample()
        self.run_batch("render", path, "two-spheres_labels.seg.nrrd", "-o", "x.png", "--size", "24x24", "--save-scene", "s.json",
                       *FAST, "--set", "labels.structures[lower sphere].visible=false", "--set", "labels.structures[1].opacity=0.5",
                       "--set", "cuts.+.name=my cut", "--set", "cuts[my cut].spares=2")
        scene = json.loads((self.folder / "s.json").read_text())
        by_name = {row["name"]: row for row in scene["labels"]["structures"]}
        self.assertFalse(by_name["lower sphere"]["visible"])
        self.assertEqual([row["opacity"] for row in by_name.values() if row["id"] == 1], [0.5])
        self.assertEqual(scene["cuts"][0]["spares"], [{"structure": 2, "distance": None}])
        self.refuse("render", path, "two-spheres_labels.seg.nrrd", "-o", "x.png", "--set", "labels.structures[liver].visible=false",
                    code=1, words=["labels.structures", "liver", "lower sphere"])

    def test_labels_and_surfaces_join_the_volume(self):
        path = self.sample("torso", 40)
        (self.folder / "a.obj").write_text("v -40 0 -40\nv 40 0 -40\nv 0 0 40\nf 1 2 3\n")
        self.run_batch("render", path, "torso_labels.seg.nrrd", "a.obj", "-o", "x.png", "--size", "48x48", *FAST)
        self.run_batch("render", path, "-o", "y.png", "--size", "48x48", *FAST)
        self.run_batch("compare", "x.png", "y.png", code=4)

    def test_transparent_has_an_alpha_channel(self):
        self.run_batch("render", self.sample(), "-o", "x.png", "--size", "32x32", "--transparent", *FAST)
        self.assertEqual((self.folder / "x.png").read_bytes()[25], 6, "PNG colour type RGBA")

    def test_an_output_that_cannot_be_written_exits_2(self):
        path = self.sample()
        self.refuse("render", path, "-o", "none/x.png", "--size", "16x16", code=2, words=["none"])
        self.refuse("render", path, "-o", "x.gif", "--size", "16x16", code=2, words=["x.gif"])

    def test_an_output_that_cannot_be_written_is_refused_before_anything_is_read(self):
        # What is named to be read is not there: so nobody has looked for it.
        gone = "gone.nrrd"
        (self.folder / "x.png").mkdir()
        for arguments in (
                ["render", gone, "-o", "x.bmp"], ["render", gone, "-o", "none/y.png"], ["render", gone, "-o", "x.png"],
                ["film", gone, "-o", "x.bmp"], ["film", gone, "-o", "none/y.exr"],
                ["render", gone, "-o", "x.bmp", "--section", "axial"], ["render", gone, "-o", "y.png", "--save-scene", "none/s.json"],
                ["compare", "a.png", "b.png", "--diff", "x.bmp"], ["compare", "a.png", "b.png", "--diff", "none/d.png"],
                ["convert", gone, "x.bmp"], ["convert", gone, "none/y.nrrd"], ["convert", gone, "none/y.stl"],
                ["grow", gone, "--seed", "0,0,0", "-o", "x.bmp"], ["grow", gone, "--seed", "0,0,0", "-o", "none/y.nrrd"],
                ["membrane", gone, "--sheet", "x.bmp"], ["membrane", gone, "--sheet", "none/y.ply"],
                ["membrane", gone, "--clipped", "x.bmp"], ["membrane", gone, "--save-scene", "none/s.json"],
                ["count", gone, "--csv", "none/y.csv"], ["count", gone, "--svg", "none/y.svg"], ["count", gone, "-o", "none/s.json"],
                ["sample", "torso", "-o", "x.bmp", "--voxels", "1024"]):
            with self.subTest(arguments=arguments):
                output = next(word for word in arguments if word.startswith(("x.", "none/")))
                said = self.refuse(*arguments, code=2, words=output.split("."))
                self.assertNotIn(gone, said)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["x.png"], "leftovers")

    def test_cuts_that_leave_nothing_say_so_in_one_line(self):
        path = self.sample()
        for z, lines in ((0, []), (-1000, [b"warning: The cuts leave nothing of what the scene shows: flip a cut, move it, or turn it off"])):
            with self.subTest(z=z):
                done = self.run_batch("render", path, "-o", "x.png", "--size", "16x16", *FAST,
                                      "--set", "cuts.+.axis=0,0,1", "--set", f"cuts.0.centre=0,0,{z}")
                self.assertEqual(done.stderr.splitlines(), lines)

    def test_a_picture_without_a_scene_exits_2(self):
        self.run_batch("render", self.sample(), "-o", "x.png", "--size", "16x16", *FAST)
        self.run_batch("compare", "x.png", "x.png", "--diff", "d.png")
        self.refuse("render", "d.png", "-o", "y.png", code=2, words=["d.png", "scene"])

    def test_a_scene_file_that_is_none_exits_2(self):
        for name, text in (("a.json", "{"), ("b.json", "{}"), ("c.json", '{"velum": 99}'), ("d.json", '{"velum": 1, "camera": 5}'),
                           ("e.json", '{"velum": 1, "volume": {"source": {"path": "none.nrrd"}}}')):
            pathlib.Path(self.folder / name).write_text(text)
            self.refuse("render", name, "-o", "x.png", code=2)

    def test_bench_reports_times(self):
        report = self.report("bench", self.sample(), "--frames", "2", "--size", "48x32", "--set", "lighting.shaded=false")
        self.assertKeys(report, "renderer", "frameMs", "passes")
        self.assertKeys(report["frameMs"], "min", "median", "max")
        self.assertLessEqual(report["frameMs"]["min"], report["frameMs"]["max"])

    def test_a_card_without_memory_exits_3_in_one_line_or_shows_less(self):
        path = self.sample("two-spheres", 96)
        command = ["render", path, "-o", "x.png", "--size", "32x32", *FAST]
        done = self.run_batch(*command, code=3, env={"VELUM_FAIL_ALLOCATION": "3+"})
        said = done.stderr.decode().splitlines()
        self.assertEqual(len(said), 1, said)
        self.assertIn("the driver has no memory for", said[0])
        self.assertFalse((self.folder / "x.png").exists())
        done = self.run_batch(*command, env={"VELUM_FAIL_ALLOCATION": ">1"})
        self.assertIn(b"of its resolution", done.stderr)

    def test_a_reduced_volume_says_so(self):
        path = self.sample("two-spheres", 64)
        done = self.run_batch("render", path, "-o", "x.png", "--size", "32x32", *FAST, env={"VELUM_MAX_TEXTURE_3D": "20"})
        self.assertIn(b"resolution", done.stderr)


if __name__ == "__main__":
    unittest.main()
