#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Times the rules of compare.py on the same pairs of pictures, in turns, and prints the median time of each.

  PYTHONPATH=build/python tools/real_suites/seconds.py --pixelmatch PACKAGES --program build/bin/poinsot SUITE...

Each time includes reading both files. Every rule uses one thread, except the last row.
"""

import argparse
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

import poinsot
from compare import by_pixelmatch, rms, version


def pairs_of(suites, number):
    pairs = [(expected, suite / "actual" / expected.name) for suite in suites for expected in sorted((suite / "expected").glob("*.png"))]
    return pairs[:number]


def folders_of(pairs, root):
    """Links the pairs into two folders, because the command compares folders."""
    for name, side in (("expected", 0), ("actual", 1)):
        (root / name).mkdir()
        for index, pair in enumerate(pairs):
            (root / name / f"{index:04}.png").symlink_to(pair[side].resolve())
    return root / "expected", root / "actual"


def by_command(program, folders, jobs):
    done = subprocess.run([program, "diff", *folders, "--json", "-j", str(jobs)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{program} diff: exit code {done.returncode}")


def seconds(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pixelmatch", metavar="PACKAGES", type=Path, required=True, help="folder of the npm packages")
    parser.add_argument("--program", metavar="FILE", required=True, help="the program poinsot")
    parser.add_argument("--pairs", metavar="N", type=int, default=500)
    parser.add_argument("--rounds", metavar="N", type=int, default=3)
    parser.add_argument("suite", type=Path, nargs="+")
    options = parser.parse_args()
    pairs = pairs_of(options.suite, options.pairs)
    with tempfile.TemporaryDirectory() as root:
        folders = folders_of(pairs, Path(root))
        works = {"RMS of Matplotlib": lambda: [rms(*pair) for pair in pairs],
                 version(options.pixelmatch): lambda: by_pixelmatch(options.pixelmatch, pairs),
                 "poinsot.diff() in Python": lambda: [poinsot.diff(*pair, jobs=1) for pair in pairs],
                 "poinsot diff, one thread": lambda: by_command(options.program, folders, 1),
                 "poinsot diff, two threads": lambda: by_command(options.program, folders, 2)}
        times = {name: [] for name in works}
        for _ in range(options.rounds):
            for name, work in works.items():
                times[name].append(seconds(work))
    print(f"| {len(pairs)} pairs | seconds | milliseconds a pair |\n| --- | ---: | ---: |")
    for name, measured in times.items():
        median = statistics.median(measured)
        print(f"| {name} | {median:.1f} | {1000 * median / len(pairs):.1f} |")


if __name__ == "__main__":
    main()
