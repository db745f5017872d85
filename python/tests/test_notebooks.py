# SPDX-License-Identifier: Apache-2.0
"""Tests that the notebooks run from top to bottom. Their own assertions compare the motion with the lecture."""

import json
import re
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))
PICTURES, FILMS = 19, 1  # of the lecture: 11 plots and 8 scenes, and the racket


def run(notebook, folder):
    return NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(folder)}}).execute()


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_runs_and_shows_its_pictures(notebook, tmp_path):
    done = run(nbformat.read(notebook, as_version=4), tmp_path)
    shown = [output.data for cell in done.cells for output in cell.get("outputs", []) if "data" in output]
    pictures = [data for data in shown if "image/png" in data]
    films = [data for data in shown if "<video" in data.get("text/html", "")]
    assert (len(pictures), len(films)) == (PICTURES, FILMS)
    nbformat.write(done, tmp_path / "done.ipynb")


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_is_kept_without_outputs(notebook):
    text = notebook.read_text(encoding="utf-8")
    cells = json.loads(text)["cells"]
    assert not any(cell.get("outputs") or cell.get("execution_count") for cell in cells)
    assert [cell["id"] for cell in cells] == [f"cell-{n:02}" for n in range(len(cells))]
    assert text == json.dumps(json.loads(text), indent=1, ensure_ascii=False) + "\n"


def test_stops_at_a_wrong_number(tmp_path):
    right, wrong = "* t[:, None] ** 2 / 2", "* t[:, None] ** 2 / 2.000000000001"
    notebook = nbformat.read(NOTEBOOKS[0], as_version=4)
    first = next(n for n, cell in enumerate(notebook.cells) if re.search("^assert", cell.source, re.M))
    notebook.cells = notebook.cells[: first + 1]
    assert right in notebook.cells[first].source
    notebook.cells[first].source = notebook.cells[first].source.replace(right, wrong)
    with pytest.raises(CellExecutionError, match="AssertionError"):
        run(notebook, tmp_path)
