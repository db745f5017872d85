# SPDX-License-Identifier: Apache-2.0
"""Tests that the notebooks run from top to bottom. Their own assertions compare the motion with the lecture."""

from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_runs_and_shows_its_pictures(notebook, tmp_path):
    read = nbformat.read(notebook, as_version=4)
    assert all(not cell.get("outputs") for cell in read.cells), "is kept without its outputs"
    done = NotebookClient(read, timeout=300, resources={"metadata": {"path": str(tmp_path)}}).execute()
    shown = [output.data for cell in done.cells for output in cell.get("outputs", []) if "data" in output]
    pictures = [data for data in shown if "image/png" in data]
    films = [data for data in shown if "<video" in data.get("text/html", "")]
    assert (len(pictures), len(films)) == (5, 1)
    nbformat.write(done, tmp_path / "done.ipynb")
