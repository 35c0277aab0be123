#!/usr/bin/env python3
"""Fuzzes every reader for a share of the time, and says what was tried and found. What is interesting is kept in
build/fuzz/corpus and begun with the next time; what a reader falls over, as small as it can be made, in
build/fuzz/findings, with what was said. Run by ./dev fuzz [minutes]."""
import argparse
import concurrent.futures
import fnmatch
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
HOME = ROOT / "build" / "fuzz"
DICTIONARIES = pathlib.Path(__file__).resolve().parent / "dictionaries"
MOST_FINDINGS = 3  # of a target in one go: they tend to be the same one
MINIMISE_S = 30
SLICE_S = 40  # what libraries lose with each damaged file must not add up


class Target:
    def __init__(self, name, seconds):
        self.name, self.seconds = name, seconds
        self.executions = 0
        self.findings = []
        self.program = HOME / "bin" / f"{name}-fuzz"
        self.corpus = HOME / "corpus" / name
        self.corpus.mkdir(parents=True, exist_ok=True)
        # Some files are written by none of the phantoms, but then the target would have no folder at all.
        self.seeds = HOME / "seeds" / name
        self.environment = {
            **os.environ, "ASAN_OPTIONS": f"log_path={HOME / 'findings' / (name + '.log')}",
            "LSAN_OPTIONS": f"suppressions={ROOT / 'tests/support/leaks.txt'}:print_suppressions=0"}

    def call(self, *arguments):
        """Readers make links to their files where they work."""
        with tempfile.TemporaryDirectory(prefix="velum-fuzz-") as folder:
            return subprocess.run([self.program, "-rss_limit_mb=2048", "-timeout=20", *arguments], cwd=folder,
                                  env=self.environment, capture_output=True, text=True, errors="replace")

    def run(self):
        end = time.monotonic() + self.seconds
        words = DICTIONARIES / f"{self.name.removesuffix('-source')}.dict"
        options = [f"-dict={words}"] if words.exists() else []
        prefix = HOME / "findings" / f"{self.name}-"
        while (left := end - time.monotonic()) >= 1 and len(self.findings) < MOST_FINDINGS:
            before = set(prefix.parent.iterdir())
            done = self.call(f"-max_total_time={int(min(left, SLICE_S))}", "-print_final_stats=1", f"-artifact_prefix={prefix}", *options,
                             self.corpus, self.seeds)
            counts = re.findall(r"(?:number_of_executed_units: +|^#)(\d+)", done.stderr, re.M)
            self.executions += max(map(int, counts), default=0)
            if done.returncode == 0:
                continue
            found = [f for f in set(prefix.parent.iterdir()) - before
                     if re.match(re.escape(self.name) + r"-(crash|oom|timeout|leak)-", f.name)]
            if not found:
                sys.exit(f"fuzz: {self.program.name} ended with {done.returncode}:\n{done.stderr[-3000:]}")
            for file in found:
                self.findings.append(self.minimised(file, done.stderr))
        return self

    def minimised(self, file, said):
        file.with_suffix(".txt").write_text(said[-20000:])
        small = file.with_suffix(".small")
        if "-crash-" in file.name:
            self.call("-minimize_crash=1", f"-max_total_time={MINIMISE_S}", f"-exact_artifact_path={small}", file)
        return small if small.exists() else file


def main():
    parser = argparse.ArgumentParser(prog="./dev fuzz", description=__doc__)
    parser.add_argument("minutes", type=float, nargs="?", default=30.0)
    parser.add_argument("--only", action="append", metavar="PATTERN", help="targets of these names; repeatable")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    names = sorted(f.name.removesuffix("-fuzz") for f in (HOME / "bin").glob("*-fuzz"))
    chosen = [n for n in names if not options.only or any(fnmatch.fnmatch(n, p) for p in options.only)]
    if not chosen:
        parser.error(f"no such target; there are {', '.join(names)}")
    (HOME / "findings").mkdir(exist_ok=True)
    subprocess.run([HOME / "bin" / "fuzz-seeds", HOME / "seeds"], check=True,
                   env={**os.environ, "ASAN_OPTIONS": "detect_leaks=0"})

    share = options.minutes * 60 * options.jobs / len(chosen)
    book = HOME / "executions.json"
    total = json.loads(book.read_text()) if book.exists() else {}
    findings = []
    print(f"fuzz: {len(chosen)} targets, {share:.0f} s each", flush=True)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for done in concurrent.futures.as_completed([pool.submit(Target(n, share).run) for n in chosen]):
            target = done.result()
            findings += target.findings
            total[target.name] = total.get(target.name, 0) + target.executions
            book.write_text(json.dumps(total, indent=1, sort_keys=True))
            print(f"  {target.name:18} {target.executions:>11,} executions, {len(list(target.corpus.iterdir())):>6} kept"
                  f"{''.join(f'{chr(10)}    FOUND {f.relative_to(ROOT)}' for f in target.findings)}", flush=True)
    print(f"fuzz: {sum(total.values()):,} executions in all since {HOME.relative_to(ROOT)} was made; "
          f"{len(findings)} findings now")
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main()
