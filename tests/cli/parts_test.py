"""Pictures that several processes draw, each a part: velum-batch render --part."""
import shutil
import unittest

from velum_cli import CliTest

SIZE = ["--size", "90x67"]


class Parts(CliTest):
    def part(self, number, count, *arguments, output, **options):
        done = self.run_batch("render", *arguments, *SIZE, "-o", output, "--part", f"{number}/{count}", **options)
        return done.stderr.decode()

    def compare_with_one_process(self, *arguments, output="x.png", beside=(), counts=(3,)):
        whole, parts = self.folder / "whole", self.folder / "parts"
        for folder in (whole, parts):
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir()
        self.run_batch("render", *arguments, *SIZE, "-o", whole / output)
        for count in counts:
            for number in [*range(2, count + 1), 1]:
                self.assertFalse((parts / output).exists())
                said = self.part(number, count, *arguments, output=parts / output)
            self.assertIn(f"put together of {count} parts", said)
            for name in (output, *beside):
                self.assertEqual((parts / name).read_bytes(), (whole / name).read_bytes(), f"{arguments} {name} {count}")
                (parts / name).unlink()

    def test_they_are_the_bytes_of_one_process(self):
        torso = self.sample("torso", 48)
        labels = torso.with_name("torso_labels.seg.nrrd")
        common = (torso, labels, "--samples", "2")
        self.compare_with_one_process(*common, "--finish", "plate", "--view", "oblique", "--set", "cuts.+.axis=0,-1,0",
                                      counts=(2, 7))
        self.compare_with_one_process(*common, "--names", "--legend", "--scale-bar", output="x.tif")
        self.compare_with_one_process(*common, "--layers", "--transparent", beside=["x.depth.png", "x.id.png"])
        self.compare_with_one_process(*common, "--layers", "--bits", "16", output="x.exr")

    def test_of_models_and_membranes_too(self):
        self.run_batch("sample", "virion", "-o", "virion.cif")
        self.compare_with_one_process("virion.cif", "--samples", "1", "--legend")
        torso = self.sample("torso", 40)
        self.run_batch("membrane", torso, "--protect", "200,2000", "--axis", "0,-1,0", "--position", "0.7", "--save-scene", "m.json")
        self.compare_with_one_process("m.json", "--samples", "1")

    def test_what_was_stopped_is_drawn_again_and_nothing_else(self):
        path = self.sample()
        draw = lambda number: self.part(number, 3, path, output="x.png")
        self.assertIn("1 of 3 parts are there", draw(2))
        self.assertIn("2 of 3 parts are there", draw(3))
        folder = self.folder / "x.png.parts"
        cut_off, kept = folder / "3-of-3.exr", folder / "2-of-3.exr"
        cut_off.write_bytes(cut_off.read_bytes()[:-200])
        before = kept.stat().st_mtime_ns
        self.assertIn("2 of 3 parts are there", draw(1))
        self.assertIn("2 of 3 parts are there", draw(2))
        self.assertEqual(kept.stat().st_mtime_ns, before)
        self.assertIn("put together", draw(3))
        self.assertEqual([file.name for file in folder.iterdir()], ["made"])
        made = (self.folder / "x.png").stat().st_mtime_ns
        self.assertIn("it is there", draw(1))
        self.assertEqual((self.folder / "x.png").stat().st_mtime_ns, made)
        self.run_batch("render", path, "--view", "left", *SIZE, "-o", "x.png")
        self.assertIn("1 of 3 parts are there", draw(1), "another picture has its name")

    def test_parts_of_another_picture_are_not_put_in(self):
        path = self.sample()
        self.part(1, 2, path, "--view", "left", output="x.png")
        self.assertIn("1 of 2 parts", self.part(2, 2, path, output="x.png"))
        self.assertFalse((self.folder / "x.png").exists())
        self.assertIn("put together", self.part(1, 2, path, output="x.png"))
        self.run_batch("render", path, *SIZE, "-o", "whole.png")
        self.assertEqual((self.folder / "x.png").read_bytes(), (self.folder / "whole.png").read_bytes())

    def test_scripts_draw_parts_too(self):
        path = self.sample()
        (self.folder / "script").write_text("picture part=2/2 90x67 x.png\npicture part=1/2 90x67 x.png\npicture 90x67 whole.png\n")
        self.run_batch("run", "script", path)
        self.assertEqual((self.folder / "x.png").read_bytes(), (self.folder / "whole.png").read_bytes())

    def test_refusals(self):
        path = self.sample(voxels=16)
        for part in ("0/3", "4/3", "a", "2"):
            self.refuse("render", path, "-o", "x.png", "--part", part, code=1, words=["K/N"])
        self.refuse("render", path, *SIZE, "-o", "x.png", "--part", "1/68", code=1, words=["67 rows"])
        for output, more in (("-", []), ("x.svg", []), ("x.png", ["--section", "axial"])):
            self.refuse("render", path, *SIZE, "-o", output, "--part", "1/2", *more, code=1, words=["sections"])
        self.assertFalse((self.folder / "x.png.parts").exists())


if __name__ == "__main__":
    unittest.main()
