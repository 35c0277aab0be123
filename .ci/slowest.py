#!/usr/bin/env python3
"""Tells which cases took longest, of the log that ctest leaves: those of GoogleTest by their own clocks, others as a whole."""
import pathlib
import re
import sys

SHOWN = 10


def cases(log):
    test, has_cases = None, False
    for line in log.splitlines():
        if found := re.match(r"\d+/\d+ Test: (\S+)", line):
            test, has_cases = found[1], False
        elif found := re.match(r"\[ +OK \] (\S+) \((\d+) ms\)", line):
            has_cases = True
            yield int(found[2]) / 1000, f"{test}: {found[1]}"
        elif (found := re.match(r"Test time = +([\d.]+) sec", line)) and not has_cases:
            yield float(found[1]), test


if __name__ == "__main__":
    path = pathlib.Path(sys.argv[1])
    slowest = sorted(cases(path.read_text(errors="replace")) if path.exists() else [], reverse=True)[:SHOWN]
    print("\nslowest:")
    for seconds, name in slowest:
        print(f"{seconds:7.1f} s  {name}")
