"""The window on Wayland: a scripted session under a headless weston does what it does on X."""
import os
import shutil
import subprocess
import time
import unittest

from start_test import DISPLAYS, WindowTest

SIZE = (1440, 900)


@unittest.skipUnless(shutil.which("weston"), "weston is not installed")
class Wayland(WindowTest):
    def weston(self):
        """The environment of programs that show themselves in a weston of their own."""
        words = ["weston", "--backend=headless-backend.so", "--socket=velum", "--idle-time=0", f"--width={SIZE[0] + 160}",
                 f"--height={SIZE[1] + 100}"]
        running = subprocess.Popen(words, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(running.wait)
        self.addCleanup(running.kill)
        socket = self.folder / "run/velum"
        end = time.monotonic() + 30
        while not socket.exists() and time.monotonic() < end:
            time.sleep(0.05)
        self.assertTrue(socket.exists(), "weston does not start")
        there = {name: value for name, value in self.environment.items() if name not in DISPLAYS}
        return {**there, "WAYLAND_DISPLAY": "velum", "QT_QPA_PLATFORM": "wayland"}

    def session(self, name, environment):
        """Opens, cuts, measures, takes back, looks at pages, saves: the scene, and the file of a picture of the window."""
        script = self.script("open a.nrrd", "settle", "cut.add plane", "page marks", "mark.add distance points=-20,0,0;20,0,0",
                             "look.preset ct-bone", "do edit.undo", "settle", f"save {name}.json", "quit")
        self.environment = environment
        window = self.start("--script", script, "--echo")
        said, errors = window.communicate(timeout=240)
        self.assertEqual(window.returncode, 0, said + errors)
        return (self.folder / f"{name}.json").read_bytes()

    def test_a_scripted_session_does_what_it_does_on_x(self):
        self.batch("sample", "two-spheres", "-o", "a.nrrd", "--voxels", 32)
        on_x = self.environment
        there = self.weston()
        on_wayland = self.session("wayland", there)
        self.assertIn(b'"marks"', on_wayland)
        self.assertEqual(on_wayland, self.session("x", on_x))

    def test_a_picture_of_the_window_shows_the_data(self):
        self.batch("sample", "two-spheres", "-o", "a.nrrd", "--voxels", 32)
        self.environment = self.weston()
        window = self.start("--screenshot", "window.png", "a.nrrd")
        said, errors = window.communicate(timeout=240)
        self.assertEqual(window.returncode, 0, said + errors)
        self.assertGreater((self.folder / "window.png").stat().st_size, 100_000)


if __name__ == "__main__":
    unittest.main()
