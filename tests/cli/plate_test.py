"""Plates: what velum-batch render writes as .svg and .pdf."""
import re
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as xml

from velum_cli import CliTest

SVG, INKSCAPE = "{http://www.w3.org/2000/svg}", "{http://www.inkscape.org/namespaces/inkscape}"
FAST = ["--samples", "1", "--set", "lighting.shaded=false"]


class Plate(CliTest):
    def heart(self):
        """Volume and labels."""
        volume = self.sample("heart")
        return [volume, "--labels", volume.with_name("heart_labels.seg.nrrd")]

    def svg(self, *arguments, name="plate.svg"):
        self.run_batch("render", *self.heart(), "-o", name, "--size", "400x300", *FAST, *arguments)
        return xml.parse(self.folder / name).getroot()

    def layers(self, root):
        return [group.get(INKSCAPE + "label") for group in root.iter(SVG + "g") if group.get(INKSCAPE + "groupmode") == "layer"]

    def texts(self, root):
        return ["".join(text.itertext()) for text in root.iter(SVG + "text")]

    def test_layers_have_names_and_letters_are_text(self):
        root = self.svg("--finish", "ink", "--surface", "--names", "--scale-bar", "--caption", "Plate \u00e4 <1>")
        layers = self.layers(root)
        for name in ("paper", "plate", "contours", "leaders", "labels", "scale bar", "captions"):
            self.assertIn(name, layers)
        self.assertIn("Plate \u00e4 <1>", self.texts(root))
        self.assertTrue(any(text.endswith(" mm") for text in self.texts(root)))
        self.assertGreaterEqual(len(list(root.iter(SVG + "image"))), 1)

    def test_marks_stand_in_it_and_in_pictures_of_pixels(self):
        mark = ["--set", "lettering.marks.+.kind=distance", "--set", "lettering.marks.0.points=[[-10,0,0],[10,0,0]]"]
        root = self.svg(*mark)
        self.assertIn("marks", self.layers(root))
        self.assertIn("20 mm", self.texts(root))
        for name, words in (("plain.png", []), ("marked.png", mark)):
            self.run_batch("render", *self.heart(), "-o", name, "--size", "200x150", *FAST, *words)
        self.run_batch("compare", "plain.png", "marked.png", "--max-diff", "0", "--max-fraction", "0", code=4)
        section = ["render", *self.heart(), "--section", "axial", "--size", "200x150"]
        self.run_batch(*section, "-o", "section.svg", *mark)
        self.assertEqual(self.layers(xml.parse(self.folder / "section.svg").getroot())[0], "plate")

    def test_the_page_is_as_wide_as_was_asked_and_journals_are_warned_for(self):
        done = self.run_batch("render", *self.heart(), "-o", "small.svg", "--size", "400x300", "--page-width", "174", "--scale-bar", *FAST)
        self.assertIn(b"pixels an inch", done.stderr)
        root = xml.parse(self.folder / "small.svg").getroot()
        self.assertAlmostEqual(float(re.match(r"[\d.]+", root.get("width"))[0]), 174.0, places=2)
        done = self.run_batch("render", *self.heart(), "-o", "good.svg", "--size", "1010x700", "--page-width", "85", "--style", "journal",
                              "--scale-bar", *FAST)
        self.assertNotIn(b"warning", done.stderr)

    def test_a_pdf_holds_the_same_words(self):
        self.run_batch("render", *self.heart(), "-o", "plate.pdf", "--size", "400x300", "--scale-bar", "--caption", "Searchable", *FAST)
        self.assertTrue((self.folder / "plate.pdf").read_bytes().startswith(b"%PDF-1."))
        if not shutil.which("pdftotext"):
            self.skipTest("pdftotext is not installed")
        said = subprocess.run(["pdftotext", self.folder / "plate.pdf", "-"], capture_output=True, check=True).stdout.decode()
        self.assertIn("Searchable", said)

    def test_the_same_scene_gives_the_same_bytes(self):
        for ending in ("svg", "pdf"):
            both = []
            for name in ("a", "b"):
                self.run_batch("render", *self.heart(), "-o", f"{name}.{ending}", "--size", "160x120", "--finish", "ink", "--names", *FAST)
                both.append((self.folder / f"{name}.{ending}").read_bytes())
            self.assertEqual(*both)

    def test_a_plate_opens_as_its_scene_and_gives_the_same_plate(self):
        words = ["--finish", "ink", "--names", "--caption", "]]> </velum:scene> endstream", "--set", "cuts.+.axis=0,-1,0", "--set", "finish.contours=1"]
        for ending in ("svg", "pdf"):
            first, again = f"a.{ending}", f"b.{ending}"
            self.run_batch("render", *self.heart(), "-o", first, "--size", "160x120", *FAST, *words)
            self.run_batch("render", first, "-o", again, "--size", "160x120")
            self.assertEqual((self.folder / first).read_bytes(), (self.folder / again).read_bytes(), ending)
            self.run_batch("render", *self.heart(), "-o", "a.png", "--size", "160x120", *FAST, *words)
            self.assertEqual(self.report("info", first)["scene"], self.report("info", "a.png")["scene"])
            self.assertEqual(self.report("info", first)["kind"], "scene")

    def test_files_that_hold_no_scene_or_a_damaged_one_are_refused_in_a_line(self):
        self.run_batch("render", *self.heart(), "-o", "a.svg", "--size", "40x30", *FAST)
        self.run_batch("render", *self.heart(), "-o", "a.pdf", "--size", "40x30", *FAST)
        svg, pdf = (self.folder / "a.svg").read_bytes(), (self.folder / "a.pdf").read_bytes()
        scene = svg.index(b"<velum:scene")
        bomb = b'<!DOCTYPE svg [<!ENTITY a "ha">' + b"".join(
            b'<!ENTITY %c "%s">' % (c, b"&%c;" % (c - 1) * 10) for c in range(ord("b"), ord("z"))) + b"]><svg>&y;</svg>"
        files = {"none.svg": svg[:scene], "other.svg": b"<svg/>", "empty.svg": b"", "cut.svg": svg[:scene + 400], "bomb.svg": bomb,
                 "no-json.svg": svg[:scene] + b'<velum:scene encoding="base64">bm8ganNvbg==</velum:scene>', "no-base64.svg": svg[:scene] + b"<velum:scene>&y;</velum:scene>",
                 "other.pdf": b"%PDF-1.4\n%%EOF", "cut.pdf": pdf[:pdf.index(b"/VelumScene") + 60], "empty.pdf": b"", "text.pdf": b"not one at all",
                 "no-stream.pdf": b"%PDF-1.4\n1 0 obj << /VelumScene true >> endobj"}
        for name, data in files.items():
            (self.folder / name).write_bytes(data)
            self.refuse("render", name, "-o", "x.png", code=2, words=[name])
            self.refuse("info", name, code=2, words=[name])

    def test_what_cannot_be_written_is_refused_before_anything_is_drawn(self):
        self.refuse("render", *self.heart(), "-o", "no/such/plate.svg", code=2)
        self.refuse("render", *self.heart(), "-o", "plate.eps", code=2, words=[".svg"])
        self.refuse("render", *self.heart(), "-o", "x.png", "--style", "comic", code=1, words=["--style"])
        self.refuse("render", *self.heart(), "-o", "x.svg", "--page-width", "85", "--dpi", "300", code=1, words=["--page-width"])


if __name__ == "__main__":
    unittest.main()
