"""velum-batch on drivers that offer too little, and on drivers that are reset."""
import json
import unittest

from velum_cli import CliTest

SMALL = ["--size", "60x40", "--samples", "2"]
RESET = "warning: the graphics driver was reset"


class TooOld(CliTest):
    """Mesa's softpipe is a driver of OpenGL 3.3."""
    ANY = {"VELUM_CONTEXT": None, "MESA_LOADER_DRIVER_OVERRIDE": None}  # whatever draws in other tests
    OLD = {**ANY, "GALLIUM_DRIVER": "softpipe"}

    def sentence(self, said):
        lines = said.decode().splitlines()
        self.assertEqual(len(lines), 1, said)
        for word in ("warning: softpipe offers OpenGL 3.3", "4.5 is needed", "software driver draws instead", "slower", "update"):
            self.assertIn(word, lines[0])

    def setUp(self):
        super().setUp()
        self.sample()
        self.usual = self.report("render", "two-spheres.nrrd", "-o", "usual.png", *SMALL, env=self.ANY)
        if "llvmpipe" not in self.usual["renderer"]:
            self.skipTest("the machine's driver is not the one that stands in")

    def test_the_software_driver_draws_the_same(self):
        for kind in ("auto", "egl"):
            done = self.run_batch("render", "two-spheres.nrrd", "-o", "old.png", *SMALL, "--context", kind, env=self.OLD)
            self.sentence(done.stderr)
            self.assertEqual((self.folder / "old.png").read_bytes(), (self.folder / "usual.png").read_bytes())

    def test_it_is_said_once_however_many_contexts_there_are(self):
        done = self.run_batch("film", "two-spheres.nrrd", "-o", "film/", "--frames", 3, *SMALL, env=self.OLD)
        self.sentence(done.stderr)
        self.assertEqual(len(list((self.folder / "film").glob("frame-*.png"))), 3)

    def test_where_that_is_too_old_itself_one_line_says_all(self):
        for kind in ("auto", "egl"):
            done = self.run_batch("render", "two-spheres.nrrd", "-o", "none.png", *SMALL, "--context", kind, code=3,
                                  env={**self.ANY, "MESA_GL_VERSION_OVERRIDE": "3.3"})
            lines = done.stderr.decode().splitlines()
            self.assertEqual(len(lines), 1, lines)
            for word in ("velum-batch: ", "llvmpipe", "offers OpenGL 3.3", "4.5 is needed", "install or update"):
                self.assertIn(word, lines[0])
            self.assertFalse((self.folder / "none.png").exists())

    def test_nothing_takes_the_place_of_what_was_asked_for_by_name(self):
        done = self.run_batch("render", "two-spheres.nrrd", "-o", "none.png", *SMALL, "--context", "osmesa", env=self.OLD, code=3)
        lines = done.stderr.decode().splitlines()
        self.assertEqual(len(lines), 1, lines)
        for word in ("velum-batch: OSMesa", "4.5 is needed", "install or update"):
            self.assertIn(word, lines[0])

    def test_what_needs_no_driver_says_nothing(self):
        done = self.run_batch("info", "two-spheres.nrrd", env=self.OLD)
        self.assertEqual(done.stderr, b"")


class Reset(CliTest):
    def lost(self, question, *arguments, times=1, code=0):
        done = self.run_batch(*arguments, env={"VELUM_LOSE_CONTEXT": f"{question},{times}"}, code=code)
        return done.stderr.decode()

    def test_a_picture_is_drawn_again(self):
        self.sample()
        self.run_batch("render", "two-spheres.nrrd", "-o", "usual.png", *SMALL)
        for question, times in ((1, 1), (2, 1), (3, 2)):
            said = self.lost(question, "render", "two-spheres.nrrd", "-o", "lost.png", *SMALL, times=times)
            self.assertEqual(said.count(RESET), times, said)
            self.assertEqual((self.folder / "lost.png").read_bytes(), (self.folder / "usual.png").read_bytes())

    def test_a_film_goes_on(self):
        self.sample()
        self.run_batch("film", "two-spheres.nrrd", "-o", "usual/", "--frames", 4, *SMALL)
        for question in (2, 7):
            said = self.lost(question, "film", "two-spheres.nrrd", "-o", f"lost{question}/", "--frames", 4, *SMALL)
            self.assertEqual(said.count(RESET), 1, said)
            for i in range(4):
                name = f"frame-{i:05}.png"
                self.assertEqual((self.folder / f"lost{question}" / name).read_bytes(),
                                 (self.folder / "usual" / name).read_bytes())

    def test_a_membrane_rests_where_it_would(self):
        self.run_batch("sample", "torso", "-o", "torso.nrrd", "--voxels", 40)
        hang = ["membrane", "torso.nrrd", "--protect", "200,2000", "--axis", "0,-1,0", "--position", "0.7"]
        self.run_batch(*hang, "--save-scene", "usual.json")
        for question in (1, 4):
            said = self.lost(question, *hang, "--save-scene", "lost.json")
            self.assertEqual(said.count(RESET), 1, said)
            self.assertEqual(json.loads((self.folder / "lost.json").read_text()),
                             json.loads((self.folder / "usual.json").read_text()))

    def test_many_pictures_of_many_data_sets_go_on(self):
        self.sample(file="a.nrrd")
        self.sample(file="b.nrrd")
        each = ["each", "?.nrrd", *SMALL]
        self.run_batch(*each, "-o", "usual/{name}.png")
        said = self.lost(3, *each, "-o", "lost/{name}.png")
        self.assertEqual(said.count(RESET), 1, said)
        pictures = {path.name: path.read_bytes() for path in (self.folder / "usual").glob("*.png")}
        self.assertEqual(len(pictures), 2)
        self.assertEqual({path.name: path.read_bytes() for path in (self.folder / "lost").glob("*.png")}, pictures)

    def test_again_and_again_is_an_error(self):
        self.sample()
        said = self.lost(1, "render", "two-spheres.nrrd", "-o", "lost.png", *SMALL, times=1000, code=3)
        self.assertIn("velum-batch: the graphics driver is reset whenever it draws this", said)
        self.assertIn("LIBGL_ALWAYS_SOFTWARE=1", said)
        self.assertFalse((self.folder / "lost.png").exists())


if __name__ == "__main__":
    unittest.main()
