#!/usr/bin/env python3
"""Tells of the log that ctest leaves what is looked for first, at its very end, where a build server's log is read: which cases took
longest (those of GoogleTest by their own clocks, others as a whole), and what those that failed say."""
import pathlib
import re
import sys

SHOWN = 10
TOLD = 12  # lines of a failure
OTHER = 20  # lines of a test without cases that has failed, from its end


def tests(log):
    """Name and lines of each test."""
    name, lines = None, []
    for line in log.splitlines():
        if found := re.match(r"\d+/\d+ Test: (\S+)", line):
            if name:
                yield name, lines
            name, lines = found[1], []
        lines.append(line)
    if name:
        yield name, lines


def times(name, lines):
    own = [(int(found[2]) / 1000, f"{name}: {found[1]}") for line in lines if (found := re.match(r"\[ +OK \] (\S+) \((\d+) ms\)", line))]
    whole = [(float(found[1]), name) for line in lines if (found := re.match(r"Test time = +([\d.]+) sec", line))]
    return own or whole


def failures(name, lines):
    """What a failed test says: of each failed case the beginning of each message, else the end of its output."""
    if "Test Failed." not in lines and not any(line.startswith("Test timeout") for line in lines):
        return
    case, found = "", False
    for at, line in enumerate(lines):
        if run := re.match(r"\[ RUN +\] (\S+)", line):
            case = run[1]
        elif re.search(r": Failure$", line):
            end = next((i for i in range(at + 1, min(at + TOLD, len(lines))) if re.match(r"\[ |.*: Failure$", lines[i])), at + TOLD)
            yield [f"{name}: {case}"] + lines[at:end]
            found = True
    if not found:
        output = [line for line in lines if line.strip()]
        yield [f"{name}:"] + output[-OTHER:]


if __name__ == "__main__":
    path = pathlib.Path(sys.argv[1])
    run = list(tests(path.read_text(errors="replace"))) if path.exists() else []
    print("\nslowest:")
    for seconds, name in sorted((time for test in run for time in times(*test)), reverse=True)[:SHOWN]:
        print(f"{seconds:7.1f} s  {name}")
    for test in run:
        for told in failures(*test):
            print("\nfailed: " + "\n  ".join(told))
