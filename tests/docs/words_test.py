# SPDX-License-Identifier: Apache-2.0
"""Tests words.py with one planted fault of each kind, then holds every source and page to it."""
import json
import unittest

import words

SENTENCE = "word " * (words.MOST_WORDS - 1) + "word."
LONG = "word " * words.LONG_WORDS + "word."


def problems(path, text):
    return [problem.split(": ", 1)[1] for problem in words.problems(path, text)]


class Words(unittest.TestCase):
    def test_finds_a_headless_comment(self):
        self.assertEqual(problems("src/a.h", "int a;\n/// Of all that was added.\nint b();\n"),
                         ["begins with Of: Of all that was added."])
        self.assertEqual(problems("src/a.cpp", "int a = 1;  // that of b\n/* What is told. */\n"),
                         ["begins with What: What is told."])
        self.assertEqual(problems("a.py", 'def f():\n    """By its name."""\n    # As before\n'),
                         ["begins with As: As before", "begins with By: By its name."])

    def test_reads_comment_lines_in_a_row_as_one(self):
        self.assertEqual(problems("src/a.h", "/// Returns the sum\n/// Of all parts.\n"), [])
        self.assertEqual(problems("src/a.h", "/// Returns the sum.\n\n/// Of all parts.\n"), ["begins with Of: Of all parts."])

    def test_keeps_the_licence_apart_from_the_comment_below(self):
        for start, path in (("//", "src/a.h"), ("#", "a.py")):
            self.assertEqual(problems(path, f"{start} {words.LICENCE}: Apache-2.0\n{start} What is read.\n"),
                             ["begins with What: What is read."])

    def test_takes_no_string_for_a_comment(self):
        self.assertEqual(problems("src/a.cpp", 'f("// Of a", R"(// Of b)", \'"\');  // Of c\n'), ["begins with Of: Of c"])

    def test_finds_a_headless_text_of_a_key(self):
        text = '{.path = "body.mass",\n .help = "Of the body, "\n "in kilograms."},\n'
        self.assertEqual(problems("src/scene/keys/key_table_body.cpp", text), ["begins with Of: Of the body, in kilograms."])
        self.assertEqual(problems("src/scene/keys/check.cpp", text), [])

    def test_finds_no_where_not_a_is_meant(self):
        self.assertEqual(problems("src/a.cpp", 'refuse("x is "\n "no number");\n'), ['write "is not a": is no number'])
        self.assertEqual(problems("a.md", "A film is no picture.\n"), ['write "is not a": is no picture'])
        self.assertEqual(problems("a.md", "There is no picture, and it is no longer needed.\n"), [])

    def test_finds_a_sentence_too_long(self):
        self.assertEqual(problems("a.md", SENTENCE), [])
        self.assertEqual(problems("a.md", f"# A\n\n- Short.\n- Word {SENTENCE}\n"),
                         [f"33 words, more than 32: {('Word ' + SENTENCE)[:60]}"])
        self.assertEqual(len(problems("a.md", f"| a | b |\n| - | - |\n| c | Word {SENTENCE} |\n")), 1)

    def test_counts_code_as_one_word_and_code_blocks_as_none(self):
        self.assertEqual(problems("a.md", f"`{SENTENCE}` {SENTENCE[5:]}\n\n```\nWord {SENTENCE}\n```\n"), [])

    def test_counts_a_list_of_quoted_words_as_one_word(self):
        listed = ", ".join(f'"word_{i}"' for i in range(words.MOST_WORDS + 1))
        self.assertEqual(problems("a.md", f"| a | b |\n| - | - |\n| c | {listed} |\n"), [])

    def test_reads_a_notebook(self):
        def notebook(**cell):
            return json.dumps({"cells": [{"cell_type": kind, "source": [source]} for kind, source in cell.items()]})

        self.assertEqual(problems("a.ipynb", notebook(markdown=SENTENCE, code="b = 1  # b\nb")), [])
        self.assertEqual(problems("a.ipynb", notebook(markdown=f"Word {SENTENCE}")),
                         [f"33 words, more than 32: {('Word ' + SENTENCE)[:60]}"])
        self.assertEqual(problems("a.ipynb", notebook(code="b = 1  # That of b")), ["begins with That: That of b"])

    def test_counts_a_formula_of_a_notebook_as_one_word_or_none(self):
        text = f"$a + b = c$ {SENTENCE[5:-1]}\n\n$$a + b\n= c$$\n\nand so on."
        self.assertEqual(problems("a.ipynb", json.dumps({"cells": [{"cell_type": "markdown", "source": [text]}]})), [])

    def test_finds_a_page_with_too_many_long_sentences(self):
        page = "A word.\n\n" * 18 + f"{LONG}\n\n"
        self.assertEqual(problems("a.md", page + "A word.\n"), [])
        self.assertEqual(problems("a.md", page + f"{LONG}\n"), ["2 of 20 sentences have more than 25 words"])


class EverySourceAndPage(unittest.TestCase):
    def test_is_found(self):
        found = set(words.files())
        self.assertLess({"README.md", "docs/scene.md", "src/core/error.h", "tests/docs/words.py",
                         "python/notebooks/lecture15.ipynb"}, found)

    def test_keeps_the_rules(self):
        found = [problem for path in words.files() for problem in words.problems(path, (words.ROOT / path).read_text())]
        self.assertEqual(found, [])


if __name__ == "__main__":
    unittest.main()
