"""A window of a user who writes 0,5: files are read and written as everywhere else."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

VELUM, BATCH, LOCALEDEF = os.environ["VELUM"], os.environ["VELUM_BATCH"], os.environ["LOCALEDEF"]

COMMA = """LC_NUMERIC
decimal_point ","
thousands_sep "."
grouping 3;3
END LC_NUMERIC
"""

# Read by our own code; surfaces are read by a library.
NRRD = b"""NRRD0004
type: uint8
dimension: 3
sizes: 2 2 2
spacings: 0.25 0.5 1.75
encoding: raw

""" + bytes(range(8))
PLY = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0.25 0 0
0.5 1.5 0
0 0 1.75
3 0 1 2
"""


class Comma(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        (self.folder / "comma.src").write_text(COMMA)
        # It warns of the categories that are left out.
        subprocess.run([LOCALEDEF, "-c", "--no-archive", "-i", "comma.src", "./comma"], cwd=self.folder,
                       capture_output=True, timeout=60, check=False)
        self.assertTrue((self.folder / "comma/LC_NUMERIC").exists())
        (self.folder / "run").mkdir(mode=0o700)
        self.environment = {k: v for k, v in os.environ.items() if not k.startswith("LC_") and k != "LANGUAGE"}
        self.environment |= {"XDG_STATE_HOME": str(self.folder), "XDG_CONFIG_HOME": str(self.folder),
                             "XDG_RUNTIME_DIR": str(self.folder / "run"), "LANG": "C.UTF-8", "LC_NUMERIC": "comma",
                             "LOCPATH": str(self.folder)}

    def run_script(self, name, *lines, language="en"):
        script = self.folder / f"{name}.vel"
        script.write_text("\n".join(lines))
        done = subprocess.run([VELUM, "--language", language, "--script", script], cwd=self.folder, env=self.environment, capture_output=True,
                              text=True, timeout=90, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_the_locale_is_what_it_is_meant_to_be(self):
        said = subprocess.run(["locale", "decimal_point"], env=self.environment, capture_output=True, text=True,
                              timeout=60, check=False).stdout
        self.assertEqual(said.strip(), ",")

    def test_scenes_hold_what_was_set(self):
        (self.folder / "grid.nrrd").write_bytes(NRRD)
        lines = ["set camera.fieldOfViewDeg 33.25", "set lighting.ambient 0.3", "set background.top 0.125,0.5,0.75"]
        self.run_script("first", "open grid.nrrd", *lines, "save scene.json", "quit")
        written = json.loads((self.folder / "scene.json").read_text())
        self.assertEqual(written["camera"]["fieldOfViewDeg"], 33.25)
        self.assertEqual(written["lighting"]["ambient"], 0.3)
        self.assertEqual(written["background"]["top"], [0.125, 0.5, 0.75])
        self.assertNotEqual(written["camera"]["eye"], [round(x) for x in written["camera"]["eye"]])
        self.run_script("again", "open scene.json", "save again.json", "quit")
        self.assertEqual(json.loads((self.folder / "again.json").read_text()), written)

    def test_files_are_the_same_bytes_in_each_language(self):
        (self.folder / "grid.nrrd").write_bytes(NRRD)
        lines = ["open grid.nrrd", "set lighting.ambient 0.3", "cut.add box", "cut.add plane", "mark.add distance [[0,0,0],[0.1,0.1,0.1]]",
                 "caption.add Words", "set cuts.0.size 0.25,0.5,0.75", "film.turn 2.5", "page cuts", "settle"]
        written = {}
        for language in ("en", "de"):
            # The scene names its data and itself by where they are: both are written under the same names.
            self.run_script(language, *lines, "save scene.json", "picture 64x48 picture.png", "quit", language=language)
            written[language] = [(self.folder / name).read_bytes() for name in ("scene.json", "picture.png")]
        for one, other in zip(written["en"], written["de"]):
            self.assertEqual(one, other)

    def test_an_unknown_language_is_one_line(self):
        done = subprocess.run([VELUM, "--language", "fr"], env=self.environment, capture_output=True, text=True, timeout=60,
                              check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("en and de", done.stderr)

    def test_surfaces_lie_where_their_file_says(self):
        (self.folder / "surface.ply").write_text(PLY)
        self.run_script("surface", "open surface.ply", "save scene.json", "quit")
        target = json.loads((self.folder / "scene.json").read_text())["camera"]["target"]
        self.assertEqual(target, [0.25, 0.75, 0.875])

    def test_volumes_look_as_without_a_window(self):
        (self.folder / "grid.nrrd").write_bytes(NRRD)
        self.run_script("window", "open grid.nrrd", "set lighting.ambient 0.3", "save window.json", "quit")
        subprocess.run([BATCH, "render", "grid.nrrd", "--set", "lighting.ambient=0.3", "--save-scene", "batch.json", "-o",
                        "batch.png", "--size", "64x64"], cwd=self.folder, capture_output=True, timeout=60, check=True)
        window, batch = (json.loads((self.folder / f"{name}.json").read_text()) for name in ("window", "batch"))
        self.assertEqual(window["camera"]["target"], batch["camera"]["target"])
        self.assertEqual(window["camera"]["target"], [0.125, 0.25, 0.875])
        self.assertEqual(window["volume"]["transfer"], batch["volume"]["transfer"])


if __name__ == "__main__":
    unittest.main()
