# SPDX-License-Identifier: Apache-2.0
import os
import re
import subprocess
from pathlib import Path

import pytest

import poinsot

ROOT = Path(__file__).parents[2]
SCENES = ROOT / "scenes"
PAGES = [ROOT / "docs/python.md", ROOT / "python/README.md"]


def snippets(page):
    """Returns the Python snippets of a page, each with the number of its first line."""
    text = page.read_text()
    found = [(text.count("\n", 0, one.start(1)) + 1, one[1]) for one in re.finditer(r"```python\n(.*?)```", text, re.S)]
    assert text.count("```python") == len(found) > 0
    return found


@pytest.fixture
def racket():
    """Returns the scene of the README with small pictures."""
    return poinsot.load(SCENES / "tennis_racket.toml", {"output.size": [160, 90]})


@pytest.fixture
def program():
    """Returns a function that runs the program, the oracle for the package, and returns its output."""

    def run(*words):
        command = [os.environ["POINSOT_TESTED_PROGRAM"], *map(str, words)]
        return subprocess.run(command, check=True, capture_output=True).stdout

    return run
