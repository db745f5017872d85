# SPDX-License-Identifier: Apache-2.0
"""The stability map of a body as numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _core

_MOST_CELLS = 4_000_000
_ROUNDING = 1e-15  # largest rounding of a cosine whose angle is pi/2 or pi


def sweep_map(core: _core.Scene, shape: tuple[int, int]) -> dict[str, Any]:
    """Returns the dictionary of Scene.sweep_map()."""
    rows, columns = _checked(shape)
    theta, phi = np.linspace(0, np.pi, rows, dtype=np.float64), np.linspace(0, 2 * np.pi, columns, dtype=np.float64)
    direction_P = _directions(theta[:, np.newaxis], phi[np.newaxis, :])
    by_row = [_core.stability(core, row) for row in direction_P]  # Ctrl-C takes effect between two rows
    numbers = by_row[0]
    x, y, z = numbers.L_P / np.linalg.norm(numbers.L_P)
    return {
        "theta": theta,
        "phi": phi,
        "flip_interval": np.stack([row.flip_interval for row in by_row]),
        "direction_P": direction_P,
        "direction_B": direction_P @ numbers.R_BP.T,
        "moments": numbers.moments,
        "R_BP": numbers.R_BP,
        "L": float(np.linalg.norm(numbers.L_P)),
        "scene": {
            "theta": float(np.arccos(np.clip(z, -1, 1))),
            "phi": float(np.arctan2(y, x) % (2 * np.pi)),
            "flip_interval": numbers.scene_interval,
        },
        "separatrix_P": numbers.separatrix_P,
        "scale": {"least": numbers.least, "most": numbers.most, "logarithmic": numbers.logarithmic},
        "labels": {
            "theta": r"$\theta$ of $\mathbf{L}$ from $\mathbf{e}_3$ (rad)",
            "phi": r"$\varphi$ of $\mathbf{L}$ from $\mathbf{e}_1$ to $\mathbf{e}_2$ (rad)",
            "flip_interval": "time from flip to flip (s)",
        },
    }


def _checked(shape: Any) -> tuple[int, int]:
    found = _arguments.pair(shape) or _arguments.refuse("shape", shape, "must be two integers, for theta and phi")
    if min(found) < 2 or found[0] * found[1] > _MOST_CELLS:
        _arguments.refuse("shape", shape, f"must be at least 2 each, and at most {_MOST_CELLS} cells")
    return found


def _directions(theta: NDArray[np.float64], phi: NDArray[np.float64]) -> NDArray[np.float64]:
    """Returns unit vectors. Components that are 0 to rounding become exactly 0, where a flip takes forever."""
    parts = np.broadcast_arrays(np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta))
    direction: NDArray[np.float64] = np.stack(parts, axis=-1)
    direction[np.abs(direction) < _ROUNDING] = 0
    return direction
