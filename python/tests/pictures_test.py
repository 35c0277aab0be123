"""Pictures: bytes, layers, arithmetic, and the environments in which they are drawn."""
import os
import subprocess
import sys
import unittest
import warnings

from support import PROGRAM, Case, ball, numpy, read_png

import velum

SMALL = (96, 72)
DRAW = """
import hashlib, numpy, velum
z, y, x = numpy.ogrid[:16, :16, :16]
s = velum.open(((x - 8) ** 2 + (y - 8) ** 2 + (z - 8) ** 2 < 30) * numpy.uint8(200))
s.cut("plane", face="section")
image = s.render(96, 72, samples=1)
assert image.std() > 5
print(hashlib.sha256(image.tobytes()).hexdigest())
"""


class Environments(Case):
    def test_a_virtual_environment_with_system_packages(self):
        self.run_program(sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", "there")
        said = self.run_program(self.folder / "there/bin/python", "-c", f"import sys; print(sys.prefix, end=' '){DRAW}")
        self.assertEqual(said, f"{self.folder / 'there'} {self.run_python(DRAW)}")

    def test_a_driver_that_is_too_old(self):
        """Mesa's softpipe is a driver of OpenGL 3.3: the software driver draws instead, and one line says so."""
        environment = {k: v for k, v in os.environ.items() if k not in ("VELUM_CONTEXT", "MESA_LOADER_DRIVER_OVERRIDE")}
        usual = self.run_python(DRAW, env=environment)
        if "llvmpipe" not in self.run_program(PROGRAM, "render", self.sample(), "-o", "a.png", "--size", "32x24", "--samples", "1", "--json",
                                              env=environment):
            self.skipTest("the machine's driver is not the one that stands in")
        done = subprocess.run([sys.executable, "-c", DRAW], capture_output=True, text=True, timeout=300, cwd=self.folder,
                              env={**environment, "GALLIUM_DRIVER": "softpipe"})
        self.assertEqual((done.returncode, done.stdout), (0, usual), done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for word in ("warning: softpipe offers OpenGL 3.3", "4.5 is needed", "software driver draws instead"):
            self.assertIn(word, done.stderr)


class Pictures(Case):
    def test_bytes_are_those_of_the_file(self):
        with velum.open(self.sample()) as session:
            session["rayCast.samplesPerPixel"] = 1
            session.cut("plane", face="section")
            session.picture("96x72", self.folder / "a.png")
            image = session.render(*SMALL)
            self.assertEqual((image.shape, image.dtype, type(image)), ((72, 96, 3), numpy.uint8, velum.Image))
            numpy.testing.assert_array_equal(read_png((self.folder / "a.png").read_bytes()), image)
            numpy.testing.assert_array_equal(read_png(image._repr_png_()), image)
            self.assertGreater(image.std(), 5)
            fine = session.render(*SMALL, dtype="float32")
            self.assertEqual(fine.dtype, numpy.float32)
            numpy.testing.assert_allclose(fine * 255, image, atol=1.01)  # bytes are dithered
            numpy.testing.assert_allclose(read_png(fine._repr_png_()), fine * 255, atol=0.51)
            clear = session.render(*SMALL, transparent=True)
            self.assertEqual(clear.shape, (72, 96, 4))
            self.assertEqual(clear[0, 0, 3], 0)
            numpy.testing.assert_array_equal(read_png(clear._repr_png_()), clear)
            self.assertEqual(session.render(*SMALL, section="axial").shape, (72, 96, 3))
            for wrong in ({"section": "diagonal"}, {"samples": 300}):
                with self.assertRaises(velum.ArgumentError):
                    session.render(*SMALL, **wrong)
            with self.assertRaises(velum.ArgumentError):
                session.render(0, 72)

    def test_layers_know_where_the_ball_is(self):
        with velum.open(ball(side=48, inside=1000), spacing=(1, 1, 1), origin=(-23.5, -23.5, -23.5)) as session:
            session["rayCast.mode"] = "iso"
            session["rayCast.isoValue"] = 500
            session.view.from_("anterior", aspect=SMALL[0] / SMALL[1])
            layers = session.layers(*SMALL, samples=1)
        self.assertLessEqual({"color", "Z", "normal", "position"}, set(layers))
        self.assertEqual(layers["color"].shape, (72, 96, 4))
        hit = numpy.isfinite(layers["Z"])
        self.assertGreater(hit.mean(), 0.05)
        self.assertLess(hit.mean(), 0.95)
        numpy.testing.assert_allclose(numpy.linalg.norm(layers["position"][hit], axis=1), 12, atol=0.8)
        numpy.testing.assert_allclose(numpy.linalg.norm(layers["normal"][hit], axis=1), 1, atol=0.02)

    def test_nothing_of_a_window_or_a_driver_is_loaded_before_something_is_drawn(self):
        said = self.run_python("""
import numpy, velum
s = velum.open(numpy.arange(8 ** 3, dtype="uint16").reshape(8, 8, 8))
s.cut("plane"); s["rayCast.mode"] = "mip"; s.measure()
names = {line.split("/")[-1].strip() for line in open("/proc/self/maps") if ".so" in line}
print(*[name for name in names if any(part in name for part in ("Qt", "EGL", "libGL", "OSMesa", "_dri", "gallium"))])
""", env={**os.environ, "DISPLAY": "", "WAYLAND_DISPLAY": ""})
        self.assertEqual(said.strip(), "")


class Arithmetic(Case):
    """What is computed of a picture is one, or is a plain array or a number."""

    def setUp(self):
        super().setUp()
        random = numpy.random.default_rng(1)
        self.plain = random.integers(0, 255, (7, 5, 3)).astype("uint8")
        self.image = self.plain.view(velum.Image)

    def test_numbers_are_numbers(self):
        for name in ("mean", "sum", "min", "max", "std", "var", "any", "all", "argmax", "prod"):
            found = getattr(self.image, name)()
            self.assertIsInstance(found, (numpy.generic, int), name)
            self.assertEqual(found, getattr(self.plain, name)(), name)
        for function in (numpy.mean, numpy.median, numpy.sum, numpy.linalg.norm, numpy.percentile):
            arguments = (50,) if function is numpy.percentile else ()
            image = self.image.ravel() if function is numpy.linalg.norm else self.image
            self.assertEqual(repr(function(image, *arguments)), repr(function(numpy.asarray(image), *arguments)), function)
        self.assertEqual(type(self.image[1, 2, 0]), numpy.uint8)

    def test_what_is_no_picture_is_a_plain_array(self):
        for part in (self.image.mean(axis=2), self.image > 100, self.image[..., 0], self.image[2], self.image.max(axis=(0, 1)), numpy.isnan(self.image / 2.0),
                     self.image[self.image > 100]):
            self.assertIs(type(part), numpy.ndarray)
        for picture in (self.image[::2], self.image // 2, self.image.astype(int) - self.image, self.image / 255, numpy.clip(self.image, 3, 9), self.image[:, ::-1],
                        self.image.copy()):
            self.assertIs(type(picture), velum.Image)
            self.assertIsNotNone(picture._repr_png_())
        changed = self.image.copy()
        changed += 1
        changed[0] = 7
        self.assertIs(type(changed), velum.Image)
        numpy.testing.assert_array_equal(changed[1:], self.plain[1:] + 1)

    def test_whole_numbers_are_shown_from_0_to_255(self):
        other = self.plain[::-1].view(velum.Image)
        difference = abs(self.image.astype(int) - other)
        numpy.testing.assert_array_equal(read_png(difference._repr_png_()), difference)
        for dtype in ("int16", "int32", "int64"):
            numpy.testing.assert_array_equal(read_png((self.image.astype(dtype) * 2 - 100)._repr_png_()), numpy.clip(self.plain.astype(int) * 2 - 100, 0, 255))
        numpy.testing.assert_array_equal(read_png((self.image / 255)._repr_png_()), self.plain)
        bad = (self.image / 255).astype("float32")
        bad[0, 0] = numpy.nan, numpy.inf, -numpy.inf
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            numpy.testing.assert_array_equal(read_png(bad._repr_png_())[0, 0], (0, 255, 0))


if __name__ == "__main__":
    unittest.main()
