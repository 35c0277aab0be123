"""How the window begins and ends where the machine does not give what it needs: no display, no OpenGL, a disk that is
full, a system that wants it to end."""
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

VELUM, BATCH = os.environ["VELUM"], os.environ["VELUM_BATCH"]
DISPLAYS = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")


class WindowTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="velum-start-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        runtime = self.folder / "run"
        runtime.mkdir(mode=0o700)
        self.environment = {**os.environ, "XDG_STATE_HOME": str(self.folder / "state"), "XDG_RUNTIME_DIR": str(runtime),
                            "XDG_CONFIG_HOME": str(self.folder / "config"), "XDG_CACHE_HOME": str(self.folder / "cache")}

    def batch(self, *arguments, **options):
        return subprocess.run([BATCH, *map(str, arguments)], cwd=self.folder, env=self.environment, timeout=60,
                              capture_output=True, check=True, text=True, **options).stdout

    def script(self, *lines):
        path = self.folder / "script.vel"
        path.write_text("\n".join(lines))
        return path

    def start(self, *arguments, **options):
        window = subprocess.Popen([VELUM, *map(str, arguments)], cwd=self.folder, env=self.environment, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
        self.addCleanup(window.stdout.close)
        self.addCleanup(window.stderr.close)
        self.addCleanup(window.wait)
        self.addCleanup(window.kill)
        return window

    def wait_for(self, window, words):
        """Until --echo says that such a line is done."""
        for line in window.stdout:
            if words in line:
                return
        self.fail(f"the window ended before '{words}': {window.stderr.read()}")

    def lost_work(self):
        return json.loads(self.batch("recover", "--list", "--json"))["work"]


class ContextTest(WindowTest):
    """The program chooses how to draw, whatever draws in other tests."""

    def setUp(self):
        super().setUp()
        for name in ("VELUM_CONTEXT", "MESA_LOADER_DRIVER_OVERRIDE"):
            self.environment.pop(name, None)


class WithoutOpenGl(ContextTest):
    def refused(self, without, words, **changes):
        """Whatever it is started for: one line, exit code 3."""
        self.batch("sample", "two-spheres", "-o", "a.nrrd", "--voxels", 16)
        script = self.script("open a.nrrd", "settle", "quit")
        for name in without:
            self.environment.pop(name, None)
        self.environment.update(changes)
        for arguments in (["--script", script, "a.nrrd"], ["--screenshot", "a.png", "a.nrrd"]):
            with self.subTest(arguments=arguments[0]):
                window = self.start(*arguments)
                _, said = window.communicate(timeout=60)
                self.assertEqual(window.returncode, 3, said)
                self.assertEqual(said.count("\n"), 1, said)
                self.assertTrue(said.startswith("velum: "), said)
                for word in words:
                    self.assertIn(word, said)
        self.assertFalse((self.folder / "a.png").exists())

    def test_no_display(self):
        self.refused(DISPLAYS, ["no display", "neither DISPLAY nor WAYLAND_DISPLAY is set", "velum-batch"])

    def test_no_display_and_nothing_to_do(self):
        for name in DISPLAYS:
            self.environment.pop(name, None)
        window = self.start()
        _, said = window.communicate(timeout=60)
        self.assertEqual((window.returncode, said.count("\n")), (3, 1), said)

    def test_a_display_that_does_not_answer(self):
        self.refused(DISPLAYS, ["no display", ":4711"], DISPLAY=":4711")

    def test_a_wayland_that_does_not_answer(self):
        self.refused(DISPLAYS, ["no display"], WAYLAND_DISPLAY="wayland-4711")

    def test_a_platform_that_there_is_not(self):
        self.refused(DISPLAYS, ["no display", "paper"], QT_QPA_PLATFORM="paper")

    def test_no_driver(self):
        self.refused((), ["EGL", "OpenGL 4.5", "libgl1-mesa-dri"], LIBGL_DRIVERS_PATH="/nonexistent", VELUM_CONTEXT="egl")

    def test_a_software_driver_that_is_too_old_itself(self):
        self.refused((), ["llvmpipe", "OpenGL 3.3", "4.5 is needed", "it was tried"], MESA_GL_VERSION_OVERRIDE="3.3")

    def test_a_user_is_told_in_a_dialog(self):
        self.environment.update(LIBGL_DRIVERS_PATH="/nonexistent", VELUM_CONTEXT="egl")
        window = self.start()
        self.assertIn("OpenGL", window.stderr.readline())
        time.sleep(1.0)
        self.assertIsNone(window.poll(), "it waits until the dialog is closed")


class BesideTheWindowSystem(ContextTest):
    """Where the window system has no OpenGL 4.5 the 3D view is drawn by a context of its own, and all else is as always."""

    def started(self, words, **changes):
        self.batch("sample", "two-spheres", "-o", "a b.nrrd", "--voxels", 16)
        self.environment.update(changes)
        script = self.script("settle", "picture 40x30 made.png", "save made.json", "quit")
        window = self.start("-style", "fusion", "--script", script, "a b.nrrd")
        _, said = window.communicate(timeout=120)
        self.assertEqual(window.returncode, 0, said)
        ours = [line for line in said.splitlines() if line and not line.startswith("libEGL warning: ")]
        self.assertEqual(len(ours), 1, said)
        for word in (*words, "4.5 is needed", "software driver draws instead", "slower", "update"):
            self.assertIn(word, said)
        self.assertEqual(json.loads((self.folder / "made.json").read_text())["volume"]["source"]["path"], "a b.nrrd")
        self.batch("render", "made.json", "-o", "usual.png", "--size", "40x30")
        self.assertEqual((self.folder / "made.png").read_bytes(), (self.folder / "usual.png").read_bytes())

    def test_a_driver_that_is_too_old(self):
        self.started(["warning: softpipe offers OpenGL 3.3"], GALLIUM_DRIVER="softpipe")

    def test_a_display_without_opengl(self):
        for platform in ("offscreen", "minimal"):
            self.started([f"this display ({platform}) gives windows no OpenGL"], QT_QPA_PLATFORM=platform)

    def test_no_driver_but_osmesa(self):
        self.started(["makes no OpenGL context"], LIBGL_DRIVERS_PATH="/nonexistent")

    def test_a_driver_that_does_not_start(self):
        self.started(["makes no OpenGL context"], GALLIUM_DRIVER="nonsense", LIBGL_ALWAYS_SOFTWARE="1")

    def test_the_window_says_so_too(self):
        self.batch("sample", "two-spheres", "-o", "a.nrrd", "--voxels", 16)
        self.environment["GALLIUM_DRIVER"] = "softpipe"
        window = self.start("--screenshot", "window.png", "a.nrrd")
        _, said = window.communicate(timeout=120)
        self.assertEqual(window.returncode, 0, said)
        # What the bar above the views shows is said as well.
        self.assertEqual(said.count("softpipe offers OpenGL 3.3, and OpenGL 4.5 is needed"), 2, said)
        self.assertTrue((self.folder / "window.png").exists())

    def test_the_bare_window_does_so_too(self):
        self.batch("sample", "two-spheres", "-o", "a b.nrrd", "--voxels", 16)
        self.environment["GALLIUM_DRIVER"] = "softpipe"
        window = subprocess.Popen([BATCH, "view", "a b.nrrd", "--size", "160x120", "--verbose"], cwd=self.folder, env=self.environment,
                                  text=True, stderr=subprocess.PIPE)
        self.addCleanup(window.stderr.close)
        self.addCleanup(window.kill)
        said = ""
        # The second driver that is told of is that of the window, the first one that of the check before it.
        while said.count("OpenGL: llvmpipe") < 2:
            line = window.stderr.readline()
            self.assertTrue(line, said)
            said += line
        window.send_signal(signal.SIGTERM)
        _, rest = window.communicate(timeout=60)
        self.assertEqual(window.returncode, 128 + signal.SIGTERM, rest)
        self.assertEqual(said.count("warning: softpipe offers OpenGL 3.3, and OpenGL 4.5 is needed"), 1, said)
        self.assertIn("velum-batch: stopped", rest)


class MadeToEnd(WindowTest):
    LINES = ("size 500 400", "open a.nrrd", "set volume.windowLevel 17")

    def setUp(self):
        super().setUp()
        self.batch("sample", "two-spheres", "-o", "a.nrrd", "--voxels", 16)

    def edit(self, *more, **options):
        window = self.start("--echo", "--script", self.script(*self.LINES, *more, "wait 0"), **options)
        self.wait_for(window, "wait 0")
        return window

    def end(self, window, number):
        window.send_signal(number)
        _, said = window.communicate(timeout=60)
        self.assertEqual(window.returncode, 128 + number, said)
        self.assertEqual(said, "")

    def test_edits_are_offered_again(self):
        for turn, number in enumerate((signal.SIGTERM, signal.SIGINT, signal.SIGHUP), 1):
            self.end(self.edit(f"set volume.windowWidth {turn}"), number)
            work = self.lost_work()
            self.assertEqual([one["readable"] for one in work], [True] * turn)
            # The newest first.
            self.batch("recover", "-o", "found.json")
            volume = json.loads((self.folder / "found.json").read_text())["volume"]
            self.assertEqual((volume["windowLevel"], volume["windowWidth"]), (17, turn))

    def test_views_alone_are_not_offered(self):
        window = self.start("--echo", "--script", self.script("open a.nrrd", "do view.left", "wait 0"))
        self.wait_for(window, "wait 0")
        self.end(window, signal.SIGTERM)
        self.assertEqual(self.lost_work(), [])

    def test_what_is_being_written_leaves_nothing(self):
        before = sorted(path.name for path in self.folder.iterdir()) + ["script.vel"]
        window = self.start("--echo", "--script", self.script(*self.LINES, "wait 0", "picture 8000x8000 huge.png"))
        self.wait_for(window, "wait 0")
        time.sleep(0.5)
        self.end(window, signal.SIGTERM)
        self.assertFalse((self.folder / "huge.png").exists())
        made = {"config", "cache", "state"}
        self.assertEqual(sorted({path.name for path in self.folder.iterdir()} - made), sorted(set(before) - made))
        self.assertEqual(len(self.lost_work()), 1)

    def test_what_was_ignored_stays_ignored(self):
        """As under nohup."""
        window = self.edit("wait 1", preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        window.send_signal(signal.SIGHUP)
        time.sleep(0.5)
        self.assertIsNone(window.poll())
        self.end(window, signal.SIGTERM)

    def test_a_display_that_goes_leaves_the_work(self):
        xvfb = shutil.which("Xvfb")
        if not xvfb:
            self.skipTest("there is no Xvfb")
        ours, theirs = os.pipe()
        server = subprocess.Popen([xvfb, "-displayfd", str(theirs), "-screen", "0", "800x600x24", "-nolisten", "tcp"],
                                  pass_fds=[theirs], stderr=subprocess.DEVNULL)
        self.addCleanup(server.wait)
        self.addCleanup(server.kill)
        os.close(theirs)
        with open(ours) as told:
            self.environment["DISPLAY"] = ":" + told.readline().strip()
        self.environment.pop("XAUTHORITY", None)
        window = self.edit()
        time.sleep(0.3)
        server.terminate()
        _, said = window.communicate(timeout=60)
        self.assertGreater(window.returncode, 0, said)
        self.assertEqual([one["readable"] for one in self.lost_work()], [True])


class FullDisk(WindowTest):
    """A limit of the size of files stands in for a disk that is full."""
    LIMIT = 2000

    def setUp(self):
        super().setUp()
        self.batch("sample", "two-spheres", "-o", "a.nrrd", "--voxels", 16)

    def limited(self):
        # A driver's cache of shaders writes, too, and has to bear it.
        resource.setrlimit(resource.RLIMIT_FSIZE, (self.LIMIT, self.LIMIT))

    def refused(self, target, *lines):
        path = self.folder / target
        path.write_bytes(b"the old file")
        window = self.start("--script", self.script("open a.nrrd", "set volume.windowLevel 17", *lines, "quit"),
                            preexec_fn=self.limited)
        _, said = window.communicate(timeout=120)
        self.assertEqual(window.returncode, 2, said)
        self.assertIn(target, said)
        self.assertEqual(path.read_bytes(), b"the old file")
        self.assertEqual(list(self.folder.glob(".velum-*")), [])

    def test_a_scene(self):
        self.refused("scene.json", "save scene.json")

    def test_a_picture(self):
        self.refused("picture.png", "picture 64x64 picture.png")

    def test_a_picture_of_the_window(self):
        self.refused("window.png", "screenshot window.png")
        window = self.start("--screenshot", "window.png", preexec_fn=self.limited)
        _, said = window.communicate(timeout=120)
        self.assertEqual(window.returncode, 2, said)
        self.assertIn("window.png", said)
        self.assertEqual((self.folder / "window.png").read_bytes(), b"the old file")

    def test_streams_that_take_nothing_stop_nothing(self):
        script = self.script("open a.nrrd", *["wait 0"] * 400, "save scene.json", "quit")
        with open("/dev/full", "wb") as full:
            done = subprocess.run([VELUM, "--echo", "--script", script], cwd=self.folder, env=self.environment,
                                  timeout=60, stdout=full, stderr=full, check=False)
            self.assertEqual(done.returncode, 0)
            self.assertTrue((self.folder / "scene.json").exists())
            done = subprocess.run([VELUM, "none.nrrd"], cwd=self.folder, env=self.environment, timeout=60, stdout=full,
                                  stderr=full, check=False)
            self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
