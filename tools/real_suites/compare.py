#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Judges the pictures of other projects by three rules and prints tables in Markdown.

  npm install --prefix PACKAGES pixelmatch pngjs
  PYTHONPATH=build/python tools/real_suites/compare.py --pixelmatch PACKAGES SUITE...

SUITE is a folder with expected/NAME.png and actual/NAME.png (collect.py makes it). The rules:

  RMS         calculate_rms() of Matplotlib with the tolerance 2, the default of pytest-mpl
  pixelmatch  no pixel may differ, with the default options of the npm package; to compare two versions of the package,
              give --pixelmatch twice
  poinsot     the default rule of poinsot.diff(), or --rule NAME

Each rule reports a pair of different size. --json FILE writes the figures of each pair, and --list prints the pairs on
which the rules disagree. A SUITE may also be such a FILE; its pictures are not compared again.
"""

import argparse
import json
import statistics
import subprocess
from collections import Counter
from dataclasses import asdict, dataclass, field
from pathlib import Path

import numpy as np
import poinsot
from matplotlib.testing.compare import calculate_rms
from matplotlib.testing.exceptions import ImageComparisonFailure
from PIL import Image

TOLERANCE = 2  # of RMS


@dataclass
class Pair:
    suite: str
    name: str
    changed: bool = False                    # the decoded pixels differ
    rms: float | None = None                 # None: the sizes differ
    pixels: dict = field(default_factory=dict)    # version of pixelmatch: differing pixels; None: the sizes differ
    flip: float | None = None                # mean of FLIP; None: the sizes differ
    beyond: list = field(default_factory=list)    # limits of poinsot that do not hold
    reported: list = field(default_factory=list)  # rules that report the pair


def pixels(path):
    """Returns the pixels as Matplotlib compares them: RGB, or RGBA if a pixel is transparent."""
    rgba = np.asarray(Image.open(path).convert("RGBA")).astype(np.int16)
    return rgba if rgba[..., 3].min() < 255 else rgba[..., :3]


def rms(expected, actual):
    """Returns the root mean square that Matplotlib computes, or None for pictures of different size."""
    try:
        return float(calculate_rms(pixels(expected), pixels(actual)))
    except ImageComparisonFailure:
        return None


def by_poinsot(expected, actual, rule):
    """Returns FLIP's mean, which is None for pictures of different size, and the limits that do not hold."""
    try:
        figures = poinsot.diff(expected, actual, rule, jobs=1)
    except poinsot.UsageError:
        return None, ["size"]
    return figures["flip"]["mean"], figures["beyond"]


def version(packages):
    return "pixelmatch " + json.loads((packages / "node_modules/pixelmatch/package.json").read_text())["version"]


def by_pixelmatch(packages, files):
    """Returns the number of differing pixels of each pair of files, None for pictures of different size."""
    lines = "".join(f"{expected.resolve()}\t{actual.resolve()}\n" for expected, actual in files)
    script = Path(__file__).with_name("pixelmatch.mjs")
    done = subprocess.run(["node", script, packages], input=lines, text=True, check=True, stdout=subprocess.PIPE)
    return [None if word == "size" else int(word) for word in done.stdout.split()]


def judge(pair, expected, actual, rule):
    pair.rms = rms(expected, actual)
    pair.changed = pair.rms != 0
    pair.flip, pair.beyond = by_poinsot(expected, actual, rule)
    reports = {"RMS": pair.rms is None or pair.rms > TOLERANCE, **{name: count != 0 for name, count in pair.pixels.items()},
               "poinsot": bool(pair.beyond)}
    pair.reported = [rule for rule, report in reports.items() if report]
    return pair


def judged(suite, packages, rule):
    """Returns the pairs of a suite with the figures of each rule."""
    if suite.suffix == ".json":
        return [Pair(**figures) for figures in json.loads(suite.read_text())]
    files = [(expected, suite / "actual" / expected.name) for expected in sorted((suite / "expected").glob("*.png"))]
    counts = {version(folder): by_pixelmatch(folder, files) for folder in packages}
    return [judge(Pair(suite.name, pair[0].stem, pixels={name: found[i] for name, found in counts.items()}), *pair, rule)
            for i, pair in enumerate(files)]


def row(suite, pairs, rules):
    changed = [pair for pair in pairs if pair.changed]
    flips = [pair.flip for pair in changed if pair.flip is not None]
    cells = [suite, len(pairs), len(changed), *(sum(rule in pair.reported for pair in pairs) for rule in rules),
             f"{statistics.median(flips):.1e}" if flips else ""]
    return "| " + " | ".join(map(str, cells)) + " |"


def tables(suites, rules):
    """Returns the table of the suites, and how often each set of rules reports a changed picture."""
    head = ["suite", "pictures", "changed", *rules, "median FLIP mean of changed pictures"]
    lines = ["| " + " | ".join(head) + " |", "| --- " * len(head) + "|", *(row(*item, rules) for item in suites.items())]
    head = ["reported by", *suites, "all"]
    lines += ["", "| " + " | ".join(head) + " |", "| --- " * len(head) + "|"]
    counts = {suite: Counter(", ".join(pair.reported) for pair in pairs if pair.changed) for suite, pairs in suites.items()}
    total = sum(counts.values(), Counter())
    for reporters, number in total.most_common():
        cells = [reporters or "no rule", *(counts[suite][reporters] for suite in suites), number]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return "\n".join(lines)


def disagreement(pair):
    """Returns a line for a pair that some, but not all rules report."""
    figures = [f"reported by {', '.join(pair.reported)}"]
    if pair.rms is not None:
        pixels = [f"{name}: {count}" for name, count in pair.pixels.items()]
        figures += [f"RMS {pair.rms:.2f}", *pixels, f"FLIP mean {pair.flip:.1e}"]
    return f"{pair.suite}/{pair.name}: {'; '.join(figures + pair.beyond)}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pixelmatch", metavar="PACKAGES", type=Path, action="append", default=[],
                        help="folder of the npm packages")
    parser.add_argument("--rule", metavar="NAME", default="near", help="named limits of poinsot (default: near)")
    parser.add_argument("--json", metavar="FILE", type=Path, help="write the figures of each pair")
    parser.add_argument("--list", action="store_true", help="print the pairs on which the rules disagree")
    parser.add_argument("suite", type=Path, nargs="+")
    options = parser.parse_args()
    pairs = [pair for suite in options.suite for pair in judged(suite, options.pixelmatch, options.rule)]
    suites = {}
    for pair in pairs:
        suites.setdefault(pair.suite, []).append(pair)
    if options.json:
        options.json.write_text(json.dumps([asdict(pair) for pair in pairs], indent=1) + "\n")
    rules = ["RMS", *pairs[0].pixels, "poinsot"]
    print(tables(suites, rules))
    if options.list:
        print("", *(disagreement(pair) for pair in pairs if 0 < len(pair.reported) < len(rules)), sep="\n")


if __name__ == "__main__":
    main()
