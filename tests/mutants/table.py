"""The tables of bugs: what is planted, and what a result is known by."""
import fnmatch
import hashlib
import pathlib
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = pathlib.Path(__file__).parent / "planted"
FIELDS = {"id", "file", "old", "new", "suites", "why"}


def fail(text):
    sys.exit(f"mutants: {text}")


def read_tables():
    mutants = []
    for path in sorted(TABLES.glob("*.toml")):
        with open(path, "rb") as file:
            mutants += [{**row, "module": path.stem} for row in tomllib.load(file).get("mutant", [])]
    return mutants


def check(mutants):
    """Every row must be plantable before the first is tried."""
    seen, wrong = set(), []
    for m in mutants:
        name = m.get("id", "?")
        if missing := FIELDS - m.keys():
            wrong.append(f"{name}: has no {', '.join(sorted(missing))}")
            continue
        if name in seen:
            wrong.append(f"{name}: is there twice")
        seen.add(name)
        if m["old"] == m["new"]:
            wrong.append(f"{name}: changes nothing")
        path = ROOT / m["file"]
        count = path.read_text().count(m["old"]) if path.is_file() else -1
        if count != 1:
            there = "the file is not there" if count < 0 else f"its old text is there {count} times"
            wrong.append(f"{name}: {m['file']}: {there}")
        wrong += [f"{name}: there is no suite {s}" for s in m["suites"] if not is_suite(s)]
    if wrong:
        fail("these cannot be planted:\n  " + "\n  ".join(wrong))


def cli_file(tree, suite):
    return tree / "tests" / "cli" / f"{suite[4:]}_test.py"


def target_of(suite):
    """What is built for a suite."""
    return "velum-batch" if suite.startswith("cli.") else suite.split(":")[0]


def is_suite(suite):
    if suite.startswith("cli."):
        return cli_file(ROOT, suite).is_file()
    lists = (ROOT / "tests").glob("*/CMakeLists.txt")
    return any(f"({target_of(suite)} " in path.read_text() for path in lists)


def matches(mutant, patterns):
    return not patterns or any(fnmatch.fnmatch(mutant["id"], p) or p in mutant["id"] for p in patterns)


def hash_of(*parts):
    digest = hashlib.sha256()
    for part in parts:
        digest.update(part if isinstance(part, bytes) else str(part).encode())
        digest.update(b"\0")
    return digest.hexdigest()[:16]


def key_of(mutant):
    """Of the row and of the file that it is planted in."""
    return hash_of(*(mutant[f] for f in sorted(FIELDS - {"why"})), (ROOT / mutant["file"]).read_bytes())


def tests_hash():
    """Of all tests: what none of them saw is tried again when they change."""
    kinds = {".cpp", ".h", ".py", ".txt", ".png", ".json"}
    files = sorted(p for p in (ROOT / "tests").rglob("*") if p.suffix in kinds and "mutants" not in p.parts)
    return hash_of(*(p.read_bytes() for p in files))
