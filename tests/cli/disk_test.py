"""What velum-batch leaves behind when the disk is full, when it is stopped, and where it may not write."""
import os
import pathlib
import random
import resource
import shutil
import signal
import stat
import subprocess
import tempfile
import time
import unittest

from velum_cli import PROGRAM, CliTest

FAST = ["--samples", "1", "--set", "lighting.shaded=false"]
OLD = b"a file that was good"


class SmallDisk:
    """A file system of a few pages where one may be mounted; else a limit on the length of files. fill(n) leaves room for n bytes."""

    SIZE = 4 << 20

    def __init__(self, test):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="velum-disk-"))
        test.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        mount = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={self.SIZE}", "tmpfs", self.folder], capture_output=True)
        self.is_mounted = mount.returncode == 0
        self.limit = None
        if self.is_mounted:
            test.addCleanup(subprocess.run, ["umount", "-l", self.folder], capture_output=True)

    def fill(self, room):
        """The next run finds room for so many bytes; a file system counts in pages."""
        if not self.is_mounted:
            self.limit = room
            return
        filler = self.folder / "filler"
        filler.unlink(missing_ok=True)
        state = os.statvfs(self.folder)
        free = state.f_bavail * state.f_frsize - room
        with open(filler, "wb") as file:
            os.posix_fallocate(file.fileno(), 0, max(1, free))

    def limits(self):
        """To be called in the child."""
        if self.limit is not None:
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (self.limit, resource.RLIM_INFINITY))

    def names(self):
        return sorted(path.name for path in self.folder.iterdir() if path.name != "filler")


class FullDisk(CliTest):
    def run_there(self, disk, arguments):
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, cwd=disk.folder, timeout=120,
                              preexec_fn=disk.limits)
        lines = [line for line in done.stderr.decode().splitlines() if not line.startswith(("warning: ", "note: "))]
        return done.returncode, lines

    def check(self, *arguments, outputs, times):
        """At whatever byte the disk is full: exit code 2, one line, each file the old one or a whole one, and nothing else."""
        disk = SmallDisk(self)
        code, lines = self.run_there(disk, arguments)
        self.assertEqual(code, 0, lines)
        self.assertEqual(disk.names(), sorted(outputs))
        whole = {name: (disk.folder / name).read_bytes() for name in outputs}
        pages = sum((len(data) + 4095) // 4096 for data in whole.values())
        dice = random.Random(3)
        failures = 0
        for _ in range(times):
            for name in outputs:
                (disk.folder / name).write_bytes(OLD)
            # An old file needs a page, and so does the new one until it has its name.
            disk.fill(4096 * dice.randrange(pages) if disk.is_mounted else dice.randrange(max(map(len, whole.values()))))
            code, lines = self.run_there(disk, arguments)
            left = {name: (disk.folder / name).read_bytes() for name in outputs}
            self.assertEqual(disk.names(), sorted(outputs), "leftovers")
            for name in outputs:
                self.assertIn(left[name], (OLD, whole[name]), name)
            if code == 0:
                self.assertEqual(left, whole)
                continue
            failures += 1
            self.assertEqual(code, 2, lines)
            self.assertEqual(len(lines), 1, lines)
            self.assertNotEqual(left, whole)
            disk.limit = None
            (disk.folder / "filler").unlink(missing_ok=True)
        self.assertGreater(failures, 0, "the disk was never full")

    def test_render(self):
        volume = self.sample()
        size = ["--size", "160x120", *FAST]
        self.check("render", volume, "-o", "x.png", *size, outputs=["x.png"], times=5)
        self.check("render", volume, "-o", "x.exr", "--layers", *size, outputs=["x.exr"], times=5)
        self.check("render", volume, "-o", "x.tif", "--section", "axial", *size, outputs=["x.tif"], times=5)
        self.check("render", volume, "-o", "x.png", "--save-scene", "x.json", *size, outputs=["x.png", "x.json"], times=5)

    def test_a_film_goes_on_where_there_is_room_again(self):
        film = ["film", self.sample(), "-o", "x.png", "--frames", "3", "--size", "160x120", *FAST]
        disk = SmallDisk(self)
        self.assertEqual(self.run_there(disk, film)[0], 0)
        whole = {path.name: path.read_bytes() for path in disk.folder.glob("x-*.png")}
        self.assertEqual(len(whole), 3)
        for path in disk.folder.iterdir():
            path.unlink()
        sizes = list(map(len, whole.values()))
        disk.fill(sum(sizes) // 2 if disk.is_mounted else min(sizes) // 2)
        code, lines = self.run_there(disk, film)
        self.assertEqual((code, len(lines)), (2, 1), lines)
        there = {path.name: path.read_bytes() for path in disk.folder.glob("x-*.png")}
        self.assertLess(len(there), 3)
        self.assertLessEqual(there.items(), whole.items())
        disk.limit = None
        (disk.folder / "filler").unlink(missing_ok=True)
        self.assertEqual(self.run_there(disk, [*film, "--resume"])[0], 0)
        self.assertEqual({path.name: path.read_bytes() for path in disk.folder.glob("x-*.png")}, whole)

    def test_layers_beside_a_picture(self):
        volume = self.sample()
        arguments = ["render", volume, "-o", "x.png", "--layers", "--size", "160x120", *FAST]
        self.run_batch(*arguments, cwd=self.folder)
        names = [path.name for path in self.folder.iterdir() if path.name.startswith("x")]
        self.assertGreater(len(names), 3)
        self.check(*arguments, outputs=names, times=5)

    def test_convert(self):
        volume = self.sample("torso", 48)
        for ending in ("nrrd", "nii", "nii.gz", "vti", "vdb"):
            with self.subTest(ending=ending):
                self.check("convert", volume, f"x.{ending}", outputs=[f"x.{ending}"], times=4)

    def test_sample(self):
        self.check("sample", "two-spheres", "-o", "x.nrrd", "--voxels", "32", outputs=["x.nrrd", "x_labels.seg.nrrd"], times=4)

    def test_sheets(self):
        volume = self.sample()
        for ending in ("ply", "vtp"):
            with self.subTest(ending=ending):
                self.check("membrane", volume, "--protect", "0.5,2", "--axis", "0,-1,0", "--sheet", f"x.{ending}",
                           outputs=[f"x.{ending}"], times=2)

    def test_a_report_that_cannot_be_printed_is_an_error(self):
        with open("/dev/full", "wb") as full:
            done = subprocess.run([PROGRAM, "info", self.sample(), "--json"], stdout=full, stderr=subprocess.PIPE, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(len(done.stderr.decode().splitlines()), 1)


class Places(CliTest):
    def test_a_link_stays_and_its_target_is_written(self):
        volume = self.sample()
        (self.folder / "there").mkdir()
        (self.folder / "x.nii").symlink_to("there/y.nii")
        self.run_batch("convert", volume, "x.nii")
        self.assertTrue((self.folder / "x.nii").is_symlink())
        self.assertEqual(self.report("info", self.folder / "there" / "y.nii")["dims"], self.report("info", volume)["dims"])

    def test_the_mode_of_the_old_file_is_kept(self):
        volume = self.sample()
        (self.folder / "x.nii").write_bytes(OLD)
        (self.folder / "x.nii").chmod(0o640)
        self.run_batch("convert", volume, "x.nii")
        self.assertEqual(stat.S_IMODE((self.folder / "x.nii").stat().st_mode), 0o640)

    def test_what_may_not_be_replaced_is_refused(self):
        volume = self.sample()
        (self.folder / "x.nii").write_bytes(OLD)
        (self.folder / "x.nii").chmod(0o444)
        self.refuse("convert", volume, "x.nii", code=2, words=["read-only"])
        self.assertEqual((self.folder / "x.nii").read_bytes(), OLD)
        os.mkfifo(self.folder / "y.nii")
        self.refuse("convert", volume, "y.nii", code=2, words=["no regular file"])


class Stopped(CliTest):
    def stop(self, name):
        """Sends it in the midst of a film; gives the exit code."""
        folder = self.folder / name.name
        folder.mkdir()
        run = subprocess.Popen([PROGRAM, "film", self.sample(), "-o", "turn.png", "--frames", "9999", "--size", "200x150"],
                               cwd=folder, stderr=subprocess.PIPE)
        for _ in range(600):
            if list(folder.glob("turn-*.png")):
                break
            time.sleep(0.1)
        run.send_signal(name)
        said = run.communicate(timeout=60)[1].decode()
        self.assertTrue(said.endswith("velum-batch: stopped\n"), said)
        self.assertTrue(all(item.startswith("turn") for item in os.listdir(folder)), os.listdir(folder))
        return run.returncode

    def test_signals_stop_it_in_order(self):
        for name in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(name=name.name):
                self.assertEqual(self.stop(name), 128 + name)

    def test_what_a_killed_run_left_goes_with_the_next(self):
        volume = self.sample()
        left = self.folder / ".velum-0123456789abcdef-x.nii"
        left.write_bytes(b"half")
        own = self.folder / ".velum-mine"
        own.write_bytes(b"a user's")
        self.run_batch("convert", volume, "x.nii")
        self.assertFalse(left.exists())
        self.assertTrue(own.exists())


if __name__ == "__main__":
    unittest.main()
