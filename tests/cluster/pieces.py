"""What the tests of clusters share: many small data sets, their pictures by one process, and counting."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = os.environ.get("VELUM_BATCH", "velum-batch")
COUNT = 60
# Enough work for a piece that it can be stopped in its middle.
WORDS = ["studies/*/ct.nrrd", "--size", "96x64", "--samples", "1"]


class PiecesTest(unittest.TestCase):
    """A folder with data sets and a whole of pictures that one process has made."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="velum-cluster-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        for i in range(COUNT):
            folder = cls.folder / f"studies/p{i:02}"
            folder.mkdir(parents=True)
            cls.batch("sample", "two-spheres", "-o", folder / "ct.nrrd", "--voxels", 16 + i % 20)
        cls.batch("each", *WORDS, "-o", "whole/{name}.png")

    @classmethod
    def batch(cls, *words):
        return subprocess.run([PROGRAM, *map(str, words)], cwd=cls.folder, check=True, capture_output=True, timeout=600)

    def command(self, folder):
        return [PROGRAM, "each", *WORDS, "-o", folder + "/{name}.png"]

    def states(self, folder):
        lines = self.batch(*self.command(folder)[1:], "--list", "--json").stdout.decode().splitlines()
        return [json.loads(line)["state"] for line in lines]

    def made(self, folder):
        return len(list((self.folder / folder).glob("*.png")))

    def pictures(self, folder):
        return {path.name: path.read_bytes() for path in (self.folder / folder).iterdir() if path.suffix == ".png"}

    def assertWhole(self, folder):
        whole = self.pictures("whole")
        self.assertEqual(len(whole), COUNT)
        made = self.pictures(folder)
        self.assertEqual(sorted(made), sorted(whole))
        self.assertEqual([name for name in whole if made[name] != whole[name]], [], "of other bytes")
        self.assertEqual([path.name for path in (self.folder / folder).glob(".velum-*")], [])
