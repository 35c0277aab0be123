"""Works in the window for a long time: random edits, opens, saves, pictures and undo, one script from one seed. Between rounds
nothing is open; there the memory is looked at. Fails when the window says or does what it should not, hangs, or holds more at
the end than after a while. Run by ./dev soak [minutes]."""
import argparse
import collections
import os
import pathlib
import random
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time

VELUM, BATCH = os.environ["VELUM"], os.environ["VELUM_BATCH"]
# Name, voxels along the longest axis, time steps.
PHANTOMS = (("two-spheres", 40, 0), ("torso", 64, 0), ("vessels", 48, 0), ("neurons", 48, 0), ("heart", 32, 4))
LOOKS = ("ct-bone", "ct-skin-bone", "mr-head")
REST = "wait 777"  # said by the script where nothing is open
MOST_GROWTH = {"allocated": 1.05, "resident": 1.25}  # the sanitizer's allocator keeps what each size needed at most
HANG_S = 600


class Author:
    """Writes the script. Counts the steps that can surely be undone."""

    def __init__(self, seed, folder):
        self.dice = random.Random(seed)
        self.folder = folder
        self.steps = self.cuts = self.membranes = 0
        self.scenes = []

    def number(self, low, high):
        return f"{self.dice.uniform(low, high):.6f}"

    def vector(self, low, high):
        return ",".join(self.number(low, high) for _ in range(3))

    def edit(self, line):
        self.steps += 1
        return [line]

    def cut(self, line):
        self.cuts += 1
        return self.edit(line)

    def any_edit(self, phantom):
        dice = self.dice
        choices = [
            lambda: self.edit(f"set volume.windowLevel {self.number(0, 500)}"),
            lambda: self.edit(f"set lighting.ambient {self.number(0, 1)}"),
            lambda: self.edit(f"set background.top {self.vector(0, 1)}"),
            lambda: [f"set rayCast.mode {dice.choice(('volume', 'mip', 'iso'))}"],
            lambda: [f"set lighting.shadow {dice.choice((0, 0.5))}"],
            lambda: [f"do view.{dice.choice(('anterior', 'posterior', 'left', 'right', 'superior', 'inferior', 'oblique', 'parallel', 'reset'))}"],
            lambda: [f"do layout.{dice.choice(('four', 'volume', 'beside', 'section'))}"],
            lambda: [f"do sections.{dice.choice(('next', 'previous'))}"],
            lambda: [f"open {dice.choice(LOOKS)}.velum-transfer.json"],
            lambda: [f"page {dice.choice(('look', 'cuts', 'structures'))}"],
            lambda: [f"size {dice.randrange(500, 900)} {dice.randrange(400, 700)}"],
            lambda: ["settle"],
            lambda: [f"wait {dice.randrange(200)}"],
            lambda: [f"picture {dice.randrange(16, 200)}x{dice.randrange(16, 200)} picture{dice.choice(('.png', '.exr', '.tif'))}"],
            lambda: ["screenshot window.png"],
            self.undo, self.undo, self.save]
        if phantom == "torso":
            choices += [lambda: self.edit(f"set labels.tint {self.number(0, 1)}"),
                        lambda: self.edit(f"set labels.structures.0.color {self.vector(0, 1)}"),
                        lambda: [f"set labels.structures.1.visible {dice.choice(('true', 'false'))}"]]
        if phantom == "heart":
            choices += [lambda: [f"do time.{dice.choice(('next', 'previous'))}"],
                        lambda: ["do time.play", f"wait {dice.randrange(500)}", "do time.play"]]
        if self.cuts < 6:
            choices += [lambda: self.cut("do cut.addPlane"), lambda: self.cut("do cut.alongView"),
                        lambda: self.cut(f'set cuts.+ {{"shape": "{dice.choice(("box", "sphere", "cylinder"))}"}}')]
        if self.cuts < 6 and self.membranes < 1:
            choices += [self.membrane]
        return dice.choice(choices)()

    def membrane(self):
        self.membranes += 1
        return self.cut("do cut.addMembrane")

    def undo(self):
        """Some steps back, and some of them forth again."""
        back = self.dice.randrange(min(self.steps, 8) + 1)
        forth = self.dice.randrange(back + 1)
        self.steps -= back - forth
        return ["undo"] * back + ["redo"] * forth

    def save(self):
        name = f"scene{self.dice.randrange(4)}.json"
        self.scenes = sorted({*self.scenes, name})
        return [f"save {name}"]

    def opened(self):
        self.steps = self.cuts = self.membranes = 0

    def round(self):
        self.opened()
        phantom = self.dice.choice(PHANTOMS)[0]
        lines = [f"open {phantom}.nrrd", "set rayCast.samplesPerPixel 1"]
        if phantom == "torso":
            lines += [f"add {phantom}_labels.seg.nrrd"]
        for _ in range(self.dice.randrange(5, 40)):
            lines += self.any_edit(phantom)
        if self.scenes and self.dice.random() < 0.7:
            lines += [f"open {self.dice.choice(self.scenes)}", "settle"]
        return lines + ["do file.new", REST]


class Soak:
    def __init__(self, minutes, seed):
        self.minutes, self.seed = minutes, seed
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="velum-soak-"))
        runtime = self.folder / "run"
        runtime.mkdir(mode=0o700)
        self.environment = {**os.environ, "XDG_STATE_HOME": str(self.folder / "state"), "XDG_RUNTIME_DIR": str(runtime),
                            "XDG_CONFIG_HOME": str(self.folder / "config"), "XDG_CACHE_HOME": str(self.folder / "cache")}
        self.last = collections.deque(maxlen=30)
        self.rests = []  # seconds since the start, MiB by name
        self.heard = time.monotonic()

    def batch(self, *arguments):
        subprocess.run([BATCH, *map(str, arguments)], cwd=self.folder, env=self.environment, timeout=600, check=True,
                       capture_output=True)

    def prepare(self):
        for name, voxels, steps in PHANTOMS:
            more = ["--time-steps", steps] if steps else []
            self.batch("sample", name, "-o", f"{name}.nrrd", "--voxels", voxels, *more)
        for name in LOOKS:
            self.batch("render", "torso.nrrd", "--preset", name, "-o", "look.png", "--size", "16x16", "--samples", 1,
                       "--save-scene", "look.json")
            self.batch("convert", "look.json", f"{name}.velum-transfer.json")
        author = Author(self.seed, self.folder)
        # More rounds than there is time for: none takes less than a second.
        lines = [line for _ in range(int(self.minutes * 60) + 10) for line in author.round()]
        (self.folder / "soak.vel").write_text("\n".join(lines))

    def resident(self, process):
        """MiB"""
        for line in pathlib.Path(f"/proc/{process}/status").read_text().splitlines():
            if line.startswith("VmRSS"):
                return int(line.split()[1]) / 1024
        return 0.0

    def watch(self, window, start):
        """Reads what the script has done, until the time is over."""
        told = 0
        for line in window.stdout:
            self.heard = time.monotonic()
            self.last.append(line.strip())
            passed = self.heard - start
            if line.strip().endswith(REST):
                # "12.345 s, 67.8 MiB: ..."
                memory = {"allocated": float(line.split()[2]), "resident": self.resident(window.pid)}
                self.rests.append((passed, memory))
                if passed >= told * 60:
                    print(f"{passed / 60:6.1f} min, round {len(self.rests)}: {memory['allocated']:.1f} MiB allocated, "
                          f"{memory['resident']:.0f} MiB resident", flush=True)
                    told = int(passed / 60) + 1
                if passed >= self.minutes * 60:
                    return True
        return False

    def guard(self, window):
        while window.poll() is None:
            if time.monotonic() - self.heard > HANG_S:
                print(f"nothing was done for {HANG_S} s", flush=True)
                return window.kill()
            time.sleep(1)

    def run(self):
        """@return what is wrong; empty: nothing"""
        print(f"{self.minutes:g} minutes, seed {self.seed}", flush=True)
        self.prepare()
        with open(self.folder / "stderr", "w+", encoding="utf-8", errors="replace") as errors:
            window = subprocess.Popen([VELUM, "--echo", "--script", "soak.vel"], cwd=self.folder, env=self.environment,
                                      stdout=subprocess.PIPE, stderr=errors, text=True)
            threading.Thread(target=self.guard, args=[window], daemon=True).start()
            done = self.watch(window, time.monotonic())
            if done:
                window.send_signal(signal.SIGTERM)
            # What it goes on to say meanwhile would fill the pipe.
            for _ in window.stdout:
                pass
            code = window.wait(timeout=HANG_S)
            errors.seek(0)
            said = errors.read()
        if not done or code != 128 + signal.SIGTERM or said:
            return f"exit code {code}; it said: {said or 'nothing'}\nlast lines:\n" + "\n".join(self.last)
        return self.judge()

    def judge(self):
        """Levels are medians over a span: what was open last leaves its trace for some rounds."""
        begin = min(600.0, self.minutes * 10)
        end = self.rests[-1][0]
        early = [memory for passed, memory in self.rests if begin <= passed < 2 * begin]
        late = [memory for passed, memory in self.rests if passed > max(2 * begin, end - begin)]
        if min(len(early), len(late)) < 3:
            return f"{len(early)} and {len(late)} rounds in spans of {begin:.0f} s are too few: give it more minutes"
        print(f"{len(self.rests)} rounds")
        grown = []
        for name, most in MOST_GROWTH.items():
            before, after = (statistics.median(memory[name] for memory in span) for span in (early, late))
            print(f"{name}: {before:.1f} MiB from {begin / 60:g} to {begin / 30:g} min, {after:.1f} MiB in the last "
                  f"{begin / 60:g} min ({after / before - 1:+.1%})")
            if after > most * before:
                grown.append(f"{name} memory grew by more than {most - 1:.0%}")
        return "; ".join(grown)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("minutes", type=float, nargs="?", default=60)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(1 << 31))
    options = parser.parse_args()
    soak = Soak(options.minutes, options.seed)
    wrong = soak.run()
    if wrong:
        print(f"FAILED with seed {options.seed}: {wrong}\nits files: {soak.folder}")
        return 1
    shutil.rmtree(soak.folder, ignore_errors=True)
    print("ok")
    return 0


if __name__ == "__main__":
    sys.exit(main())
