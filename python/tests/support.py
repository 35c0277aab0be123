"""What the tests in this folder share. PYTHONPATH leads to the package that was built; VELUM_BATCH names the program."""
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

try:
    import numpy
except ImportError:
    print("numpy is not installed: skipped")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("VELUM_BATCH", "velum-batch")


class Case(unittest.TestCase):
    """A test with a folder of its own, removed at the end."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="velum-python-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def run_program(self, *command, code=0, **options):
        """What a program writes to stdout; its exit code is checked."""
        done = subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=300, cwd=self.folder, **options)
        self.assertEqual(done.returncode, code, f"{command}\n{done.stdout}{done.stderr}")
        return done.stdout

    def run_python(self, text, **options):
        return self.run_program(sys.executable, "-c", text, **options)

    def sample(self, name="two-spheres", voxels=32):
        """Makes a small phantom and gives the volume's path; labels lie beside it."""
        path = self.folder / f"{name}.nrrd"
        self.run_program(PROGRAM, "sample", name, "-o", path, "--voxels", voxels)
        return path


def ball(side=32, inside=1000, outside=0, dtype="int16"):
    """Voxels of a ball of half the side."""
    z, y, x = numpy.ogrid[:side, :side, :side]
    middle = (side - 1) / 2
    distance = (x - middle) ** 2 + (y - middle) ** 2 + (z - middle) ** 2
    return numpy.where(distance < (side / 4) ** 2, inside, outside).astype(dtype)


def read_png(data):
    """The pixels of a PNG of 8 bits, by the definition of the format."""
    place, compressed = 8, b""
    while place < len(data):
        length, name = struct.unpack(">I4s", data[place:place + 8])
        chunk = data[place + 8:place + 8 + length]
        if name == b"IHDR":
            width, height, bits, kind = struct.unpack(">IIBB", chunk[:10])
        if name == b"IDAT":
            compressed += chunk
        place += 12 + length
    assert bits == 8
    channels = {0: 1, 2: 3, 6: 4}[kind]
    rows = numpy.frombuffer(zlib.decompress(compressed), numpy.uint8).reshape(height, -1).astype(int)
    pixels = numpy.zeros((height + 1, width + 1, channels), int)  # a row and a column of zeros before the first
    for y in range(height):
        how, row = rows[y, 0], rows[y, 1:].reshape(width, channels)
        for x in range(width):
            left, up, corner = pixels[y + 1, x], pixels[y, x + 1], pixels[y, x]
            near = left + up - corner
            by = [abs(near - left), abs(near - up), abs(near - corner)]
            paeth = numpy.where((by[0] <= by[1]) & (by[0] <= by[2]), left, numpy.where(by[1] <= by[2], up, corner))
            guess = [0, left, up, (left + up) // 2, paeth][how]
            pixels[y + 1, x + 1] = (row[x] + guess) % 256
    return pixels[1:, 1:].astype(numpy.uint8)
