"""What says whether two builds gave the same bytes: on packages of a few files."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SAME = pathlib.Path(__file__).resolve().parents[2] / ".ci/package/same"


@unittest.skipUnless(shutil.which("dpkg-deb"), "dpkg is not installed")
class Same(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="velum-same-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def build(self, name, text="what it does\n", mode=0o644, level="6"):
        tree = self.folder / "tree"
        shutil.rmtree(tree, ignore_errors=True)
        (tree / "DEBIAN").mkdir(parents=True)
        (tree / "DEBIAN/control").write_text("Package: thing\nVersion: 1\nArchitecture: all\nMaintainer: a <a@b.c>\nDescription: a thing\n")
        (tree / "usr/bin").mkdir(parents=True)
        (tree / "usr/bin/thing").write_text(text)
        (tree / "usr/bin/thing").chmod(mode)
        (tree / "usr/bin/other").write_text("the same\n")
        out = self.folder / name
        (out / "source").mkdir(parents=True, exist_ok=True)
        subprocess.run(["dpkg-deb", "--root-owner-group", f"-z{level}", "-b", tree, out / "thing_1_all.deb"], check=True, capture_output=True,
                       env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"})
        (out / "source/thing_1.dsc").write_text("Format: 3.0 (quilt)\n")
        return out

    def compare(self, one, two):
        done = subprocess.run([SAME, one, two], capture_output=True, text=True, timeout=60)
        return done.returncode, done.stdout + done.stderr

    def test_equal_builds_are_the_same(self):
        self.assertEqual(self.compare(self.build("a"), self.build("b")), (0, "the same bytes: source/thing_1.dsc thing_1_all.deb \n"))

    def test_what_differs_is_named(self):
        one = self.build("a")
        code, said = self.compare(one, self.build("b", "what it does, from /home/me\n"))
        self.assertEqual(code, 1)
        self.assertIn("thing_1_all.deb differs:", said)
        self.assertIn("  usr/bin/thing: ", said)
        self.assertNotIn("other", said)
        code, said = self.compare(one, self.build("c", mode=0o755))
        self.assertEqual(code, 1)
        self.assertIn("usr/bin/thing f 755", said)
        code, said = self.compare(one, self.build("d", level="1"))
        self.assertEqual(code, 1)
        self.assertIn("all files inside are the same", said)

    def test_a_package_of_one_build_alone_is_a_difference(self):
        one, two = self.build("a"), self.build("b")
        (two / "source/thing_1.dsc").unlink()
        code, said = self.compare(one, two)
        self.assertEqual(code, 1)
        self.assertIn("source/thing_1.dsc", said)
        self.assertEqual(self.compare(self.folder / "tree", two)[0], 1, "nothing is not the same as something")


if __name__ == "__main__":
    unittest.main()
