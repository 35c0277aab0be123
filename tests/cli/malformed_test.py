"""Every damaged file: no crash, no hang, no more memory than the file justifies, one line when it is refused."""
import os
import pathlib
import resource
import subprocess
import sys
import unittest

from velum_cli import PROGRAM, CliTest

DATA = os.environ.get("VELUM_TEST_DATA", "")
MOST_SECONDS = 5.0  # of the processor
MOST_BYTES = 700 << 20  # resident; the libraries alone take some 150 MiB


def run(path):
    """Exit code (negative: signal), stderr, seconds of the processor, largest resident bytes of one child."""
    child = subprocess.Popen([PROGRAM, "info", str(path), "--json"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    try:
        said = child.stderr.read()
    finally:
        child.stderr.close()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    return child.returncode, said.decode(errors="replace"), usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (20, 20))  # a hang ends


class Malformed(CliTest):
    def test_every_file_opens_or_is_refused_in_one_line(self):
        files = sorted(p for p in (pathlib.Path(DATA) / "malformed").rglob("*") if p.name != "README.md")
        self.assertGreater(len(files), 60)
        for path in files:
            with self.subTest(path=path.name):
                code, said, seconds, memory = run(path)
                self.assertIn(code, (0, 2), said)
                if code == 2:
                    lines = [line for line in said.splitlines() if not line.startswith("warning: ")]
                    self.assertEqual(len(lines), 1, said)
                    self.assertTrue(lines[0].startswith("velum-batch: "), said)
                    self.assertIn(str(path.parent), lines[0])  # a file of a DICOM series may fail for another of it
                self.assertLess(seconds, MOST_SECONDS)
                self.assertLess(memory, MOST_BYTES)


if __name__ == "__main__":
    if not DATA:
        print("set VELUM_TEST_DATA to the folder of test volumes")
        sys.exit(77)
    limit()
    unittest.main()
