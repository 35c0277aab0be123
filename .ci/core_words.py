#!/usr/bin/env python3
"""Messages that the libraries below the window compose, and errors of the window: the texts of their sources, as translations/CoreWords.h lists them for
lupdate and for the window. core_words.py ROOT says where the list differs from the sources; with --write it is written anew."""
import pathlib
import re
import sys

LIST = "translations/CoreWords.h"
TABLES = "translations/TableWords.h"
STEPS = "src/gui/kit/Words.cpp"
FOLDERS = ("core", "gpu", "growth", "io", "membrane", "model", "render", "scene", "session", "vector", "gui")
HEAD = """// Written by .ci/core_words.py --write, read by lupdate and by the window: what the libraries below the window say, as their
// sources say it, with %1 for what is put in.
// clang-format off
inline constexpr const char* kCoreWords[] = {
"""
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^(\s]*)\(.*?\)\1"|"((?:[^"\\\n]|\\.)*)"|\'(?:[^\'\\]|\\.)+\'', re.S)
# What is thrown.
KINDS = r"\w*Error|TooOld|NoMemory|ContextLost"
THROWN = re.compile(rf"(?:{KINDS})$")
# Calls that say to somebody what they are given, and those that do not.
SAYS = re.compile(rf"(?:{KINDS}|fmt::format|[Rr]efuse\w*|refusal|report|push_back|say\w*|fail|warn\w*|need|blame|oneLine|whole|sizesOf|"
                  r"forBricks|listText|checkRoom|edit|optional|written|setsOf)$")
SAYS_NOTHING = re.compile(r"(?:structureLabel|typesLabel|\w*ASSERT|static_assert|fprintf|log::\w+|addLine|addImage|put|field|starts_with|find|has|Buffer|Texture|"
                          r"make\w+|bufferOf|write|visit|parse\w*|head\.add|lines\.add|setDescription|countOf|vectorOf)$")
# What is written into files, programs and tables, or is no sentence.
CODE = re.compile(r"^\s*[<#]|\\n.|\\r|^(property|comment|element|format|space:|space |velum-batch|q |s\.set|velum: | --)|^[\w./]*%|"
                  r"domain |^made: |^velum film$|^most frequent id$|^(?:[A-Z]{2} )+|^ACR|: *\\n|=\\\"|Times|Helvetica|^%d|ResolutionLevel")
PLACE = re.compile(r"\{(\d*)(?::[^{}]*)?\}")
PURPOSES = """
/// What memory on the GPU is for.
inline constexpr const char* kMemoryPurposes[] = {
"""
# Calls that make textures and buffers, whose first words say what they are for.
PURPOSE = re.compile(r"^(?:gpu::)?(?:Buffer|Buffer::makeReadable|Texture::make2d|Texture::make3d|bufferOf)$")
VERB = re.compile(r"^(?:structureLabel|typesLabel|step(?:By|Of\w+))$")


def literals(text):
    """(begin, end, text) of string literals; neighbours are one."""
    found = []
    for token in TOKEN.finditer(text):
        if token[2] is None:
            continue
        if found and not text[found[-1][1]:token.start()].strip():
            found[-1] = (found[-1][0], token.end(), found[-1][2] + token[2])
        else:
            found.append((token.start(), token.end(), token[2]))
    return found


def around(text, begin):
    """Calls in whose arguments a place is, the innermost first, and the rest of its statement before it."""
    depth, calls, at = 0, [], begin - 1
    while at > max(0, begin - 1200):
        letter = text[at]
        if letter == ")":
            depth += 1
        elif letter == "(" and depth:
            depth -= 1
        elif letter == "(":
            name = re.search(r"([\w:.]+?)(?:<[\w:]+>)?\s*$", text[max(0, at - 80):at])
            calls.append(name[1] if name else "")
        elif letter in ";{}" and not depth:
            break
        at -= 1
    return [call for call in calls if call], text[at + 1:begin]


def without_texts(text):
    """As long as it was, with blanks in the place of what literals and remarks say."""
    return TOKEN.sub(lambda token: token[0][0] + " " * (len(token[0]) - 2) + token[0][-1], text)


def is_step(calls, literal):
    """Whether it is the name of an undo step in the row of a command, behind what the command does and an example of it."""
    return calls and calls[0].endswith("Row") and literal[0].isupper() and not literal.endswith(".")


def is_said(calls, before):
    if any(SAYS_NOTHING.search(call) for call in calls):
        return False
    if any(SAYS.search(call) for call in calls):
        return True
    return not calls and bool(re.search(r"(?:\breturn\b|\?|=|:|\+)\s*\(*\s*(?:[\w.>():-]+\s*\+\s*)?$", before))


def addend(gap):
    """Whether what stands between two literals is one thing that is added to both."""
    inner = re.fullmatch(r"\s*\+\s*(.+?)\s*\+\s*", gap, re.S)
    if not inner or "\"" in inner[1]:
        return False
    depth = 0
    for letter in inner[1]:
        depth += (letter == "(") - (letter == ")")
        if depth < 0 or (depth == 0 and letter in ",;?:{}" and "::" not in inner[1]):
            return False
    return depth == 0


def sums(text):
    """(begin, fmt string) of literals, where a sum of literals and other things is one with {} for the others."""
    found = []
    for begin, end, literal in literals(text):
        if found and addend(text[found[-1][1]:begin]):
            found[-1] = (found[-1][0], end, found[-1][2] + "{}" + literal)
        else:
            found.append((begin, end, literal))
    for begin, end, literal in found:
        before, behind = text[max(0, begin - 120):begin], text[end:end + 40]
        if re.search(r"[\w)\]\"]\s*\+\s*$", before):
            literal = "{}" + literal
        if re.match(r"\s*\+\s*[\w(*]", behind):
            literal += "{}"
        yield begin, literal


def pattern_of(literal):
    """A format string with %1 for its fields."""
    count = 0

    def place(field):
        nonlocal count
        count += 1
        return f"%{int(field[1]) + 1 if field[1] else count}"

    return re.sub(r"\{\{|\}\}", lambda brace: brace[0][0], PLACE.sub(place, literal))


def is_message(literal):
    plain = PLACE.sub("", literal)
    return " " in plain.strip() and re.search("[A-Za-z]{2}.* |[a-z]{3}", plain) and not CODE.search(literal)


def collected(root):
    """Each message once, in the order of the sources; those of tables have a list of their own."""
    found, of_tables = {}, (root / TABLES).read_text()
    for folder in FOLDERS:
        for path in sorted((root / "src" / folder).rglob("*")):
            if path.suffix not in (".cpp", ".h"):
                continue
            text = path.read_text()
            plain = without_texts(text)
            for begin, literal in sums(text):
                calls, before = around(plain, begin)
                is_thrown = any(THROWN.search(call) for call in calls)
                if is_message(literal) and (is_thrown if folder == "gui" else is_said(calls, before) or is_step(calls, literal)) and f'"{literal}"' not in of_tables:
                    found[pattern_of(literal)] = path.relative_to(root)
    return found


def verbs(root):
    """What steps do to structures and types that are named behind: "Hide" of "Hide aorta"."""
    found = set()
    for path in (root / "src/session/command").glob("*.cpp"):
        text = path.read_text()
        for begin, literal in sums(text):
            if any(VERB.search(call) for call in around(text, begin)[0]) and literal:
                found.add(literal)
    return found


def purposes(root):
    """What memory on the GPU is for: the names that textures and buffers are given."""
    found = {}
    for path in sorted((root / "src").rglob("*")):
        if path.suffix not in (".cpp", ".h"):
            continue
        text = path.read_text()
        for begin, literal in sums(text):
            calls = around(text, begin)[0]
            declared = re.search(r"\b(?:UniformBuffer<[\w:]+>|Readback<[\w:]+>|ReadbackRing) \w+[({]$|\bkPurpose = $", text[max(0, begin - 100):begin])
            if declared or calls and PURPOSE.search(calls[0]):
                found[literal] = path
    return found


def listed(root):
    """The lists as they should be."""
    def rows(context, texts):
        return "".join(f'    QT_TRANSLATE_NOOP("{context}", "{text}"),\n' for text in texts) + "};\n"
    return HEAD + rows("Core", collected(root)) + PURPOSES + rows("Memory", sorted(purposes(root)))


def problems_of(root):
    """What is not as the sources say, in lines."""
    if (root / LIST).read_text() != listed(root):
        yield f"{LIST} is not what the sources say: run .ci/core_words.py . --write, and translate what is new (docs/ADDING.md)"
    steps = (root / STEPS).read_text()
    for verb in sorted(verbs(root)):
        if f'"{verb} %1"' not in steps:
            yield f"{STEPS} lacks the step {verb + ' %1'!r}"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    if "--write" in sys.argv[2:]:
        (root / LIST).write_text(listed(root))
        return 0
    found = list(problems_of(root))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
