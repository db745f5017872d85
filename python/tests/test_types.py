# SPDX-License-Identifier: Apache-2.0
"""Tests types and docstrings: mypy accepts the package and its users, and the stubs match the extension module."""

import ast
import os
import re
import subprocess
from pathlib import Path

import pytest
from conftest import PAGES, snippets

import poinsot
from poinsot import _core

PACKAGE = Path(poinsot.__file__).parent


def mypy(*words, cwd):
    pytest.importorskip("mypy", reason="mypy is not installed")
    environment = {**os.environ, "MYPY_CACHE_DIR": str(Path(os.environ["POINSOT_CACHE"]) / "mypy")}
    command = ["/usr/bin/python3", "-m", "mypy", "--strict", *words]
    return subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True)


def test_mypy_checks_the_package_a_user_and_the_snippets(tmp_path):
    (tmp_path / "user.py").write_text(
        "import datetime, poinsot\n"
        "import numpy as np\n"
        "scene = poinsot.load('a.toml', {'style.theme': 'dark'})\n"
        "count: int = scene.frame_count\n"
        "scene.film('a.mp4', progress=lambda done, total: print(done / total))\n"
        "x = scene.trajectory([1, 2], span=(0, 9)).omega_B + 1.0\n"
        "scene.film('a.mp4', frames=range(0, 9))\n"
        "scene.render(datetime.timedelta(seconds=1))\n"
        "scene.motion_time(np.array([1, 2], 'm8[s]'))\n"
        "print(poinsot.__version__, scene.overrides['style.theme'])\n"
        "scene.render(size=3)\n"
        "from numpy import uint8, uint16\n"
        "from numpy.typing import NDArray\n"
        "plain: NDArray[uint8] = scene.render(1.0, size=(32, 32))\n"
        "deep: NDArray[uint16] = scene.render(bits=16)\n"
        "wrong: NDArray[uint8] = scene.render(bits=16)\n"
        "print(poinsot.__version__, poinsot.diff(plain, plain)['rmse'], scene.trajectory(1)[...].rotation)\n"
    )
    for page in PAGES:
        code = "\n".join(code for _, code in snippets(page))
        (tmp_path / f"{page.stem}.py").write_text(code)
    said = mypy("user.py", *(f"{page.stem}.py" for page in PAGES), cwd=tmp_path)
    assert re.findall(r"([0-9]+): error", said.stdout) == ["11", "16"], said.stdout  # none in the snippets
    # The versions of mypy and NumPy decide which comments "type: ignore" are needed.
    within = mypy("--no-warn-unused-ignores", "-p", "poinsot", cwd=tmp_path)
    assert within.returncode == 0, within.stdout


def names(of):
    return {name for name in vars(of) if not name.startswith("_")}


def test_the_stubs_match_the_module():
    stub = ast.parse((PACKAGE / "_core.pyi").read_text())
    classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
    values = {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign)}
    functions = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
    assert classes.keys() | values | functions == names(_core)
    for name, node in classes.items():
        assert {part.name for part in node.body} == names(getattr(_core, name)), name


def test_everything_public_has_a_docstring():
    for name in set(poinsot.__all__) - {"__version__"}:
        thing = getattr(poinsot, name)
        assert thing.__doc__, name
        if isinstance(thing, type):
            for part, value in vars(thing).items():
                if not part.startswith("_") and (callable(value) or isinstance(value, property)):
                    assert value.__doc__, f"{name}.{part}"
