"""What Python costs: the same picture by velum-batch and by the module, whole processes, in seconds of the processor, the least of
several."""
import resource
import subprocess
import sys
import unittest

from support import PROGRAM, Case

MOST = 1.05
TURNS = 4


def seconds(command, folder):
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    before = used()
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    return used() - before


class Overhead(Case):
    def test_a_picture_costs_what_it_costs_the_program(self):
        path = self.sample("skull", 192)
        size, samples = "1280x960", 8
        (self.folder / "script.txt").write_text(f"open {path}\ncut.add plane\npicture {size} samples={samples} batch.png\n")
        program = f"import velum; s = velum.open({str(path)!r}); s.cut.add('plane'); s.picture({size!r}, 'python.png', samples={samples})"
        rows = [(seconds([PROGRAM, "run", "script.txt"], self.folder), seconds([sys.executable, "-c", program], self.folder)) for _ in range(TURNS)]
        self.assertEqual((self.folder / "batch.png").read_bytes(), (self.folder / "python.png").read_bytes())
        by_batch, by_python = (min(column) for column in zip(*rows))
        print(f"velum-batch {by_batch:.2f} s, Python {by_python:.2f} s")
        self.assertLess(by_python, by_batch * MOST)


if __name__ == "__main__":
    unittest.main()
