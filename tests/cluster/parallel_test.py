"""The same by GNU parallel, on one machine."""
import shutil
import subprocess
import time
import unittest

from pieces import COUNT, PiecesTest

PARTS = 6


@unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
class Parallel(PiecesTest):
    def start(self, folder):
        parts = [str(part) for part in range(1, PARTS + 1)]
        return subprocess.Popen(["parallel", "-j2", "-q", *self.command(folder), "--part", "{}/" + str(PARTS), ":::", *parts],
                                cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def children(self, process):
        return subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True).stdout.split()

    def test_parts_of_which_some_are_killed_give_the_bytes_of_one_process(self):
        running = self.start("out")
        end = time.monotonic() + 240
        for wanted in (5, 20):
            while self.made("out") < wanted and running.poll() is None and time.monotonic() < end:
                time.sleep(0.01)
            for child in self.children(running)[:1]:
                subprocess.run(["kill", "-9", child], check=False)
        running.wait(timeout=240)
        self.assertLess(self.states("out").count("done"), COUNT)
        self.assertEqual(self.start("out").wait(timeout=240), 0)
        self.assertEqual(self.states("out"), ["done"] * COUNT)
        self.assertWhole("out")


if __name__ == "__main__":
    unittest.main()
