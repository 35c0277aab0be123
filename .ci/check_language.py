#!/usr/bin/env python3
"""Fails when the list of messages of the libraries (core_words.py) is old, and when a translation of the window lacks a text, has one that is gone, says it with other placeholders, or breaks the table
of words in docs/CONVENTIONS.md. Missing texts are found by Qt's lupdate; without it that part is skipped, with a message."""
import collections
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

import core_words

TITLE = "## Words in German"
NEVER = re.compile(r"\bslices?\b|opazität|preset|screenshot|datensatz|clippen|\bbitte\b", re.I)
POLITE = re.compile(r"(?<![.!?:] )(?<!^)\b(Sie|Ihnen|Ihrem|Ihren)\b")
CONTEXTS = ("Core", "Memory", "Words", "SayTime", "QObject", "QFileDialog", "QMessageBox")  # all others are classes of the window
PATH = re.compile(r"\b\w+\.\w[\w.\[\]#]*")  # "lettering.captions[#1].opacity" is no word
LUPDATE = shutil.which("lupdate", path="/usr/lib/qt6/bin:/usr/lib/x86_64-linux-gnu/qt6/bin") or shutil.which("lupdate6")


def messages(path):
    """Rows (context, source, [translations], state) of a .ts file."""
    for context in xml.parse(path).getroot().findall("context"):
        for message in context.findall("message"):
            translation = message.find("translation")
            forms = translation.findall("numerusform") or [translation]
            yield (context.find("name").text, message.find("source").text or "", [form.text or "" for form in forms],
                   translation.get("type", "finished"))


def placeholders(text):
    return collections.Counter(re.findall(r"%L?\d|%n", text))


def has_letter(text):
    return bool(re.search(r"&(?=[^&\s])", text.replace("&&", "")))


def glossary(root):
    """English word and the German ones of which each translation has one, of the table in CONVENTIONS.md."""
    text = (root / "docs/CONVENTIONS.md").read_text()
    table = text[text.index(TITLE):]
    rows = re.findall(r"^\| ([^|]+) \| ([^|]+) \|$", table, re.M)[1:]
    return [(re.compile(rf"\b{re.escape(english)}s?\b", re.I), [word.strip().lower() for word in german.split(",")])
            for english, german in rows if not english.startswith("-")]


def problems_of(path, words):
    for context, source, forms, state in messages(path):
        where = f"{path.name}: {context}: {source!r}"
        if not context.startswith("velum::gui::") and context not in CONTEXTS:
            yield f"{where}: lupdate has not understood in which class it is; write what stands before it in the source more simply"
        if state != "finished":
            yield f"{where} is {state}"
        for said in forms:
            if not said:
                yield f"{where} is not translated"
                continue
            lacks, adds = set(placeholders(source)) - set(placeholders(said)), set(placeholders(said)) - set(placeholders(source))
            if adds or (lacks and context != "Core"):  # there, what is put in may be an ending of an English word
                yield f"{where}: {said!r} has other placeholders"
            if has_letter(said) != has_letter(source):
                yield f"{where}: {said!r}: one has a letter to press, the other has not"
            if (source[:1] == " ", source[-1:] == " ") != (said[:1] == " ", said[-1:] == " ") and context != "Core":
                yield f"{where}: {said!r} begins or ends otherwise"
            if source.endswith("...") != said.endswith("..."):
                yield f"{where}: {said!r}: dots at the end say that more is asked"
            if re.search(r"\d%(?![\dnL])", said):
                yield f"{where}: {said!r}: a blank stands before %"
            small = said.lower().replace("&", "")
            if word := NEVER.search(said):
                yield f"{where}: {said!r} has {word[0]!r}"
            if POLITE.search(said):
                yield f"{where}: {said!r} speaks to somebody"
            for english, german in words:
                if english.search(PATH.sub("", source).replace("&", "")) and not any(word in small for word in german):
                    yield f"{where}: {said!r} has none of {german}"


def out_of_date(root, path):
    """What lupdate would add or take away."""
    with tempfile.TemporaryDirectory() as folder:
        fresh = pathlib.Path(folder, path.name)
        subprocess.run([LUPDATE, "-silent", "-I", "src", "-locations", "none", "src/gui", "translations", "-ts", fresh], cwd=root,
                       capture_output=True, check=True, timeout=120)
        wanted = {row[:2] for row in messages(fresh)}
    known = {row[:2] for row in messages(path)}
    for context, source in sorted(wanted - known):
        yield f"{path.name} lacks {context}: {source!r}"
    for context, source in sorted(known - wanted):
        yield f"{path.name} has {context}: {source!r}, which is nowhere"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    words = glossary(root)
    found = list(core_words.problems_of(root))
    if not LUPDATE:
        print("lupdate (qt6-l10n-tools) is not here: whether texts are missing was not looked at")
    for path in sorted((root / "translations").glob("velum_*.ts")):
        found += problems_of(path, words)
        if LUPDATE:
            found += out_of_date(root, path)
    for problem in found:
        print(problem)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
