# SPDX-License-Identifier: Apache-2.0
"""Draws comments, names of tests, messages and paragraphs for readers to rate, without their origin.

    sample.py SEED OUT [--code FOLDER] [--pages FOLDER]

SEED is a commit's hash. OUT gets numbered texts in random order, OUT.key the origin of each. --code mixes in comments
of other projects' C++ sources, --pages paragraphs of their manuals (Markdown or reStructuredText).
"""
import argparse
import json
import pathlib
import random
import re

import words

COUNTS = {"comment": 60, "test name": 30, "message": 30, "paragraph": 20}
OTHER_COUNTS = {"comment": 40, "paragraph": 20}
TEST_NAME = re.compile(r"^TEST(?:_[FP])?\((\w+),\s*(\w+)\)", re.M)


def read(path):
    return (words.ROOT / path).read_text(errors="replace")


def with_code(path, text):
    """Returns the comments of a C++ source, each with the line of code that an editor shows beside it."""
    rows = text.split("\n")
    found = []
    for part in words.comments(path, text):
        at = part.line - 1
        while at < len(rows) and rows[at].lstrip().startswith(("//", "*", "/*")):
            at += 1
        code = re.sub(r"\s*//.*", "", rows[at]).strip() if at < len(rows) else ""
        if len(part.text.split()) > 2 and not re.search(r"copyright|licen[cs]e|SPDX", part.text, re.I):
            found.append(words.Text(path, part.line, f"{part.text}\n    {code}"))
    return found


def messages(path, text):
    """Returns the literals of a source that hold a phrase in lower case: four words and more."""
    return [part for part in words.strings(path, text)
            if len(re.findall(r"(?:^| )[a-z]{2,}(?=[ ,;:.]|$)", part.text)) >= 4 and "\n" not in part.text.strip()]


def page_paragraphs(path, text):
    """Returns paragraphs of prose: whole sentences, twelve words and more."""
    return [part for part in words.paragraphs(path, text)
            if len(part.text.split()) >= 12 and part.text.rstrip("`)\"”*").endswith((".", ":", "?", "!"))]


def own():
    paths = words.files()
    sources = [path for path in paths if path.startswith("src/") and path.endswith((".cpp", ".h"))]
    tests = [path for path in paths if path.startswith("tests/") and path.endswith(".cpp")]
    return {
        "comment": [part for path in sources for part in with_code(path, read(path))],
        "test name": [words.Text(path, 0, f"{suite}.{name}") for path in tests for suite, name in TEST_NAME.findall(read(path))],
        "message": [part for path in sources if "/key_table" not in path for part in messages(path, read(path))],
        "paragraph": [part for path in paths if path.endswith(".md") for part in page_paragraphs(path, read(path))],
    }


def others(folder, kind):
    endings = {"comment": (".h", ".cpp"), "paragraph": (".md", ".rst", ".txt")}[kind]
    found = []
    for path in sorted(pathlib.Path(folder).rglob("*")):
        if path.suffix in endings and path.is_file():
            text = path.read_text(errors="replace")
            found += with_code(str(path), text) if kind == "comment" else page_paragraphs(str(path), text)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seed")
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--code")
    parser.add_argument("--pages")
    asked = parser.parse_args()
    draw = random.Random(asked.seed)
    drawn = [("ours", kind, part) for kind, parts in own().items() for part in draw.sample(parts, COUNTS[kind])]
    for kind, folder in {"comment": asked.code, "paragraph": asked.pages}.items():
        if folder:
            drawn += [("other", kind, part) for part in draw.sample(others(folder, kind), OTHER_COUNTS[kind])]
    draw.shuffle(drawn)
    asked.out.write_text("".join(f"{number}. [{kind}] {part.text}\n\n" for number, (_, kind, part) in enumerate(drawn, 1)))
    key = {number: [whose, kind, part.path, part.line] for number, (whose, kind, part) in enumerate(drawn, 1)}
    pathlib.Path(f"{asked.out}.key").write_text(json.dumps(key, indent=0) + "\n")


if __name__ == "__main__":
    main()
