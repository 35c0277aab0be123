"""Kills the window with SIGKILL VELUM_KILLS times (50) at random moments while a script edits; every restart must offer the work, and
no edit that is older than a second may be missing."""
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

VELUM, BATCH = os.environ["VELUM"], os.environ["VELUM_BATCH"]
KILLS, LANES, LONGEST = int(os.environ.get("VELUM_KILLS", "50")), 2, 1.8
MOST_LOST_SECONDS = 1.0


class Lane(threading.Thread):
    """One user, with folders of its own: starts, edits, is killed, starts again. Each run edits a cut of its own."""

    def __init__(self, number, folder):
        super().__init__()
        self.random = random.Random(number)
        self.folder = folder / f"lane{number}"
        self.folder.mkdir()
        runtime = self.folder / "run"
        runtime.mkdir(mode=0o700)
        self.environment = {**os.environ, "XDG_STATE_HOME": str(self.folder / "state"),
                            "XDG_CONFIG_HOME": str(self.folder / "config"), "XDG_RUNTIME_DIR": str(runtime)}
        self.failures, self.lost, self.found = [], [], []

    def batch(self, *arguments):
        return subprocess.run([BATCH, *map(str, arguments)], cwd=self.folder, env=self.environment, timeout=60,
                              capture_output=True, check=True).stdout

    def start_window(self, lines):
        script = self.folder / "script.vel"
        script.write_text("\n".join(lines))
        return subprocess.Popen([VELUM, "--script", script, "--echo"], cwd=self.folder, env=self.environment,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def run_once(self, turn):
        """@return when each edit was done, when it was killed, what it had said on stderr"""
        lines = ["size 420 320", "recover" if turn else "open two-spheres.nrrd",
                 'set cuts.+ {"name": "run", "enabled": false}']
        for i in range(1, 1000):
            lines += [f"set cuts.{turn}.centre {i},0,0", f"wait {self.random.choice((0, 5, 30, 120))}"]
        window = self.start_window(lines)
        watchdog = threading.Timer(60, window.kill)
        watchdog.start()
        done = {}

        def take(line):
            said, _, step = line.partition(": ")
            words = step.split()
            if len(words) == 3 and words[1].endswith("centre"):
                done[int(words[2].split(",")[0])] = float(said.split()[0])
            return words

        for line in window.stdout:
            if take(line)[:2] == ["set", "cuts.+"]:
                break
        time.sleep(self.random.uniform(0.0, LONGEST))
        killed = time.monotonic()
        window.send_signal(signal.SIGKILL)
        for line in window.stdout:
            if line.endswith("\n"):
                take(line)
        watchdog.cancel()
        said = window.stderr.read()
        window.stdout.close()
        window.stderr.close()
        window.wait()
        return done, killed, said

    def check(self, turn, done, killed, said):
        work = json.loads(self.batch("recover", "--list", "--json"))["work"]
        if len(work) != 1 or not work[0]["readable"]:
            return self.failures.append(f"run {turn}: {len(work)} works are offered; the window said: {said}")
        self.batch("recover", "-o", "found.json")
        cuts = json.loads((self.folder / "found.json").read_text())["cuts"]
        if len(cuts) == turn:  # killed before the cut itself was a second old
            cuts.append({"centre": [0, 0, 0]})
            if any(killed - when > MOST_LOST_SECONDS for when in done.values()):
                self.failures.append(f"run {turn}: the cut is missing")
        found = int(cuts[turn]["centre"][0])
        self.found.append(found)
        if found + 1 in done:
            self.lost.append(killed - done[found + 1])
        if self.lost and self.lost[-1] > MOST_LOST_SECONDS:
            self.failures.append(f"run {turn}: an edit that was {self.lost[-1]:.2f} s old is missing")
        if done and found > max(done) + 1:
            self.failures.append(f"run {turn}: {found} is from the future")

    def run(self):
        try:
            self.batch("sample", "two-spheres", "-o", "two-spheres.nrrd", "--voxels", 16)
            for turn in range(KILLS // LANES):
                self.check(turn, *self.run_once(turn))
                if self.failures:
                    return
            # What the windows restored, one after the other, is what was found after each kill.
            window = self.start_window(["recover", "save last.json", "quit"])
            _, said = window.communicate(timeout=60)
            if window.returncode:
                return self.failures.append(f"the last start: {said}")
            last = [int(cut["centre"][0]) for cut in json.loads((self.folder / "last.json").read_text())["cuts"]]
            if last[:len(self.found)] != self.found:
                self.failures.append(f"restored {last}, found {self.found}")
            if json.loads(self.batch("recover", "--list", "--json"))["work"]:
                self.failures.append("saved work is still offered")
        except Exception as error:  # a thread must tell the test
            self.failures.append(repr(error))


class Kill(unittest.TestCase):
    def test_no_edit_older_than_a_second_is_lost(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="velum-kill-"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        lanes = [Lane(number, folder) for number in range(LANES)]
        for lane in lanes:
            lane.start()
        for lane in lanes:
            lane.join()
        failures = [f"lane {i}: {text}" for i, lane in enumerate(lanes) for text in lane.failures]
        self.assertEqual(failures, [])
        self.assertEqual(sum(len(lane.found) for lane in lanes), KILLS)
        lost = sorted(second for lane in lanes for second in lane.lost)
        print(f"{KILLS} kills; lost at most {lost[-1] if lost else 0:.3f} s, in {len(lost)} runs anything",
              file=sys.stderr)


if __name__ == "__main__":
    unittest.main()
