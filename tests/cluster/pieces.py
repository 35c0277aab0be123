"""What the tests of clusters share: many small data sets, their pictures by one process, and counting."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ.get("VELUM_BATCH", "velum-batch")
COUNT = 60
# Enough work for a piece that it can be stopped in its middle.
WORDS = ["studies/*/ct.nrrd", "--size", "96x64", "--samples", "1"]


def name_of(i):
    return f"p{i:02}"


def programs_in(folder):
    """Processes of the program at work in a folder, with their words and variables."""
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if os.path.basename(os.readlink(process / "exe")) == os.path.basename(PROGRAM) and os.path.samefile(process / "cwd", folder):
                yield int(process.name), (process / "cmdline").read_text().split("\0"), (process / "environ").read_text().split("\0")
        except OSError:
            continue


def is_stopped(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] in "Tt"
    except OSError:
        return False


def pause(pid):
    """@return whether it rests now; not where it has ended"""
    try:
        os.kill(pid, signal.SIGSTOP)
    except ProcessLookupError:
        return False
    end = time.monotonic() + 10
    while os.path.exists(f"/proc/{pid}") and time.monotonic() < end:
        if is_stopped(pid):
            return True
        time.sleep(0.001)
    return False


class PiecesTest(unittest.TestCase):
    """A folder with data sets and a whole of pictures that one process has made."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="velum-cluster-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        for i in range(COUNT):
            folder = cls.folder / f"studies/{name_of(i)}"
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

    def record(self, folder, name):
        """What the record of a piece tells, in order: "begun", "done" ..."""
        try:
            text = (self.folder / folder / f"pieces/{name}.png.jsonl").read_text()
        except FileNotFoundError:
            return []
        return [next(iter(json.loads(line))) for line in text.splitlines() if line]

    def records(self, folder):
        return {name: self.record(folder, name) for name in map(name_of, range(COUNT))}

    def begun(self, folder, part, parts):
        """Pieces of a part that are begun and not ended."""
        return [name for name in map(name_of, range(part - 1, COUNT, parts)) if self.record(folder, name)[-1:] == ["begun"]]

    def kill_in_the_middle(self, folder, part, parts, after, is_it, has_ended):
        """Kills the process of a part while it makes a piece. @return the piece
        @param after  so many are done  @param is_it  whether words and variables are those of the process"""
        end, ask = time.monotonic() + 240, time.monotonic() + 1
        while time.monotonic() < end:
            if time.monotonic() > ask:
                ask = time.monotonic() + 1
                if has_ended():
                    break
            done = sum(self.record(folder, name)[-1:] == ["done"] for name in map(name_of, range(part - 1, COUNT, parts)))
            at_work = done >= after and self.begun(folder, part, parts) and [pid for pid, *told in programs_in(self.folder) if is_it(*told)]
            if at_work and pause(at_work[0]):
                held = self.begun(folder, part, parts)
                if held:
                    os.kill(at_work[0], signal.SIGKILL)
                    self.assertEqual(len(held), 1)
                    return held[0]
                os.kill(at_work[0], signal.SIGCONT)
            time.sleep(0.002)
        raise AssertionError(f"part {part} of {parts} was never caught in the middle of a piece")

    def assertLeft(self, before, killed):
        """Of what has been begun until now only what was killed has not ended."""
        self.assertEqual(sorted(name for name, told in before.items() if told == ["begun"]), sorted(killed))
        others = [told for name, told in before.items() if name not in killed]
        self.assertEqual([told for told in others if told not in ([], ["begun", "done"])], [])

    def assertOnlyRestMade(self, folder, before):
        """Since then each piece that was left was made once, and no other."""
        rest = {name: told if told[-1:] == ["done"] else [*told, "begun", "done"] for name, told in before.items()}
        self.assertEqual(self.records(folder), rest)

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
