#!/usr/bin/env python3
"""Fails when a file or a function is longer than it may be: 300 lines a file, 60 a function that is no table. What was longer before
may only become shorter: .ci/lengths.txt says how long it is. `check_lengths.py ROOT --accept` writes down what has become shorter."""
import pathlib
import re
import sys

MOST_LINES, MOST_OF_FUNCTION = 300, 60
FOLDERS = ["src", "python", "shaders", "tests"]


def functions(lines):
    """Name and length of each function whose head begins in the first column."""
    begin = None
    for number, line in enumerate(lines):
        if re.match(r"[\w~:<*&]", line) and not re.match(r"(namespace|struct|class|enum|union|using|typedef|extern|template)\b", line):
            if begin is None or lines[number - 1:number] != [""]:
                begin = begin if begin is not None and not line.rstrip().endswith("{") else number
            if line.rstrip().endswith("{") and "= {" not in line and "={" not in line:
                begin = number
            elif line.rstrip().endswith((";", "}")):
                begin = None
        elif line.startswith("}"):
            if begin is not None and line.rstrip() == "}":
                head = lines[begin]
                name = re.findall(r"([\w~:]+)\s*\(", head) or [head.strip()[:40]]
                yield name[0], number - begin + 1
            begin = None


def lengths(root):
    found = {}
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp", ".comp", ".glsl", ".vert", ".frag") or not path.is_file():
                continue
            lines = path.read_text(errors="replace").splitlines()
            name = path.relative_to(root).as_posix()
            if len(lines) > MOST_LINES:
                found[name] = len(lines)
            if folder == "tests":
                continue
            for function, length in functions(lines):
                if length > MOST_OF_FUNCTION:
                    found[f"{name} {function}"] = max(length, found.get(f"{name} {function}", 0))
    return found


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    table = root / ".ci/lengths.txt"
    known = dict((line.rsplit(" ", 1)[0], int(line.rsplit(" ", 1)[1])) for line in table.read_text().splitlines()) if table.exists() else {}
    now = lengths(root)
    if "--accept" in sys.argv:
        kept = {name: min(length, known.get(name, length)) for name, length in now.items() if not known or name in known}
        table.write_text("".join(f"{name} {length}\n" for name, length in sorted(kept.items())))
        return 0
    wrong = [f"{name}: {length} lines; it may have {known.get(name, MOST_OF_FUNCTION if ' ' in name else MOST_LINES)}"
             for name, length in now.items() if length > known.get(name, 0)]
    wrong += [f"{name}: shorter than {length} lines now; write that down: .ci/check_lengths.py . --accept"
              for name, length in known.items() if now.get(name, 0) < length]
    print("\n".join(wrong) or "lengths ok")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
