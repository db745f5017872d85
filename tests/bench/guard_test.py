# SPDX-License-Identifier: Apache-2.0
"""Tests `poinsot bench --guard`: counts repeat, an increase fails, and a decrease or another compiler is reported.

    guard_test.py BENCH PROGRAM
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

BENCH, PROGRAM = sys.argv.pop(1), sys.argv.pop(1)


def guard(*options, program=PROGRAM):
    """Runs the guard with its own temporary folder. `left` of the result names the files that stay there."""
    with tempfile.TemporaryDirectory() as folder:
        # If the guard kept these variables, the first would turn off counting, and the second would change the counts.
        changes = {'TMPDIR': folder, 'VALGRIND_OPTS': '--tool=none', 'GLIBC_TUNABLES': 'glibc.cpu.hwcaps=-AVX2_Usable'}
        run = subprocess.run([sys.executable, '-B', BENCH, '--program', program, '--guard', *options],
                             capture_output=True, text=True, env=os.environ | changes)
        run.left = os.listdir(folder)
    return run


def counts(report):
    """Returns recorded and counted instructions in a report, by part."""
    return {part: (int(recorded.replace(' ', '')), int(counted.replace(' ', '')))
            for part, recorded, counted in re.findall(r'^\| (\w+) +\| +([\d ]+\d) \| +([\d ]+\d) \|', report, re.M)}


class Guard(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # Makes a record, because guard.toml may be of another compiler.
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.figures = pathlib.Path(cls.folder.name, 'figures.toml')
        cls.recording = guard('--record', '--figures', cls.figures)
        assert cls.recording.returncode == 0, cls.recording.stderr

    def against(self, text):
        """Counts the cheapest part, and compares it with a record of this text."""
        changed = pathlib.Path(self.folder.name, 'changed.toml')
        changed.write_text(text)
        return guard('--quick', '--figures', changed)

    def with_motion(self, factor):
        """Returns the record with the count of the motion multiplied by a factor."""
        return re.sub(r'(?<=^motion = )\d+', lambda number: str(round(int(number[0]) * factor)),
                      self.figures.read_text(), flags=re.M)

    def test_every_part_is_recorded(self):
        recorded = counts(self.recording.stdout)
        self.assertEqual(list(recorded), ['motion', 'compose', 'convert', 'compare', 'png'])
        for part, (number, counted) in recorded.items():
            self.assertGreater(number, 1e6, part)  # a part that was optimised away would have none
            self.assertEqual(number, counted)
            self.assertIn(f'\n{part} = {number}\n', self.figures.read_text())
        self.assertEqual(self.recording.left, [])

    def test_counts_are_the_same_each_time(self):
        run = guard('--quick', '--figures', self.figures)
        self.assertEqual((run.returncode, run.left), (0, []), run.stderr)
        recorded, counted = counts(run.stdout)['motion']
        self.assertAlmostEqual(counted / recorded, 1, delta=1e-3)
        self.assertNotIn('recorded;', run.stdout)

    def test_fails_if_a_part_takes_6_percent_more(self):
        run = self.against(self.with_motion(1 / 1.06))
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn('motion: 6.0% more than recorded', run.stdout)

    def test_passes_if_a_part_takes_4_percent_more(self):
        run = self.against(self.with_motion(1 / 1.04))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotIn('than recorded', run.stdout)

    def test_reports_a_part_that_takes_6_percent_less(self):
        run = self.against(self.with_motion(1 / 0.94))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn('motion: 6.0% less than recorded; to keep it so, record it', run.stdout)

    def test_refuses_no_part_with_another_compiler(self):
        run = self.against(re.sub('^compiler = .*', 'compiler = "Another 1.0"', self.with_motion(0.5), flags=re.M))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn('no part is refused: compiler ', run.stdout)
        self.assertIn('(recorded: Another 1.0)', run.stdout)
        self.assertIn('motion: 100.0% more than recorded', run.stdout)

    def test_rejects_malformed_records(self):
        for text, message in (('', "the table 'made_with' is missing"), ('[made_with', 'changed.toml: '),
                              ('instructions = 3\nmade_with = 4', 'changed.toml: '),
                              (self.with_motion(0), 'motion: no count of instructions is recorded')):
            run = self.against(text)
            self.assertEqual((run.returncode, run.stdout), (2, ''), text)
            self.assertIn(message, run.stderr)

    def test_reports_missing_programs_and_records(self):
        run = guard('--figures', self.figures, program='/bin/false')
        self.assertEqual((run.returncode, run.stdout, run.left), (3, '', []))
        self.assertIn('/poinsot_guard', run.stderr)
        self.assertEqual(guard('--figures', '/none').returncode, 4)

    def test_rejects_conflicting_options(self):
        for options in (['--record', '--quick'], ['--runs', '2'], ['--jobs', 'T']):
            self.assertEqual(guard(*options).returncode, 2, options)


if __name__ == '__main__':
    unittest.main()
