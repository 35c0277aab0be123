#!/usr/bin/env python3
"""Fails when a planted bug (tests/mutants/planted) has lost its place: its file, or the text there that it replaces."""
import pathlib
import sys
import tomllib


def violations(root):
    for table in sorted((root / "tests/mutants/planted").glob("*.toml")):
        for bug in tomllib.loads(table.read_text()).get("mutant", []):
            path = root / bug["file"]
            if not path.is_file() or bug["old"] not in path.read_text():
                yield f"{table}: {bug['id']}: {bug['file']} has no longer what it replaces; say where that is now"


if __name__ == "__main__":
    found = list(violations(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "planted ok")
    sys.exit(bool(found))
