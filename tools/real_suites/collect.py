#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Collects pairs of pictures for compare.py. A suite is a folder: expected/NAME.png and actual/NAME.png.

  collect.py pytest RESULTS SUITE        results of Matplotlib's image_comparison (result_images) or of pytest-mpl
                                         (pytest --mpl --mpl-results-always --mpl-results-path=RESULTS)
  collect.py git REPOSITORY COMMIT SUITE the PNG files that a commit changed: expected is the version of its parent
  collect.py folders A B SUITE           the PNG files that two folders have in common: A is expected, B is actual

Files that Matplotlib's tests write beside a picture, and pictures that they compare with each other, are left out.
"""

import argparse
import re
import shutil
import subprocess
from pathlib import Path


def flat(path):
    """Returns the name of a picture in a suite, for its path in the results."""
    return "__".join(path.with_suffix("").parts) + ".png"


def is_picture(path):
    """Returns false for maps, copies and conversions, and for pictures of check_figures_equal(), which have a bracket."""
    return not re.search(r"-expected|-failed-diff|_(pdf|svg|eps|gif)$|\[", path.stem)


def pytest_pairs(results):
    """Yields (name, expected, actual) for each pair of files in a folder of results."""
    for expected in sorted(results.rglob("*-expected.png")):        # Matplotlib's layout: NAME-expected.png and NAME.png
        actual = expected.with_name(expected.name.replace("-expected.png", ".png"))
        if actual.exists() and is_picture(actual):
            yield flat(actual.relative_to(results)), expected, actual
    for expected in sorted(results.rglob("baseline.png")):          # pytest-mpl's: TEST/baseline.png and TEST/result.png
        actual = expected.with_name("result.png")
        if actual.exists():
            yield f"{expected.parent.name}.png", expected, actual


def folder_pairs(first, second):
    """Yields (name, expected, actual) for the pictures that both folders have."""
    for expected in sorted(first.rglob("*.png")):
        path = expected.relative_to(first)
        if is_picture(path) and (second / path).exists():
            yield flat(path), expected, second / path


def git(repository, *arguments):
    return subprocess.run(["git", "-C", repository, *arguments], check=True, capture_output=True).stdout


def changed_files(repository, commit):
    """Yields (name, digest before, digest after) for each PNG file that the commit modified."""
    changes = git(repository, "diff", "--raw", "-z", "--no-abbrev", "--no-renames", "--diff-filter=M", f"{commit}^", commit,
                  "--", "*.png")
    fields = changes.decode().split("\0")[:-1]
    for change, path in zip(fields[::2], fields[1::2]):
        before, after = change.split()[2:4]
        yield flat(Path(*Path(path).parts[-2:])), before, after


def write_pair(suite, name, expected, actual):
    for folder, data in (("expected", expected), ("actual", actual)):
        path = suite / folder / name
        if path.exists():
            raise SystemExit(f"{path}: two pictures have this name")
        path.write_bytes(data)


def command_line():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    kinds = parser.add_subparsers(dest="kind", required=True)
    for kind, names in (("pytest", ["results"]), ("git", ["repository", "commit"]), ("folders", ["first", "second"])):
        sub = kinds.add_parser(kind)
        for name in [*names, "suite"]:
            sub.add_argument(name, type=str if name == "commit" else Path)
    return parser.parse_args()


def main():
    options = command_line()
    for folder in ("expected", "actual"):
        shutil.rmtree(options.suite / folder, ignore_errors=True)
        (options.suite / folder).mkdir(parents=True)
    if options.kind == "git":
        pairs = ((name, *(git(options.repository, "cat-file", "blob", digest) for digest in digests))
                 for name, *digests in changed_files(options.repository, options.commit))
    else:
        found = pytest_pairs(options.results) if options.kind == "pytest" else folder_pairs(options.first, options.second)
        pairs = ((name, expected.read_bytes(), actual.read_bytes()) for name, expected, actual in found)
    count = 0
    for pair in pairs:
        write_pair(options.suite, *pair)
        count += 1
    print(f"{options.suite}: {count} pairs")


if __name__ == "__main__":
    main()
