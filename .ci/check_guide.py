#!/usr/bin/env python3
"""Fails when the guide calls a control of the window what the window does not: each name that docs/USER-GUIDE.md emphasises and that
begins with a capital letter (*Save picture*, *File > Open recent*) stands in a string of the window's sources, whole. `&`, dots at the end
and what stands behind a tab are nothing of a name. Words in small letters are terms, and bold ones what is explained; the chapter *Side
by side* names other programs."""
import pathlib
import re
import sys

FOLDERS = ["src/gui", "src/session", "src/scene"]  # what is shown, and the tables whose titles are
END = "## Side by side"
STRING = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
KEYS = {"Shift", "Ctrl", "Alt", "Space", "Esc", "Del"}


def plain(text):
    """A name as people read it."""
    text = re.sub(r"\\u([0-9a-fA-F]{4})", lambda m: chr(int(m[1], 16)), text).replace("\\t", "\t")
    return re.sub(r"(\.\.\.|:)$", "", text.split("\t")[0].replace("&", "").strip())


def names_of_window(root):
    names = set()
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.[ch]*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            # Literals side by side are one.
            text = re.sub(r'"\s*\n\s*"', "", path.read_text())
            for match in STRING.finditer(text):
                # "Spares: nothing", "Layers: depth, ..."; "Deepen the reach to %1".
                names |= {plain(match[1]), plain(match[1].split(": ")[0]), plain(re.split(r"\s(?:to )?%\d", match[1])[0])}
    return names


def emphasised(guide):
    """Line numbers and texts between single stars, code blocks left out."""
    text = guide.split(END)[0]
    text = re.sub(r"```.*?```", lambda m: re.sub(r"[^\n]", " ", m[0]), text, flags=re.DOTALL)
    text = re.sub(r"`[^`\n]*`", lambda m: " " * len(m[0]), text)
    text = re.sub(r"\*\*.*?\*\*", lambda m: re.sub(r"[^\n]", " ", m[0]), text, flags=re.DOTALL)
    for match in re.finditer(r"\*([^*\s][^*]*?)\*", text):
        yield text.count("\n", 0, match.start()) + 1, " ".join(match[1].split())


def strangers(root):
    names = names_of_window(root)
    for line, text in emphasised((root / "docs/USER-GUIDE.md").read_text()):
        for part in re.split(r" > ", text):
            part = plain(part)
            if part[:1].isupper() and part not in names and part not in KEYS:
                yield f"docs/USER-GUIDE.md:{line}: the window has nothing that is called *{part}*"


if __name__ == "__main__":
    found = list(strangers(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "guide ok")
    sys.exit(bool(found))
