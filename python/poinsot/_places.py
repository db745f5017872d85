# SPDX-License-Identifier: Apache-2.0
"""Places of mistakes in a scene that is given as a dictionary, which has no lines."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterable
from typing import Any

from ._errors import Problem, SceneError

Places = tuple[tuple[str, ...], ...]  # keys of each line, as _toml.places() returns them

# Path of a key with which a message begins, such as "body.part[0].mass".
_PATH = re.compile(r"([\w-]+(?:\[\d+\])?(?:\.[\w-]+(?:\[\d+\])?)*): ")
# Lines to paste at the end of a message, with the table to which they belong.
_EXAMPLE = re.compile(
    r"For example(?:, in \[(?P<table>.+)\]|, at the (?P<place>end|top) of the file)?:(?P<lines>(?:\n    .*)+)$"
)
_MORE = re.compile(r"\nand \d+ more$")


def in_dictionary(error: SceneError, file: str, places: Places) -> SceneError:
    """Returns an error with places in the dictionary, instead of lines of a text that the user did not write.

    file: name of the scene, as the problems of the error contain it.
    """
    problems = [placed(problem, file, places) for problem in error.problems]
    more = _MORE.search(str(error))
    lines = [_text(problem, str(error)) for problem in problems]
    return type(error)("\n".join(lines) + (more[0] if more else ""), problems)


def placed(problem: Problem, file: str, places: Places) -> Problem:
    """Returns a problem with its place in the dictionary. Problems of overrides and of other files do not change."""
    if problem.file != file or not 0 < problem.line <= len(places):
        return problem
    keys = places[problem.line - 1]
    message = _EXAMPLE.sub(lambda found: _assignments(found, keys[:-1]), problem.message)
    return Problem("", 0, 0, message, place=_place(problem, keys))


def _text(problem: Problem, original: str) -> str:
    """Returns the text of a problem. Without a place in the dictionary, its place is that in the original text."""
    end = original.find(f": error: {problem.message}")
    where = problem.place or original[original.rfind("\n", 0, end) + 1 : end]
    return f"{where}: error: {problem.message}"


def _place(problem: Problem, keys: tuple[str, ...]) -> str:
    """Returns the place of a problem. The path in its message may name an element of the value with these keys."""
    whole = _subscripts(keys)
    path = _PATH.match(problem.message)
    exact = _subscripts(_parts(path[1])) if path else ""
    if exact.startswith(whole):
        return exact
    return "scene" if (problem.line, problem.column) == (1, 1) else whole


def _parts(path: str) -> list[str | int]:
    """Returns the parts of a path: ["body", "part", 0, "mass"] for "body.part[0].mass"."""
    return [int(part) if part.isdecimal() else part for part in re.findall(r"[\w-]+", path)]


def _subscripts(keys: Iterable[str | int]) -> str:
    return "scene" + "".join(f"[{json.dumps(key, ensure_ascii=False)}]" for key in keys)


def _assignments(found: re.Match[str], keys: tuple[str, ...]) -> str:
    """Returns lines of TOML as assignments to the dictionary. `keys` lead to the table of the mistake."""
    tables: dict[str, Any] = tomllib.loads(found["lines"].replace("\n    ", "\n"))
    base = found["table"].split(".") if found["table"] else [] if found["place"] else list(keys)
    while found["place"] == "end" and len(tables) == 1 and all(_holds_one_table(of) for of in tables.values()):
        [(name, tables)] = tables.items()
        base.append(name)
    lines = (f"\n    {_subscripts([*base, name])} = {_literal(of)}" for name, of in tables.items())
    return "For example:" + "".join(lines)


def _literal(it: Any) -> str:
    """Returns a value as Python, with the double quotes of the rest of a message."""
    if isinstance(it, dict):
        return "{" + ", ".join(f"{_literal(name)}: {_literal(of)}" for name, of in it.items()) + "}"
    if isinstance(it, list):
        return "[" + ", ".join(map(_literal, it)) + "]"
    return json.dumps(it, ensure_ascii=False) if isinstance(it, str) else repr(it)


def _holds_one_table(it: object) -> bool:
    return isinstance(it, dict) and len(it) == 1 and all(isinstance(of, dict) for of in it.values())
