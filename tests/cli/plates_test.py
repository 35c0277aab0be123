"""Golden plates: what velum-batch writes as .svg today beside what people have looked at, tests/golden/plates/NAME/case.svg.

case.json says how: `sample`, the arguments of `velum-batch sample` for each phantom; `render`, the arguments of the plate; `size`;
`apart` and `fromPicture`, how far the plate may be from the accepted one, and from the picture of pixels, as rsvg-convert draws it.
A plate that is right otherwise is accepted with the command that the failing test says."""
import json
import os
import pathlib
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as xml

from velum_cli import CliTest

SVG, INKSCAPE = "{http://www.w3.org/2000/svg}", "{http://www.inkscape.org/namespaces/inkscape}"
ROOT = pathlib.Path(__file__).resolve().parents[2]
PLATES = ROOT / "tests" / "golden" / "plates"
MOST_BYTES = 150_000  # of an accepted plate


def structure(file):
    """What a plate is made of: the page, and of each layer its name, its items by kind, the names of shapes, the words."""
    root = xml.parse(file).getroot()
    layers = []
    for group in root.iter(SVG + "g"):
        if group.get(INKSCAPE + "groupmode") != "layer":
            continue
        kinds = {kind: len(list(group.iter(SVG + kind))) for kind in ("image", "path", "text", "use")}
        names = sorted({path.get(INKSCAPE + "label") or "" for path in group.iter(SVG + "path")})
        words = ["".join(text.itertext()) for text in group.iter(SVG + "text")]
        layers.append({"name": group.get(INKSCAPE + "label"), **kinds, "names": names, "words": words})
    return {"page": [root.get("width"), root.get("height"), root.get("viewBox")], "layers": layers}


class Plates(CliTest):
    def draw(self, svg, png):
        """As rsvg-convert draws it, with the fonts of the project and no others."""
        fonts = self.folder / "fonts.conf"
        fonts.write_text(f'<?xml version="1.0"?><!DOCTYPE fontconfig SYSTEM "fonts.dtd"><fontconfig><dir>{ROOT / "resources" / "fonts"}</dir>'
                         f'<cachedir>{self.folder / "cache"}</cachedir></fontconfig>')
        width, height = xml.parse(svg).getroot().get("viewBox").split()[2:]
        subprocess.run(["rsvg-convert", "-w", width, "-h", height, "-b", "white", "-o", png, svg], check=True,
                       env={**os.environ, "FONTCONFIG_FILE": str(fonts), "HOME": str(self.folder)})

    def check(self, name):
        case = json.loads((PLATES / name / "case.json").read_text())
        accepted, beside = PLATES / name / "case.svg", PLATES / name / "case.new.svg"
        for sample in case["sample"]:
            self.run_batch("sample", *sample)
        for file in ("case.svg", "case.png"):
            self.run_batch("render", *case["render"], "-o", file, "--size", case["size"])
        new = self.folder / "case.svg"
        how = f"look at it, then accept it with\n  mv {beside} {accepted}"
        try:
            self.assertTrue(accepted.exists(), f"there is no accepted plate yet; the new one is {beside}")
            self.assertEqual(structure(new), structure(accepted))
            self.assertLess(accepted.stat().st_size, MOST_BYTES)
            self.assertEqual(self.report("info", accepted)["kind"], "scene", "accepted plates open as their scenes")
            if not shutil.which("rsvg-convert"):
                self.skipTest("rsvg-convert is not there: install Debian's librsvg2-bin")
            self.draw(new, self.folder / "new.png")
            self.draw(accepted, self.folder / "accepted.png")
            self.compare("accepted.png", "new.png", case["apart"])
            self.compare("case.png", "new.png", case["fromPicture"])
        except AssertionError as wrong:
            shutil.copy(new, beside)
            raise AssertionError(f"{wrong}\n{beside}: if it is right, {how}") from None

    def compare(self, a, b, most):
        difference = self.report("compare", a, b, "--max-diff", most["of255"], "--max-fraction", most["share"])
        self.assertLessEqual(difference["failingFraction"], most["share"])


def add(name):
    setattr(Plates, "test_" + name.replace("-", "_"), lambda self: self.check(name))


for folder in sorted(PLATES.iterdir()):
    add(folder.name)

if __name__ == "__main__":
    unittest.main()
