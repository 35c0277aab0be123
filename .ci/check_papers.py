#!/usr/bin/env python3
"""Fails when a comment cites a paper, as in "[IMC] fig. 5", that the table in docs/PAPERS.md does not define, or names a key of
that table without its brackets."""
import pathlib
import re
import sys

KEY = r"\[([A-Z][A-Z0-9-]+)\]"
SOURCES = {"src": "h cpp", "shaders": "h glsl comp vert frag", "tests": "h cpp"}  # folder: endings


def defined(root):
    text = (root / "docs/PAPERS.md").read_text()
    return set(re.findall(r"^\|\s*" + KEY + r"\s*\|", text, re.MULTILINE))


def violations(root):
    known = defined(root)
    bare = re.compile(r"(?<![\w\[])(" + "|".join(sorted(known)) + r")(?![\w\]])")
    files = [f for folder, ends in SOURCES.items() for end in ends.split() for f in root.glob(f"{folder}/**/*.{end}")]
    for path in sorted(files):
        for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
            comment = re.search(r"//.*", line)
            if not comment:
                continue
            for key in re.findall(r"(?<!\w)" + KEY, comment[0]):
                if key not in known:
                    yield f"{path}:{number}: [{key}] is not in docs/PAPERS.md"
            for key in bare.findall(comment[0]):
                yield f"{path}:{number}: {key} is cited without brackets"


if __name__ == "__main__":
    found = list(violations(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "papers ok")
    sys.exit(bool(found))
