#!/usr/bin/env python3
"""Fails when a document names what is not there: a path in backquotes that leads nowhere, or an identifier that occurs in no source. X and x
stand for a name of one's own, and what is joined of words in a sentence (`--options`, `text with blanks`) is nobody's name. And when a picture's
scans are not told: docs/CREDITS.md has a row for each picture, debian/copyright a licence for each that shows somebody else's scan."""
import pathlib
import re
import sys

DOCUMENTS = ["README.md", "docs/ARCHITECTURE.md", "docs/MEMBRANES.md", "docs/MODELS.md", "docs/RAY-MARCH.md", "docs/ADDING.md", "docs/CONVENTIONS.md", "docs/STYLE.md", "docs/TESTING.md"]
SOURCES = ["src/**/*", "python/**/*", "shaders/**/*", "tests/**/*.cpp", "tests/**/*.h", "tests/**/*.py", "tests/**/*.txt", "cmake/*", ".ci/**/*", "dev",
           "CMakeLists.txt", "CMakePresets.json", "docs/*.py"]
HOMES = ["", "src", "src/session", "shaders", "tests", "docs"]  # from where paths are told
OTHERS = {  # names of other people's: libraries, drivers, formats
    "LD_LIBRARY_PATH", "HOME", "DISPLAY", "XDG_CACHE_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "PascalCase", "camelCase", "mName", "kName",
    "VELUM_NAME", "Differs", "targetFromSource", "xCount", "timeS", "CompressedDataSize",
}


def words_of_sources(root):
    words = set()
    for pattern in SOURCES:
        for path in root.glob(pattern):
            if path.is_file() and path.stat().st_size < 2_000_000:
                words |= set(re.findall(r"\w+", path.read_text(errors="replace")))
                words |= set(re.findall(r"\w+", path.stem))
    return words


def is_placeholder(text):
    return bool(re.search(r"(?<![a-z0-9])X(?![a-z])|X\b|<|\.\.\.|\*|NAME|FILE|FOLDER|PATH|\bID\b|[/_]x[._]|\.new$", text))


def is_path(root, text):
    text = text.rstrip("/")
    for home in HOMES:
        base = root / home / text
        if base.exists() or any(base.parent.glob(base.name + ".*")):
            return True
    return False


def strangers(root):
    words = words_of_sources(root)
    for document in DOCUMENTS:
        text = re.sub(r"```.*?```", lambda m: re.sub(r"[^\n]", " ", m[0]), (root / document).read_text(), flags=re.DOTALL)
        for found in re.finditer(r"`([^`\n]+)`", text):
            name = found[1].strip()
            line = text.count("\n", 0, found.start()) + 1
            if is_placeholder(name) or name in OTHERS:
                continue
            if re.fullmatch(r"[\w.-]+(/[\w.-]+)+/?", name) and name.split("/")[0] in {
                    "src", "include", "tests", "docs", "shaders", "cmake", ".ci", "resources", "core", "scene", "gpu", "io", "membrane", "model", "growth",
                    "render", "session", "gui", "app"}:
                if not is_path(root, name):
                    yield f"{document}:{line}: there is no `{name}`"
            elif re.fullmatch(r"[A-Za-z_]\w*(::~?\w+)*(\(\))?", name) and re.search(r"[a-z][A-Z]|::|^[A-Z]\w*[a-z]", name):
                last = re.sub(r"\(\)$", "", name).split("::")[-1].lstrip("~")
                if last not in words and name not in words:
                    yield f"{document}:{line}: no source has `{name}`"


def unlicensed(root):
    shown = {name: row[1] for row in re.finditer(r"^\|[^|\n]*`[^|\n]*\|([^|\n]*)\|$", (root / "docs/CREDITS.md").read_text(), re.M)
             for name in re.findall(r"`([\w-]+\.(?:jpg|png|mp4))`", row[0])}
    shown["first.jpg"] = "a table of its own"
    copyright = (root / "debian/copyright").read_text()
    for path in sorted((root / "docs/images").iterdir()):
        if path.name not in shown:
            yield f"docs/CREDITS.md has no row for {path.name}"
        elif shown[path.name].strip() not in ("phantoms", "a phantom") and f"docs/images/{path.name}\n" not in copyright:
            yield f"debian/copyright has no licence for docs/images/{path.name}"


if __name__ == "__main__":
    root = pathlib.Path(sys.argv[1]).resolve()
    found = [*strangers(root), *unlicensed(root)]
    print("\n".join(found) or "docs ok")
    sys.exit(bool(found))
