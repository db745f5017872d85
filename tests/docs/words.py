# SPDX-License-Identifier: Apache-2.0
"""Holds comments, texts of keys, messages and pages to plain English, as far as a script can see it.

    words.py [FILE ...]    prints FILE:LINE: PROBLEM for each; without files, all sources and pages
"""
import collections
import json
import pathlib
import re
import sys

from markdown_it import MarkdownIt

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_WORDS = 32  # of a sentence of a page
LONG_WORDS, LONG_SHARE = 25, 0.05  # at most this share of a page's sentences has more words
FEWEST_SENTENCES = 20  # of a page that a share is asked of

FOLDERS = ("bench", "cmake", "docs", "examples", "packaging", "python", "src", "tests", "tools")

LICENCE = "SPDX-License-Identifier"  # a line of its own in every source

Text = collections.namedtuple("Text", "path line text")

HEADLESS = re.compile(r"(Of|What|Whatever|Those|That|As|By|So|Their|Such|Which|Who|Whose)\b")
# Finds "is no" before a noun, except "there is no" and "is no longer".
NO_NOUN = re.compile(r"(?<![Tt]here )\b(?:is|are|was|were) no (?!longer\b|more\b|less\b|fewer\b|other\b|better\b|worse\b)\w+")
CPP_TOKEN = re.compile(r"""(?P<line>//[^\n]*)|(?P<block>/\*.*?\*/)|(?P<raw>R"(?P<tag>[^(\s]*)\((?P<inside>.*?)\)(?P=tag)")"""
                       r"""|"(?P<string>(?:\\.|[^"\\\n])*)"|'(?:\\.|[^'\\\n])+'""", re.S)


def _line(text, offset):
    return text.count("\n", 0, offset) + 1


def _joined(pieces):
    """Merges pieces (first line, last line, indented?, text) that follow each other line by line."""
    merged = []
    for first, last, own, text in pieces:
        if merged and own and merged[-1][2] and first == merged[-1][1] + 1:
            merged[-1] = (merged[-1][0], last, own, f"{merged[-1][3]} {text}".strip())
        else:
            merged.append((first, last, own, text))
    return merged


def comments(path, text):
    """Returns a C++ source's comments; lines of // that follow each other are one comment."""
    pieces = []
    for token in CPP_TOKEN.finditer(text):
        said = token["line"] or token["block"]
        if not said:
            continue
        if LICENCE in said:
            continue
        own = not text[text.rfind("\n", 0, token.start()) + 1:token.start()].strip()
        plain = " ".join(re.sub(r"^\s*(?:/\*+|///?<?|\*/|\*)|\*/$", "", row).strip() for row in said.split("\n"))
        pieces.append((_line(text, token.start()), _line(text, token.end()), own, plain.strip()))
    return [Text(path, first, said) for first, _, _, said in _joined(pieces)
            if said and not said.startswith(("NOLINT", "clang-format"))]


def strings(path, text):
    """Returns a C++ source's string literals; literals with nothing but blanks between them are one."""
    found, end = [], None
    for token in CPP_TOKEN.finditer(text):
        said = token["inside"] if token["raw"] else token["string"]
        if said is None:
            continue
        said = said.replace("\\n", "\n").replace('\\"', '"')
        if end is not None and not text[end:token.start()].strip():
            found[-1] = found[-1]._replace(text=found[-1].text + said)
        else:
            found.append(Text(path, _line(text, token.start()), said))
        end = token.end()
    return found


def python_texts(path, text):
    """Returns a Python source's comments and docstrings."""
    import ast
    import io
    import tokenize
    pieces = [(token.start[0], token.end[0], not token.line[:token.start[1]].strip(), token.string.lstrip("#! "))
              for token in tokenize.generate_tokens(io.StringIO(text).readline)
              if token.type == tokenize.COMMENT and LICENCE not in token.string]
    found = [Text(path, first, said) for first, _, _, said in _joined(pieces) if said]
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and (said := ast.get_docstring(node)):
            found.append(Text(path, node.body[0].lineno, said))
    return found


def paragraphs(path, text):
    """Returns a page's paragraphs, items of lists and cells of tables."""
    found, line = [], 1
    for token in MarkdownIt("commonmark").enable("table").parse(text):
        line = token.map[0] + 1 if token.map else line
        if token.type != "inline":
            continue
        words = [{"text": child.content, "code_inline": f"`{child.content}`", "softbreak": " ", "hardbreak": " "}.get(child.type, "")
                 for child in token.children]
        found.append(Text(path, line, "".join(words)))
    return found


def notebook_texts(path, text):
    """Returns a notebook's text cells as one page, in which formulas are one word or none, and its comments in code."""
    cells = [(cell["cell_type"], "".join(cell["source"])) for cell in json.loads(text)["cells"]]
    page = "\n\n".join(source for kind, source in cells if kind == "markdown")
    page = re.sub(r"\$[^$]+\$", "`formula`", re.sub(r"\$\$.+?\$\$", "", page, flags=re.S))
    return page, [said for kind, source in cells if kind == "code" for said in python_texts(path, source)]


def sentences(text):
    """Splits a paragraph at full stops, question marks and exclamation marks.

    A code span becomes one word, and so does a list of quoted words, such as those that a key takes.
    """
    flat = re.sub(r"\s+", " ", re.sub(r'`[^`]*`|"\w+"(?:, "\w+")+', "`code`", text))
    flat = re.sub(r"\b(e\.g|i\.e|cf|vs|approx|Eq|Fig|No)\. ", r"\1 ", flat)
    return [part for part in re.split(r"(?<=[.!?])[)\"'”]* (?=[A-Z`(\"'“\d])", flat) if part]


def count_words(sentence):
    return sum(any(letter.isalnum() for letter in word) for word in sentence.split())


def page_problems(path, text):
    all_sentences = [(part.line, sentence) for part in paragraphs(path, text) for sentence in sentences(part.text)]
    for line, sentence in all_sentences:
        if (count := count_words(sentence)) > MOST_WORDS:
            yield f"{path}:{line}: {count} words, more than {MOST_WORDS}: {sentence[:60]}"
    long = sum(count_words(sentence) > LONG_WORDS for _, sentence in all_sentences)
    if len(all_sentences) >= FEWEST_SENTENCES and long > LONG_SHARE * len(all_sentences):
        yield f"{path}:1: {long} of {len(all_sentences)} sentences have more than {LONG_WORDS} words"


def headless(texts):
    return (f"{path}:{line}: begins with {match[1]}: {text[:60]}" for path, line, text in texts
            if (match := HEADLESS.match(text)))


def no_nouns(texts):
    return (f"{path}:{line}: write \"is not a\": {match[0]}" for path, line, text in texts
            for match in NO_NOUN.finditer(text))


def problems(path, text):
    """Returns what a script can see in a file; the ending of its name says what it holds."""
    suffix = pathlib.PurePath(path).suffix
    if suffix in (".cpp", ".h"):
        said, kept = comments(path, text), strings(path, text)
        texts = said + ([] if path.startswith("tests/") else kept)
        helps = [part for part in kept if "/key_table" in path and " " in part.text]
        return [*headless(said), *headless(helps), *no_nouns(texts)]
    if suffix == ".py":
        said = python_texts(path, text)
        return [*headless(said), *no_nouns(said)]
    if suffix == ".ipynb":
        page, said = notebook_texts(path, text)
        return [*page_problems(path, page), *no_nouns(paragraphs(path, page)), *headless(said), *no_nouns(said)]
    if suffix == ".md":
        return [*page_problems(path, text), *no_nouns(paragraphs(path, text))]
    return []


def files():
    """Returns the sources and pages of the repository, the journal of measurements apart.

    It walks the folders, because a machine that only builds and tests need not have git.
    """
    found = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.suffix in (".cpp", ".h", ".py", ".md", ".ipynb")]
    listed = [str(path.relative_to(ROOT)) for path in [*ROOT.glob("*.md"), *found]]
    return sorted(path for path in listed if not path.startswith("bench/journal/"))


def main():
    found = [problem for path in sys.argv[1:] or files() for problem in problems(path, (ROOT / path).read_text())]
    print(*found, sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
