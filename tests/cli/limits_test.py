"""Every render ends: scenes and files with numbers that nobody meant, and more cuts than anybody makes."""
import json
import os
import pty
import re
import signal
import struct
import subprocess
import time
import unittest

from velum_cli import PROGRAM, CliTest

FAST = ["--samples", "1", "--size", "64x48"]
# A small picture takes a second or two; whatever never came back took minutes.
SECONDS = ["--timeout", "60"]


class Limits(CliTest):
    def render(self, *arguments, **options):
        self.run_batch("render", *arguments, "-o", "x.png", *FAST, *SECONDS, **options)

    def write_nrrd(self, name, directions, origin=(0, 0, 0), edge=24):
        vectors = " ".join("({:.17g},{:.17g},{:.17g})".format(*row) for row in directions)
        head = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {edge} {edge} {edge}\n"
                f"space directions: {vectors}\nspace origin: ({origin[0]:.17g},{origin[1]:.17g},{origin[2]:.17g})\n"
                "encoding: raw\n\n")
        voxels = bytes((x * 7 + y * 3 + z * 5) % 251 for z in range(edge) for y in range(edge) for x in range(edge))
        path = self.folder / name
        path.write_bytes(head.encode() + voxels)
        return path

    def test_voxels_of_any_size_come_to_a_picture(self):
        for edge in (1e-308, 1e-12, 1e-6, 1e30):
            for flat in (False, True):
                with self.subTest(edge=edge, flat=flat):
                    rows = [[edge if flat is False or i == 2 else 1.0, 0, 0] for i in range(3)]
                    rows = [[0] * i + [row[0]] + [0] * (2 - i) for i, row in enumerate(rows)]
                    self.render(self.write_nrrd("v.nrrd", rows))

    def test_an_origin_far_away_comes_to_a_picture(self):
        for far in (1e9, 1e14, 1e300):
            with self.subTest(far=far):
                self.render(self.write_nrrd("v.nrrd", [[1, 0, 0], [0, 1, 0], [0, 0, 1]], (far, -far, far)))

    def test_eyes_far_away_come_to_an_end(self):
        volume = self.write_nrrd("v.nrrd", [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        for far in (1e5, 1e9, 1e15):
            for mode in ("volume", "mip", "iso"):
                with self.subTest(far=far, mode=mode):
                    self.render(volume, "--set", f"camera.eye={far},{far},{-far}", "--set", f"rayCast.mode={mode}",
                                "--set", "rayCast.isoValue=100")
        for what in ("eye", "target", "up"):
            self.refuse("render", volume, "-o", "y.png", *FAST, "--set", f"camera.{what}=1e300,0,0", code=1, words=[what, "1e+15"])

    def test_numbers_that_are_none_are_refused(self):
        volume = self.write_nrrd("v.nrrd", [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        for word in ("nan", "inf", "-inf", "1e999"):
            self.refuse("render", volume, "-o", "y.png", "--set", f"rayCast.stepVoxels={word}", code=1)
            self.refuse("render", volume, "-o", "y.png", "--dpi", word, code=1)
            self.refuse("render", volume, "-o", "y.png", "--spacing", f"1,{word},1", code=1)
            self.refuse("membrane", volume, "--axis", f"0,{word},1", code=1)
        for length in ("1e-300", "-1", "1e40"):
            self.refuse("render", volume, "-o", "y.png", f"--spacing=1,{length},1", code=1, words=["--spacing"])

    def test_a_thousand_cuts_come_to_a_picture_and_more_are_refused(self):
        volume = self.write_nrrd("v.nrrd", [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        self.run_batch("render", volume, "-o", "x.png", *FAST, "--save-scene", "s.json")
        scene = json.loads((self.folder / "s.json").read_text())
        shapes = ["plane", "box", "sphere", "cylinder", "cone"]

        def cuts(count):
            return [{"shape": shapes[i % 5], "centre": [(i * 7) % 24, (i * 5) % 24, (i * 11) % 24], "axis": [i % 3 - 1, 1, i % 5 - 2],
                     "size": [2, 2, 2]} for i in range(count)]

        scene["cuts"] = cuts(1024)
        (self.folder / "s.json").write_text(json.dumps(scene))
        self.render("s.json")
        self.render("s.json", "--section", "axial")
        self.refuse("render", "s.json", "-o", "y.png", "--set", "cuts.+.shape=box", code=1, words=["1024"])
        scene["cuts"] = cuts(1025)
        (self.folder / "s.json").write_text(json.dumps(scene))
        self.refuse("render", "s.json", "-o", "y.png", code=2, words=["cuts", "1024"])

    def test_a_timeout_ends_it_in_order(self):
        volume = self.sample("torso", 64)
        began = time.monotonic()
        done = self.run_batch("render", volume, "-o", "x.png", "--size", "4000x3000", "--samples", "256", "--timeout", "2",
                              code=128 + signal.SIGALRM)
        self.assertLess(time.monotonic() - began, 30)
        self.assertEqual(done.stderr.decode(), "velum-batch: stopped after the time that --timeout allows\n")
        self.assertEqual([path.name for path in self.folder.iterdir() if path.name.startswith(("x", "."))], [])
        self.refuse("render", volume, "-o", "x.png", "--timeout", "-1", code=1)

    def test_a_terminal_sees_the_progress_and_a_pipe_does_not(self):
        volume = self.sample("torso", 64)
        arguments = ["render", str(volume), "-o", "x.png", "--size", "600x400", "--samples", "4"]
        self.assertEqual(self.run_batch(*arguments).stderr, b"")
        ours, theirs = pty.openpty()
        run = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stderr=theirs)
        os.close(theirs)
        said = b""
        try:
            while piece := os.read(ours, 4096):
                said += piece
        except OSError:  # a terminal whose other end has left
            pass
        os.close(ours)
        self.assertEqual(run.wait(timeout=60), 0)
        steps = [int(step) for step in re.findall(rb"rendering +(\d+) %", said)]
        self.assertGreater(len(set(steps)), 3, said)
        self.assertEqual(steps, sorted(steps))


if __name__ == "__main__":
    unittest.main()
