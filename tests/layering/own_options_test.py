# SPDX-License-Identifier: Apache-2.0
"""What is optimised how is said where a library is made, and so it is compiled.

gcc takes the options of optimisation from a precompiled header in place of those of the command line, and says nothing:
with somebody else's headers a library's own options do nothing, and a closed form is another from one CPU to the next.

    own_options_test.py BUILD_FOLDER
"""
import json
import pathlib
import re
import shlex
import sys
import unittest

BUILD = pathlib.Path(sys.argv.pop(1))
HEADER = 'cmake_pch.hxx'
MADE = HEADER + '.cxx'  # what is compiled to make one
KEPT = '-fno-tree-vectorize'  # of physics: sums in the order in which they are written


def commands():
    """Of each compiled file its words, the precompiled headers among them."""
    entries = json.loads((BUILD / 'compile_commands.json').read_text())
    return [(entry['file'], shlex.split(entry['command'])) for entry in entries]


def header_of(words):
    """The precompiled header that a file is compiled with, or None."""
    included = [after for before, after in zip(words, words[1:]) if before == '-include']
    return next((path for path in included if path.endswith(HEADER)), None)


def optimising(words):
    """Paths apart: those are of -fmacro-prefix-map."""
    return {word for word in words if re.match('-[fOm]', word) and '=/' not in word}


class OwnOptions(unittest.TestCase):
    def test_headers_are_made_with_the_options_of_who_uses_them(self):
        compiled = commands()
        made = {file.removesuffix('.cxx'): optimising(words) for file, words in compiled if file.endswith(MADE)}
        users = [(file, words) for file, words in compiled if header_of(words) and not file.endswith(MADE)]
        if not users:
            self.skipTest('POINSOT_PCH=OFF: no headers are precompiled')
        for file, words in users:
            self.assertEqual(optimising(words), made[header_of(words)], file)

    def test_physics_has_options_of_its_own(self):
        physics = [words for file, words in commands()
                   if '/poinsot_physics.dir/' in words[words.index('-o') + 1] and not file.endswith(MADE)]
        self.assertTrue(physics)
        for words in physics:
            self.assertIn(KEPT, words)


if __name__ == '__main__':
    unittest.main()
