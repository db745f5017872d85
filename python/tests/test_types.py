# SPDX-License-Identifier: Apache-2.0
"""The types: strict within, complete for users, and the stubs of the module name what it has."""

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


def test_the_package_its_users_and_the_snippets_of_its_pages_are_checked(tmp_path):
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
    assert re.findall(r"([0-9]+): error", said.stdout) == ["11", "16"], said.stdout  # and none of the pages' snippets
    # Which of the comments "type: ignore" are needed depends on the versions of mypy and NumPy.
    within = mypy("--no-warn-unused-ignores", "-p", "poinsot", cwd=tmp_path)
    assert within.returncode == 0, within.stdout


def names(of):
    return {name for name in vars(of) if not name.startswith("_")}


def test_the_stubs_name_what_the_module_has():
    stub = ast.parse((PACKAGE / "_core.pyi").read_text())
    classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
    values = {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign)}
    functions = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
    assert classes.keys() | values | functions == names(_core)
    for name, node in classes.items():
        assert {part.name for part in node.body} == names(getattr(_core, name)), name


def test_what_is_public_has_a_docstring():
    for name in set(poinsot.__all__) - {"__version__"}:
        thing = getattr(poinsot, name)
        assert thing.__doc__, name
        if isinstance(thing, type):
            for part, value in vars(thing).items():
                if not part.startswith("_") and (callable(value) or isinstance(value, property)):
                    assert value.__doc__, f"{name}.{part}"
