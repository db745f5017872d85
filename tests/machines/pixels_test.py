# SPDX-License-Identifier: Apache-2.0
"""Tests that pixels.py measures back ends, and reports systems that draw differently, lack a back end or fail.

    pixels_test.py PROGRAM
"""
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

from pixel_table import markdown

PROGRAM = sys.argv.pop(1)
PIXELS = pathlib.Path(__file__).with_name("pixels.py")
# Fakes a system without OSMesa, whose Mesa draws the stills differently but the suite the same.
OTHER_SYSTEM = f"""#!/bin/sh
case $1 in
  doctor)
    echo 'poinsot 0.1.0'
    echo 'absent  OpenGL osmesa   no libOSMesa.so.8 (Mesa 25.1 and later have'
    echo '                        none)'
    echo 'ok      OpenGL egl      llvmpipe (LLVM 21.1.8, 256 bits), OpenGL 4.5 (Core Profile) Mesa 26.2.0'
    ;;
  gallery) exec {shlex.quote(PROGRAM)} "$@" -D style.theme=dark ;;
  *) exec {shlex.quote(PROGRAM)} "$@" ;;
esac
"""


def pixels(*options):
    return subprocess.run([sys.executable, "-B", PIXELS, "--diff-by", PROGRAM, *options], capture_output=True, text=True)


def working():
    findings = subprocess.run([PROGRAM, "doctor"], capture_output=True, text=True).stdout
    return re.findall(r"^ok +OpenGL (\w+)", findings, re.MULTILINE)


class Pixels(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Measures two stills and one test of the suite, on this machine and on the other system."""
        with tempfile.TemporaryDirectory() as folder:
            other, report = pathlib.Path(folder, "poinsot"), pathlib.Path(folder, "report.json")
            other.write_text(OTHER_SYSTEM)
            other.chmod(0o755)
            cls.run_ = pixels("--program", PROGRAM, "--program", other, "--enter", "env -C / sh -c",
                              "--name", "sid", "--size", "192x108", "--stills", "football", "sphere",
                              "--suite", "gallery_sphere", "--json", report)
            cls.rows = json.loads(report.read_text())["rows"] if report.exists() else []

    def test_back_ends_of_one_mesa_draw_the_same(self):
        self.assertTrue(self.rows, self.run_.stderr)
        own = self.rows[:-2]
        self.assertEqual([row["backend"] for row in own], [name for name in working() for _ in range(2)])
        self.assertEqual([row["is_reference"] for row in own], [True] + [False] * (len(own) - 1))
        for row in own:
            # OSMesa and EGL are promised to draw the same bytes.
            count = {"stills": 2, "suite": 1}[row["set"]]
            self.assertEqual((row["pictures"], row["equal"], row["differing_pixels"]), (count, count, 0), row)

    def test_a_system_behind_a_command_is_compared_with_the_first(self):
        self.assertEqual(self.run_.returncode, 1, self.run_.stderr)
        stills, suite = self.rows[-2:]
        self.assertEqual((stills["system"], stills["mesa"], stills["llvm"], stills["backend"]), ("sid", "26.2.0", "21.1.8", "egl"))
        self.assertEqual((stills["verdict"], stills["equal"]), ("different", 0))
        self.assertEqual({each["name"] for each in stills["moved"]}, {"football.png", "sphere.png"})
        self.assertGreater(stills["differing_pixels"], 192 * 108)  # the background of both pictures differs
        self.assertEqual((suite["verdict"], suite["equal"]), ("identical", 1))
        self.assertIn("\nsid has no osmesa.\n", self.run_.stdout)

    def test_failures_and_wrong_options_have_exit_codes(self):
        missing = pixels("--program", "/nowhere/none")
        self.assertEqual(missing.returncode, 3)
        self.assertIn("none: exit code", missing.stderr)
        undrawn = pixels("--program", PROGRAM, "--size", "192x108", "--stills", "no_such_scene")
        self.assertEqual(undrawn.returncode, 3)
        self.assertIn("no_such_scene: no such scene", undrawn.stderr)
        self.assertEqual(pixels("--enter", "sh -c", "--program", PROGRAM).returncode, 2)
        self.assertEqual(pixels("--program", "bin/poinsot", "--enter", "sh -c").returncode, 2)

    def test_the_table_names_pictures_that_move(self):
        row = {"system": "Debian 13", "mesa": "25.0.7", "llvm": None, "backend": "egl", "set": "stills", "is_reference": False,
               "pictures": 29, "equal": 27, "verdict": "near", "differing_pixels": 1002, "max_difference": 1,
               "moved": [{"name": "a.png", "verdict": "near", "differing_pixels": 2, "max_difference": 1},
                         {"name": "b.png", "verdict": "near", "differing_pixels": 1000, "max_difference": 1}]}
        self.assertEqual(markdown({"size": "1920x1080", "rows": [row], "absent": []}).splitlines()[-1],
                         "| Debian 13 | 25.0.7 |  | egl | stills of 1920x1080 | 27 of 29 | 1 002 | 1 | near "
                         "| b (1000 by 1), a (2 by 1) |")


if __name__ == "__main__":
    unittest.main()
