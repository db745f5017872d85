# SPDX-License-Identifier: Apache-2.0
"""How far somebody's trajectory is off the motion of a scene."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from . import _arguments, _columns, _core
from ._errors import UsageError
from ._trajectory import Trajectory


def grade(core: _core.Scene, table: Any, max_attitude_error: float | str | None) -> dict[str, Any]:
    """Grades a table as Scene.grade() says."""
    limit = None if max_attitude_error is None else _limit(max_attitude_error)
    if isinstance(table, (str, bytes, os.PathLike)):
        result: dict[str, Any] = json.loads(_core.grade_file(core, os.fsencode(_arguments.path("table", table))))
    else:
        columns = [column for name, values in _pairs(table) for column in _known(name, values)]
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
        raise UsageError("max_attitude_error: the table has no attitude: q_WB, or q_w, q_x, q_y, q_z")
    largest = attitude["largest"]  # None: not finite
    return largest is not None and largest <= limit


def _pairs(table: Any) -> Iterator[tuple[str, Any]]:
    """Names and values of the columns of a table."""
    if isinstance(table, Trajectory):
        yield from table._flat()
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


def _known(name: str, values: Any) -> Iterator[tuple[str, Any]]:
    """Columns to grade. The values of other columns are left out, whatever they are: their names serve messages."""
    if name in _columns.PARTS or name in _core.all_trajectory_columns:
        yield from _columns.split(name, values)
    else:
        yield name, np.empty(0)
