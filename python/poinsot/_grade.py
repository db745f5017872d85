# SPDX-License-Identifier: Apache-2.0
"""Grades of trajectories: how far another engine's result is off the motion of a scene."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from . import _arguments, _columns, _core
from ._errors import UsageError
from ._trajectory import Trajectory


_MOST_NAMED = 8  # columns in a message

# Arrays by which a motion can be graded, and their description in messages.
_GRADED = ("q_WB", "q_WB_xyzw", "omega_B", "omega_W")
_WANTED = (
    "q_WB, an array (n, 4), or omega_B, an array (n, 3), or the columns of their components q_w, q_x, q_y, q_z or "
    "omega_B_x, omega_B_y, omega_B_z"
)


def grade(core: _core.Scene, table: Any, max_attitude_error: float | str | None) -> dict[str, Any]:
    """Returns the dictionary of Scene.grade()."""
    limit = None if max_attitude_error is None else _limit(max_attitude_error)
    if isinstance(table, (str, bytes, os.PathLike)):
        result: dict[str, Any] = json.loads(_core.grade_file(core, os.fsencode(_arguments.path("table", table))))
    else:
        columns = _columns_of(table)
        result = json.loads(_core.grade_columns(core, [name for name, _ in columns], [values for _, values in columns]))
        result["file"] = None
    result["passes"] = None if limit is None else _passes(result, limit)
    return result


def _limit(word: float | str) -> float:
    if isinstance(word, str):
        return _core.attitude_limit("max_attitude_error", _arguments.text("max_attitude_error", word, "an angle"))
    return _core.attitude_limit("max_attitude_error", repr(_arguments.number("max_attitude_error", word)))


def _passes(result: dict[str, Any], limit: float) -> bool:
    attitude = result["quantities"]["attitude"]
    if attitude is None:
        raise UsageError("max_attitude_error: the table has no attitude; give q_WB, or q_w, q_x, q_y, q_z")
    largest = attitude["largest"]  # None if not finite
    return largest is not None and largest <= limit


def _pairs(table: Any) -> Iterator[tuple[str, Any]]:
    """Yields the name and the values of each column of a table."""
    if isinstance(table, Trajectory):
        yield from table._states()
    elif isinstance(table, Mapping):
        yield from _arguments.table("table", table, '{"t": t, "omega_B": omega}').items()
    elif isinstance(table, np.ndarray) and table.dtype.names:
        yield from ((name, table[name]) for name in table.dtype.names)
    elif hasattr(table, "iloc") and hasattr(table, "columns"):  # a DataFrame, without importing pandas
        if table.index.name == "t" and "t" not in table.columns:
            yield "t", table.index.to_numpy()
        yield from ((str(name), table.iloc[:, i].to_numpy()) for i, name in enumerate(table.columns))
    else:
        raise UsageError(
            f"table: got {type(table).__name__}; expected a path of a CSV file, a dictionary of arrays, a structured "
            "array, a DataFrame or a Trajectory"
        )


def _columns_of(table: Any) -> list[tuple[str, Any]]:
    """Returns the columns of a table. Raises UsageError, with the names of the arrays, if the table has no motion."""
    columns: list[tuple[str, Any]] = []
    rows: dict[str, int] = {}
    for name, values in _pairs(table):
        parts = list(_known(name, values))
        columns += parts
        if _is_known(name):
            rows[name] = len(parts[0][1])
    if "t" in rows:  # a missing t is reported later
        _require_motion([name for name, _ in columns])
        for name, count in rows.items():
            if count != rows["t"]:
                raise UsageError(f"table: {name} has {count} rows, t has {rows['t']}")
    return columns


def _require_motion(names: list[str]) -> None:
    if not {part for array in _GRADED for part in _columns.PARTS[array]} & set(names):
        others = [_arguments.shown(name) for name in names if name not in _core.all_trajectory_columns]
        found = f"; got {', '.join(others[:_MOST_NAMED])}" if others else ""
        raise UsageError(f"table: no motion to grade; give {_WANTED}{found}")


def _is_known(name: str) -> bool:
    return name in _columns.PARTS or name in _core.all_trajectory_columns


def _known(name: str, values: Any) -> Iterator[tuple[str, Any]]:
    """Yields the columns to grade. A column of another name is empty, because only messages use it."""
    if _is_known(name):
        yield from _columns.split(name, values)
    else:
        yield name, np.empty(0)
