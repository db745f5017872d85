# SPDX-License-Identifier: Apache-2.0
import os
import subprocess
from pathlib import Path

import pytest

import poinsot

SCENES = Path(__file__).parents[2] / "scenes"


@pytest.fixture
def racket():
    """The scene of the README, drawn small."""
    return poinsot.load(SCENES / "tennis_racket.toml", {"output.size": [160, 90]})


@pytest.fixture
def program():
    """Runs the program, which is the oracle of what the package makes, and returns what it printed."""

    def run(*words):
        command = [os.environ["POINSOT_TESTED_PROGRAM"], *map(str, words)]
        return subprocess.run(command, check=True, capture_output=True).stdout

    return run
