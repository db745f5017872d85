# SPDX-License-Identifier: Apache-2.0
"""Tests `poinsot bench --quick`: every job has figures, failures are reported, and no temporary file stays.

    bench_test.py BENCH PROGRAM
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

BENCH, PROGRAM = sys.argv.pop(1), sys.argv.pop(1)


def bench(*options, program=PROGRAM):
    """Runs bench with its own temporary folder. `left` of the result names the files that stay there."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([sys.executable, '-B', BENCH, '--program', program, *options], capture_output=True,
                             text=True, env=os.environ | {'TMPDIR': folder})
        run.left = os.listdir(folder)
    return run


def rows(report):
    """Returns the rows of all tables, by their first cell up to a colon."""
    cells = [[cell.strip() for cell in line.strip('|').split('|')] for line in report.splitlines() if line[:1] == '|']
    return {row[0].split(':')[0]: row[1:] for row in cells}


class Bench(unittest.TestCase):
    def test_every_job_has_figures(self):
        with tempfile.TemporaryDirectory() as folder:
            markdown = pathlib.Path(folder, 'figures.md')
            run = bench('--quick', '--markdown', markdown)
            self.assertEqual((run.returncode, run.left), (0, []), run.stderr)
            self.assertEqual(markdown.read_text(), run.stdout)
        found = rows(run.stdout)
        for job in ('J1', 'J2', 'J3', 'J3 cold', 'J4', 'J5', 'T', 'S', 'S check', 'S diff'):
            figures = [float(cell.split()[0]) for cell in found[job]]
            self.assertEqual(len(figures), 5)
            count, wall, rate, *others = figures
            self.assertTrue(all(figure > 0 for figure in (count, wall, *others)), (job, figures))
            # If a frame takes over 20 s, as under a sanitizer, the rate is rounded to 0.0 per second.
            self.assertTrue(rate > 0 or wall > 20 * count, (job, figures))
        for step in ('simulate', 'compose', 'draw', 'resolve', 'read', 'text', 'convert', 'encode'):
            spent = float(found[f'{step}, per frame'][0])
            self.assertTrue(spent > 0, (step, spent))

    def test_reports_a_command_that_fails(self):
        run = bench('--jobs', 'T', program='/bin/false')
        self.assertEqual((run.returncode, run.stdout, run.left), (3, '', []))
        self.assertIn('poinsot bench: error: status 1: ', run.stderr)
        self.assertIn('/false trajectory', run.stderr)

    def test_rejects_an_unknown_job(self):
        run = bench('--jobs', 'J1,J9')
        self.assertEqual((run.returncode, run.stdout), (2, ''))
        self.assertIn("unknown job 'J9'; known jobs: J1, J2, J3, J4, J5, S, T", run.stderr)


if __name__ == '__main__':
    unittest.main()
