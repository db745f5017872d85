# SPDX-License-Identifier: Apache-2.0
"""Columns of a trajectory with one number per row, and the arrays of vectors whose components they are."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _times
from ._arguments import is_masked
from ._errors import UsageError

#: Names of arrays of vectors, and the columns of their components in the program's CSV.
PARTS: Mapping[str, Sequence[str]] = {
    "q_WB": [f"q_{part}" for part in "wxyz"],
    "q_WB_xyzw": [f"q_{part}" for part in "xyzw"],
    **{name: [f"{name}_{part}" for part in "xyz"] for name in ("omega_B", "omega_W", "L_W", "rate_B", "rate_W")},
}


def split(name: str, values: Any) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Splits an array into columns, flattened in C order: one per component of a vector, else one."""
    array = _times.times(name, values) if name == "t" else doubles(name, values)
    parts = PARTS.get(name)
    if parts is None:
        yield name, array.ravel()
        return
    if array.ndim == 0 or array.shape[-1] != len(parts):
        raise UsageError(f"{name}: shape {array.shape}; its last axis must have {len(parts)} components")
    for i, part in enumerate(parts):
        yield part, np.ascontiguousarray(array[..., i]).ravel()


def doubles(name: str, values: Any) -> NDArray[np.float64]:
    """Returns an array of real numbers. Raises UsageError for anything else."""
    if is_masked(values):
        masked = f"numpy.ma.getmaskarray({name})" + (".any(axis=-1)" if values.ndim > 1 else "")
        raise UsageError(f"{name}: has masked values; fill them, or leave out their rows in all columns: keep = ~{masked}")
    array = np.asarray(values)
    if array.dtype.kind not in "iufO":
        raise UsageError(f"{name}: expected real numbers, got values of type {array.dtype}")
    try:
        return np.asarray(array, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise UsageError(f"{name}: has values that are not real numbers") from error
