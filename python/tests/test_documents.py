# SPDX-License-Identifier: Apache-2.0
"""Tests the pages on Python and the examples: they run, and their numbers are right."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import PAGES, ROOT, snippets

import poinsot

EXAMPLES = sorted((ROOT / "python/examples").glob("*.py"))
SMALL = {"output.size": [160, 90], "time.fps": 2}  # so that pictures and films take little time


def need(file, packages):
    """Skips a test of a file that uses a package which is not installed."""
    for package, use in packages.items():
        if use in file.read_text():
            pytest.importorskip(package, reason=f"python3-{package} is not installed")


@pytest.fixture
def small(monkeypatch, tmp_path):
    """Makes all scenes small, and runs in a temporary folder, from which scenes of the gallery are found."""
    load, loads = poinsot.load, poinsot.loads
    monkeypatch.setattr(poinsot, "load", lambda path: load(ROOT / "scenes" / Path(path).name, SMALL))
    monkeypatch.setattr(poinsot, "loads", lambda tables: loads(tables, SMALL))
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_snippets_run_in_the_order_of_their_page(page, small):
    need(page, {"pandas": "to_frame()", "scipy": "motion.rotation"})
    names = {}
    for line, code in snippets(page):
        exec(compile("\n" * (line - 1) + code, str(page), "exec"), names)


def test_the_page_states_the_error_of_its_integration(small):
    (code,) = (code for _, code in snippets(ROOT / "docs/python.md") if "spin.grade" in code)
    names = {"poinsot": poinsot}
    exec(code, names)
    exact = names["spin"].trajectory(names["h"] * np.arange(5001)).omega_B
    off = np.linalg.norm(names["omega"] - exact, axis=1).max() / np.linalg.norm(exact, axis=1).max()
    quantities = names["grade"]["quantities"]
    assert quantities["omega_B"]["largest"] == pytest.approx(off, rel=1e-12)
    assert f"# {off:.4f}, relative" in code
    assert quantities["T"]["trend"] == "gains"


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda file: file.stem)
def test_examples_run(example, tmp_path):
    need(example, {"matplotlib": "import matplotlib", "scipy": "from scipy"})
    done = subprocess.run([sys.executable, "-B", example], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert done.stdout or list(tmp_path.iterdir())
