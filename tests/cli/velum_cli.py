"""Runs velum-batch for the tests in this folder. VELUM_BATCH names the program."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = os.environ.get("VELUM_BATCH", "velum-batch")


class CliTest(unittest.TestCase):
    """A test with a folder of its own, removed at the end."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="velum-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def run_batch(self, *arguments, code=0, cwd=None, env=None):
        """Runs and checks the exit code; bytes of stdout and stderr in the result. What is None in env is not set."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, cwd=cwd or self.folder, timeout=120,
                              env={k: v for k, v in {**os.environ, **(env or {})}.items() if v is not None})
        said = done.stderr.decode(errors="replace")
        self.assertEqual(done.returncode, code, f"{' '.join(map(str, arguments))}\n{said}")
        return done

    def refuse(self, *arguments, code, words=()):
        """A refusal is one line on stderr that begins with the program's name, and nothing on stdout."""
        done = self.run_batch(*arguments, code=code)
        said = done.stderr.decode(errors="replace")
        lines = [line for line in said.splitlines() if not line.startswith("warning: ")]
        self.assertEqual(len(lines), 1, said)
        self.assertTrue(lines[0].startswith("velum-batch: "), said)
        self.assertGreater(len(lines[0]), 25, said)
        self.assertEqual(done.stdout, b"")
        for word in words:
            self.assertIn(word, lines[0])
        return lines[0]

    def report(self, *arguments, **options):
        return json.loads(self.run_batch(*arguments, "--json", **options).stdout)

    def sample(self, name="two-spheres", voxels=32, file=None):
        """Makes a small phantom and gives the volume's path; labels lie beside it."""
        path = self.folder / (file or f"{name}.nrrd")
        self.run_batch("sample", name, "-o", path, "--voxels", voxels)
        return path

    def assertKeys(self, report, *keys):
        for key in keys:
            self.assertIn(key, report)
