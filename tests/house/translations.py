#!/usr/bin/env python3
"""Every translation keeps what the program puts in and what the user types: translations.py CATALOGUE.po ...

Names in braces with their formats, the format of a figure, options, headings of files, letters of shortcuts, line ends. The
catalogues come through msgcat --no-wrap, so that each text is one line.
"""

import json
import re
import subprocess
import sys

FIELD = re.compile(r"\{\{|\}\}|\{[^{}]*\}")
FIGURE = re.compile(r"%[-+ 0-9.]*[a-zA-Z]")
KEPT = (
    re.compile(r"--[a-z][a-z-]+"),  # options
    re.compile(r"\[[A-Z][A-Z ]+\]|@@[A-Z][a-z]+|%%[a-z]+"),  # headings and keys of files
    re.compile(r"\bF\d{1,2}\b|\+[A-Z]\b"),  # keys
    re.compile(r"\.(?:wif|dtx|wpo|glb|gltf|usda|exr|hdr|png|svg|pdf|csv|tif|jpg)\b"),
    re.compile(r"WEFTLIGHT_[A-Z]+|https?://"),
)


def texts_of(catalogue):
    """(flags, id, plural or None, [translations]) of each text that is in use."""
    flat = subprocess.run(["msgcat", "--no-wrap", catalogue], check=True, capture_output=True, text=True).stdout
    for block in flat.split("\n\n"):
        flags, words, kind = "", {}, None
        for line in block.splitlines():
            found = re.match(r'(msgctxt|msgid_plural|msgid|msgstr(?:\[\d\])?) (".*")$', line)
            if line.startswith("#,"):
                flags += line
            elif found:
                kind = found[1]
                words[kind] = json.loads(found[2])
            elif line.startswith('"'):
                words[kind] += json.loads(line)
        if words.get("msgid"):
            said = [words[key] for key in sorted(words) if key.startswith("msgstr") and words[key]]
            yield flags, words["msgid"], words.get("msgid_plural"), said


def problems_of(flags, text, plural, said):
    """What a translation loses or adds, in words."""
    sources = [text] if plural is None else [text, plural]
    fields = set().union(*(FIELD.findall(source) for source in sources))
    for index, words in enumerate(said):
        here = set(FIELD.findall(words))
        # "one pick" needs no number; the other forms have every name.
        missing = set() if plural is not None and index == 0 and len(said) > 1 else fields - here
        for name in sorted(missing):
            yield f"{name} is missing"
        for name in sorted(here - fields):
            yield f"{name} is not in the text"
        if "c-format" in flags and FIGURE.findall(words) != FIGURE.findall(text):
            yield "another figure"
        if words.endswith("\n") != text.endswith("\n"):
            yield "another line end"
        for kept in KEPT:
            for word in kept.findall(text) if plural is None else ():
                if word not in words:  # inside a longer word too, since languages inflect
                    yield f"{word} is missing"


def main(catalogues):
    failed = 0
    for catalogue in catalogues:
        count = 0
        for flags, text, plural, said in texts_of(catalogue):
            if "fuzzy" in flags:
                continue  # not shown
            count += bool(said)
            for problem in problems_of(flags, text, plural, said):
                failed += 1
                print(f"{catalogue}: {problem}: {text!r}", file=sys.stderr)
        print(f"{catalogue}: {count} texts")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
