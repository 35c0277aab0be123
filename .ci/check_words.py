#!/usr/bin/env python3
"""Fails when a word stands where the glossary of docs/CONVENTIONS.md says that it does not: the table under "Words that we do not
use" has a row a word. Rows marked `pending` are counted and do not fail.

A word is part of a name (`slice` is in makeSectionPlane), `=name` a whole name, `*Mm` the end of one. In the window's texts and in
tips a word, or several, stand as they are, whatever their case."""
import functools
import pathlib
import re
import sys

STRING = r'"(?:[^"\\]|\\.)*"'


def without_comments(text):
    """The text with comments blanked out, lines kept."""
    token = re.compile(STRING + r"|//[^\n]*|/\*.*?\*/", re.DOTALL)
    blank = lambda m: m[0] if m[0].startswith('"') else re.sub(r"[^\n]", " ", m[0])
    return token.sub(blank, text)


def names_in(text):
    return re.finditer(r"[A-Za-z_]\w*", re.sub(STRING, lambda m: " " * len(m[0]), text))


def cpp_names(root):
    for path in sorted(root.glob("src/**/*.[ch]*")):
        if path.name != "CMakeLists.txt":
            yield path, names_in(re.sub(r"#\s*include[^\n]*", "", without_comments(path.read_text())))


def glsl_names(root):
    for path in sorted(p for p in root.glob("shaders/**/*") if p.is_file()):
        yield path, names_in(re.sub(r"#\s*include[^\n]*", "", without_comments(path.read_text())))


def strings_after(root, folders, call):
    for folder in folders:
        for path in sorted(root.glob(f"{folder}/**/*.[ch]*")):
            text = without_comments(path.read_text()) if path.suffix in (".h", ".cpp") else ""
            yield path, re.finditer(call + r"\s*(" + STRING + r"(?:\s*" + STRING + r")*)", text)


def texts_for_people(root, folders):
    """Strings of several words, or with a mnemonic: tr() may stand elsewhere, where a row of a table is read."""
    for path, matches in strings_after(root, folders, ""):
        yield path, [m for m in matches if " " in m[1] or "&" in m[1] or "tr(" in m.string[max(0, m.start() - 4):m.start()]]


def without_io(root):
    """Files have words of their own: what a format calls a slice, a millimetre or a frame is one."""
    return ((path, names) for path, names in cpp_names(root) if not {"io"} & set(path.relative_to(root).parts[:3]))


def documents(root):
    """Without code, and without those that quote others or this table."""
    for path in [*sorted(root.glob("docs/*.md")), root / "README.md"]:
        if path.name in ("CHANGELOG.md", "CONVENTIONS.md", "PAPERS.md"):
            continue
        blank = lambda m: re.sub(r"[^\n]", " ", m[0])
        yield path, re.finditer(r"([^\n]+)", re.sub(r"```.*?```|`[^`\n]*`", blank, path.read_text(), flags=re.DOTALL))


PLACES = {  # name in the table: names or texts of that place, each a list of matches of a file
    "C++": cpp_names,
    "C++ but io": without_io,
    "JSON": lambda root: strings_after(root, ["src/scene"], r"\bvisit\("),
    "GLSL": glsl_names,
    "command line": lambda root: strings_after(root, ["src/app"], r"\badd_(?:option|flag)\("),
    "docs": documents,
    "window": lambda root: texts_for_people(root, ["src/gui", "src/session/cut"]),
}


@functools.lru_cache(maxsize=None)
def parts(name):
    """makeSectionPlane -> make, slice, frame."""
    return [p.lower() for p in re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+", name)]


def holds(text, word, is_name):
    if word.startswith("="):
        return text == word[1:]
    if word.startswith("*"):
        return text.endswith(word[1:])
    if is_name:
        return word in parts(text)
    return re.search(r"(?<!\w)" + re.escape(word) + r"(?!\w)", text, re.IGNORECASE) is not None


def rows(root):
    """Words, places, what to say instead, and whether the row is pending."""
    text = (root / "docs/CONVENTIONS.md").read_text().split("## Words that we do not use")[1]
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if not line.startswith("| `") or len(cells) < 4:
            continue
        yield re.findall(r"`([^`]+)`", cells[0]), cells[1].split(", "), cells[2], cells[3] == "pending"


def main(root):
    found, pending = [], {}
    table = list(rows(root))
    if not table:
        sys.exit("docs/CONVENTIONS.md has no table of words")
    for place, texts in PLACES.items():
        wanted = [(word, instead, waits) for words, places, instead, waits in table if place in places for word in words]
        for path, matches in texts(root):
            for match in matches:
                text = match[1].strip('"').replace("&", "") if match.re.groups else match[0]
                for word, instead, waits in wanted:
                    if not holds(text, word, place in ("C++", "GLSL", "JSON")):
                        continue
                    if waits:
                        pending[(word, place)] = pending.get((word, place), 0) + 1
                        continue
                    line = match.string.count("\n", 0, match.start()) + 1
                    found.append(f"{path.relative_to(root)}:{line}: `{word}` is not a word of ours ({place}): {instead}")
    for (word, place), count in sorted(pending.items()):
        print(f"pending: `{word}` {count} times ({place})")
    print("\n".join(found) or "words ok")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
