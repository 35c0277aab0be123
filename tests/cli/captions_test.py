"""What velum-batch writes over pictures."""
import json
import unittest

from velum_cli import CliTest

FAST = ["--size", "160x120", "--samples", "1", "--set", "lighting.shaded=false"]


class Captions(CliTest):
    def test_each_is_in_the_picture_and_in_its_scene(self):
        path = self.sample("heart")
        self.run_batch("render", path, "-o", "plain.png", *FAST)
        self.run_batch("render", path, "-o", "x.png", "--caption", "One", "--caption", "two\nlines, \u00e4", "--time-stamp",
                       "--save-scene", "x.json", *FAST)
        lettering = json.loads((self.folder / "x.json").read_text())["lettering"]
        self.assertEqual([(one["id"], one["text"]) for one in lettering["captions"]], [(1, "One"), (2, "two\nlines, \u00e4")])
        self.assertTrue(lettering["timeStamp"])
        self.run_batch("compare", "plain.png", "x.png", "--max-diff", "0", "--max-fraction", "0", code=4)
        self.run_batch("render", "x.json", "-o", "y.png", *FAST)
        self.run_batch("compare", "x.png", "y.png", "--max-diff", "0", "--max-fraction", "0")
        hidden = ["--set", "lettering.captions.*.opacity=0", "--set", "lettering.timeStamp=false"]
        self.run_batch("render", "x.json", "-o", "z.png", *FAST, *hidden)
        self.run_batch("compare", "plain.png", "z.png", "--max-diff", "0", "--max-fraction", "0")

    def test_sections_have_them_and_there_are_not_more_than_a_hundred(self):
        path = self.sample()
        for name, words in (("plain.png", []), ("x.png", ["--caption", "One"])):
            self.run_batch("render", path, "-o", name, "--section", "axial", "--size", "160x120", *words)
        self.run_batch("compare", "plain.png", "x.png", "--max-diff", "0", "--max-fraction", "0", code=4)
        self.refuse("render", path, "-o", "y.png", *FAST, *["--caption", "x"] * 101, code=1, words=["100 captions"])


if __name__ == "__main__":
    unittest.main()
