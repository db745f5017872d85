# SPDX-License-Identifier: Apache-2.0
"""Tests that every library is compiled with its own optimisation options.

gcc silently takes optimisation options from a precompiled header instead of the command line. With the header of another
library, a library's own options would have no effect, and closed forms would differ between CPUs.

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
MADE = HEADER + '.cxx'  # source of a precompiled header
KEPT = '-fno-tree-vectorize'  # option of physics: sums keep their written order


def commands():
    """Returns each compiled file, also precompiled headers, with the words of its command."""
    entries = json.loads((BUILD / 'compile_commands.json').read_text())
    return [(entry['file'], shlex.split(entry['command'])) for entry in entries]


def header_of(words):
    """Returns the precompiled header that a file is compiled with, or None."""
    included = [after for before, after in zip(words, words[1:]) if before == '-include']
    return next((path for path in included if path.endswith(HEADER)), None)


def optimising(words):
    """Returns the options -f, -O and -m, without -fmacro-prefix-map and its path."""
    return {word for word in words if re.match('-[fOm]', word) and '=/' not in word}


class OwnOptions(unittest.TestCase):
    def test_precompiled_headers_have_the_options_of_their_users(self):
        compiled = commands()
        made = {file.removesuffix('.cxx'): optimising(words) for file, words in compiled if file.endswith(MADE)}
        users = [(file, words) for file, words in compiled if header_of(words) and not file.endswith(MADE)]
        if not users:
            self.skipTest('POINSOT_PCH=OFF: no headers are precompiled')
        for file, words in users:
            self.assertEqual(optimising(words), made[header_of(words)], file)

    def test_physics_is_compiled_with_its_own_options(self):
        physics = [words for file, words in commands()
                   if '/poinsot_physics.dir/' in words[words.index('-o') + 1] and not file.endswith(MADE)]
        self.assertTrue(physics)
        for words in physics:
            self.assertIn(KEPT, words)


if __name__ == '__main__':
    unittest.main()
