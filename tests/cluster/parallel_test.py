"""The same by GNU parallel, on one machine: a third of its tasks is killed in the middle of a piece."""
import shutil
import subprocess
import sys
import unittest

from pieces import COUNT, PiecesTest

PARTS = 6


@unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
class Parallel(PiecesTest):
    def start(self, folder):
        parts = [str(part) for part in range(1, PARTS + 1)]
        return subprocess.Popen(["parallel", "-j2", "-q", *self.command(folder), "--part", "{}/" + str(PARTS), ":::", *parts],
                                cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def test_parts_of_which_a_third_is_killed_give_the_bytes_of_one_process(self):
        running = self.start("out")
        killed = [self.kill_in_the_middle("out", part, PARTS, after, lambda words, _: f"{part}/{PARTS}" in words,
                                          lambda: running.poll() is not None)
                  for part, after in ((2, 0), (5, 3))]
        self.assertEqual(running.wait(timeout=240), len(killed), "as many tasks have failed")
        before = self.records("out")
        self.assertLeft(before, killed)
        self.assertEqual(self.start("out").wait(timeout=240), 0)
        self.assertOnlyRestMade("out", before)
        self.assertEqual(self.states("out"), ["done"] * COUNT)
        self.assertWhole("out")
        print(f"{sum(told[-1:] != ['done'] for told in before.values())} of {COUNT} pieces were left, {killed} in their middle", file=sys.stderr)


if __name__ == "__main__":
    unittest.main()
