"""The library as others use it: docs/example is built against what is installed, and nothing else."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/cli"))
from velum_cli import CliTest  # noqa: E402

CMAKE = os.environ["VELUM_CMAKE"]


class Example(CliTest):
    def run_all(self, *command):
        done = subprocess.run([*map(str, command)], capture_output=True, timeout=500, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout.decode(errors="replace") + done.stderr.decode(errors="replace"))
        return done.stdout.decode()

    def install(self):
        there = self.folder / "there"
        self.run_all(CMAKE, "--install", os.environ["VELUM_BUILD"], "--component", "library", "--prefix", there)
        # Elsewhere than it was installed to, as a package may be unpacked.
        return there.rename(self.folder / "moved")

    def test_a_program_of_others_draws_with_what_is_installed(self):
        there = self.install()
        self.run_all(CMAKE, "-S", ROOT / "docs/example", "-B", "example", f"-DCMAKE_PREFIX_PATH={there}")
        self.run_all(CMAKE, "--build", "example")
        said = self.run_all("example/example", self.sample(), "drawn.png", "film/")
        self.assertIn("drawn.png: 640 x 480 pixels, 1 cut", said)
        # It is what velum-batch draws of the scene that rides in it; and not a picture of nothing.
        self.run_batch("render", "drawn.png", "-o", "again.png", "--size", "640x480")
        self.run_batch("compare", "drawn.png", "again.png")
        self.assertGreater((self.folder / "drawn.png").stat().st_size, 4000)
        self.assertIn("film/: 6 of 6 frames", said)
        # A frame holds its moment as a scene of its own.
        frames = sorted(path.name for path in (self.folder / "film").glob("*.png"))
        self.assertEqual(len(frames), 6)
        middle = self.folder / "film" / frames[3]
        self.run_batch("render", middle, "-o", "moment.png", "--size", "160x120")
        self.run_batch("compare", middle, "moment.png")

    def test_the_python_package_finds_its_libraries(self):
        python = os.environ.get("VELUM_PYTHON")
        if not python:
            self.skipTest("the Python module is not built")
        there = self.install()
        self.run_all(CMAKE, "--install", os.environ["VELUM_BUILD"], "--component", "python", "--prefix", there)
        (package,) = there.glob("lib/python3/dist-packages")
        (self.folder / "a.py").write_text("import sys, numpy\nsys.path.insert(0, sys.argv[1])\nimport velum\nprint(velum.__file__)\n"
                                          "velum.open(numpy.arange(512.0).reshape(8, 8, 8)).picture('96x72', 'a.png')\n"
                                          "print([line.split()[-1] for line in open('/proc/self/maps') if 'libvelum' in line][0])\n")
        said = self.run_all(python, "a.py", package)
        self.assertTrue(all(line.startswith(str(there)) for line in said.splitlines()), said)
        self.assertTrue((self.folder / "a.png").exists())

    def test_all_headers_are_installed_with_what_they_include(self):
        there = self.install()
        headers = sorted(path.name for path in (there / "include/velum").glob("*.h"))
        self.assertEqual(headers, sorted(path.name for path in (ROOT / "include/velum").glob("*.h")))
        all_of_them = [word for name in headers for word in ("-include", f"velum/{name}")]
        self.run_all(os.environ["CXX"], "-std=c++20", "-fsyntax-only", "-DGLM_FORCE_CTOR_INIT", "-DGLM_ENABLE_EXPERIMENTAL",
                     f"-I{there}/include", f"-I{there}/include/velum/detail", *all_of_them, "-x", "c++", "/dev/null")


if __name__ == "__main__":
    unittest.main()
