#!/usr/bin/env python3
"""Plants bugs one at a time and says which tests see them.

The bugs are in planted/*.toml, a table each: id, file, old (found there exactly once), new, suites (tried in this order
until one fails) and why a person might write it. A suite is a test program, `render-test` or `render-test:Filter*`, or a
test of the command line, `cli.render`. Golden pictures, where a bug asks for them, come last and are counted apart.

Work is done on copies of the working tree in build/mutants, built with ccache; the tree itself is only read. Results
are kept in build/mutants/results.json: a second run tries what is new, what has changed, and what no test saw before
the tests changed. build/mutants/report.md is for reading.
"""
import argparse
import concurrent.futures
import json
import os
import queue
import signal
import sys
import time

sys.dont_write_bytecode = True  # the tree is only read

from report import STATES, report  # noqa: E402
from table import ROOT, check, fail, key_of, matches, read_tables, target_of, tests_hash  # noqa: E402
from tree import Tree  # noqa: E402

HOME = ROOT / "build" / "mutants"


class Results:
    """What is known, kept after each bug."""

    def __init__(self, mutants):
        file = HOME / "results.json"
        known = json.loads(file.read_text()) if file.is_file() else {}
        self.keys = {m["id"]: key_of(m) for m in mutants}
        self.tests = tests_hash()
        self.known = {name: r for name, r in known.items() if name in self.keys and self.holds(name, r)}

    def holds(self, name, result):
        return result["key"] == self.keys[name] and (result["state"] == "killed" or result["tests"] == self.tests)

    def add(self, mutant, state, by, seconds):
        name = mutant["id"]
        self.known[name] = {"key": self.keys[name], "tests": self.tests, "state": state, "by": by, "seconds": seconds,
                            **{f: mutant[f] for f in ("module", "file", "why")}}
        self.save()
        print(f"  {name}: {STATES[state]}{' by ' + ', '.join(by) if by else ''} ({seconds:.0f} s)", flush=True)

    def save(self):
        HOME.mkdir(parents=True, exist_ok=True)
        for name, text in (("results.json", json.dumps(self.known, indent=1)), ("report.md", report(self.known))):
            (HOME / f"{name}.new").write_text(text)
            (HOME / f"{name}.new").replace(HOME / name)


def plant_all(mutants, jobs, limit, tell):
    """@param tell  is called with each bug, what came of it, by which tests, and after how many seconds"""
    targets = {target_of(suite) for m in mutants for suite in m["suites"]}
    trees, free = [], queue.Queue()
    for i in range(jobs):
        tree = Tree(HOME / str(i), max(1, (os.cpu_count() or 1) // jobs))
        trees.append(tree)
        print(f"mutants: building {', '.join(sorted(targets))} in {tree.tree.relative_to(ROOT)}", flush=True)
        tree.sync()
        tree.make_clean(targets)
        tree.check_names({suite for m in mutants for suite in m["suites"]})
        free.put(tree)

    def work(mutant):
        tree = free.get()
        start = time.monotonic()
        try:
            return mutant, *tree.try_mutant(mutant, limit), time.monotonic() - start
        finally:
            free.put(tree)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        try:
            for result in concurrent.futures.as_completed([pool.submit(work, m) for m in mutants]):
                tell(*result.result())
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            for tree in trees:
                tree.stop()
            raise


def main():
    parser = argparse.ArgumentParser(prog="./dev mutants", description=__doc__.split("\n")[0])
    parser.add_argument("--only", action="append", metavar="PATTERN", help="bugs whose id matches or holds it; repeatable")
    parser.add_argument("--list", action="store_true", help="say what is planted and what is known of it")
    parser.add_argument("--jobs", type=int, default=1, help="copies of the tree that are worked on at a time")
    parser.add_argument("--limit", type=int, default=900, metavar="S", help="seconds for a suite; longer is a kill")
    parser.add_argument("--again", action="store_true", help="those, too, whose result is known")
    options = parser.parse_args()
    mutants = read_tables()
    check(mutants)
    results = Results(mutants)
    chosen = [m for m in mutants if matches(m, options.only)]
    if options.list:
        for m in chosen:
            print(f"{m['id']:32} {results.known.get(m['id'], {}).get('state', '-'):10} {m['why']}")
        return
    todo = [m for m in chosen if options.again or m["id"] not in results.known]
    print(f"mutants: {len(chosen)} of {len(mutants)} are meant, {len(todo)} to be tried", flush=True)
    if todo:
        plant_all(todo, max(1, min(options.jobs, len(todo))), options.limit, results.add)
    results.save()
    print(report({m["id"]: results.known[m["id"]] for m in chosen}))
    print(f"mutants: all that is known is in {HOME.relative_to(ROOT)}: report.md, results.json")


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("mutants: stopped; what is known is kept"))
    try:
        main()
    except KeyboardInterrupt:
        fail("stopped; what is known is kept")
