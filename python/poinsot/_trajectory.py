# SPDX-License-Identifier: Apache-2.0
"""Arrays of a motion."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _columns, _packages

if TYPE_CHECKING:
    from pandas import DataFrame  # type: ignore[import]
    from scipy.spatial.transform import Rotation  # type: ignore[import]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class Trajectory:
    """Motion at some times, as arrays. Each array has the shape of `t`, followed by the shape of one value.

    B are the body's axes, as the scene describes the body. W are inertial axes, with z up.

    t: motion time, s.
    q_WB: (..., 4) unit quaternion w, x, y, z, its scalar first, with w >= 0; takes components in B to components in W.
    q_WB_xyzw: (..., 4) the same with its scalar last.
    R_WB: (..., 3, 3) the same rotation as a matrix.
    omega_B, omega_W: (..., 3) angular velocity I^-1 L, in B and in W, rad/s.
    L_B, L_W: (..., 3) angular momentum, in B and in W, kg m^2/s.
    T: (...) energy of rotation, J.
    rate_B, rate_W: (..., 3) rate at which the attitude turns, rad/s: omega, unless motion.dissipation acts.
    quantities: the named quantities, (...) each: {"theta": array, ...}; empty unless trajectory() was given names.
    columns: names of the columns of to_frame().

    motion[key] selects times as t[key] does: motion[-1], motion[::10], motion[motion.t > 1]. The arrays are copies.
    """

    t: Array  #: motion time, s
    q_WB: Array  #: (..., 4) unit quaternion w, x, y, z with w >= 0; takes components in B to components in W
    R_WB: Array  #: (..., 3, 3) the same rotation as a matrix
    omega_B: Array  #: (..., 3) angular velocity I^-1 L in B, rad/s
    omega_W: Array  #: (..., 3) the same vector in W
    L_W: Array  #: (..., 3) angular momentum, kg m^2/s
    T: Array  #: (...) energy of rotation, J
    rate_B: Array  #: (..., 3) rate at which the attitude turns in B, rad/s; omega_B unless motion.dissipation acts
    rate_W: Array  #: (..., 3) the same vector in W
    quantities: dict[str, Array]  #: (...) each: arrays of the quantities that trajectory() was asked for, by name
    _state_columns: tuple[str, ...]  # columns of the program's CSV without a choice of quantities

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the columns of to_frame(), as in the program's CSV."""
        return ("t", *self.quantities) if self.quantities else self._state_columns

    @property
    def L_B(self) -> Array:
        """Angular momentum along the body's axes, (..., 3), kg m^2/s."""
        return np.asarray(np.einsum("...ji,...j->...i", self.R_WB, self.L_W))

    @property
    def q_WB_xyzw(self) -> Array:
        """The quaternion q_WB with its scalar last, (..., 4): x, y, z, w, the order of SciPy, ROS and glTF."""
        return self.q_WB[..., [1, 2, 3, 0]]

    @property
    def rotation(self) -> Rotation:
        """The attitude as a scipy.spatial.transform.Rotation, from B to W: rotation.apply(omega_B) is omega_W.

        The object holds one rotation for a single time, else one for each time, flattened in C order. Raises
        MissingPackageError without SciPy.
        """
        transform = _packages.imported("scipy.spatial.transform", "Trajectory.rotation")
        return transform.Rotation.from_quat(self.q_WB_xyzw if self.t.ndim == 0 else self.q_WB_xyzw.reshape(-1, 4))

    def to_frame(self) -> DataFrame:
        """Returns a DataFrame with the columns of `poinsot trajectory`: t, q_w, q_x, q_y, q_z, omega_B_x, ..., T.

        If trajectory() was given names of quantities, the columns are t and these quantities, in their order. The pandas.DataFrame has a row for each time, in the order of t flattened in C order. Units are those of the
        arrays. rate_B and rate_W are columns only if motion.dissipation makes them differ from omega. Raises
        MissingPackageError without pandas.
        """
        pandas = _packages.imported("pandas", "Trajectory.to_frame()")
        named = {"t": self.t.ravel(), **{name: array.ravel() for name, array in self.quantities.items()}}
        return pandas.DataFrame(named if self.quantities else dict(self._states()))

    def _states(self) -> Iterator[tuple[str, Array]]:
        for name in ("t", "q_WB", "omega_B", "omega_W", "L_W", "T", "rate_B", "rate_W"):
            for column, values in _columns.split(name, getattr(self, name)):
                if column in self._state_columns:
                    yield column, values

    def __getitem__(self, key: Any) -> Trajectory:
        rows = np.arange(self.t.size).reshape(self.t.shape)[key]

        def pick(array: Array) -> Array:
            return np.array(array.reshape(self.t.size, *array.shape[self.t.ndim :])[rows])

        names = [one.name for one in fields(self) if one.name not in ("quantities", "_state_columns")]
        return Trajectory(
            **{name: pick(getattr(self, name)) for name in names},
            quantities={name: pick(array) for name, array in self.quantities.items()},
            _state_columns=self._state_columns,
        )

    def __repr__(self) -> str:
        if self.t.size == 0:
            return "<poinsot trajectory: 0 times>"
        count = f"{self.t.size} time{'s' if self.t.size > 1 else ''}"
        return f"<poinsot trajectory: {count}, from {self.t.min():g} s to {self.t.max():g} s>"

    def __iter__(self) -> Iterator[Trajectory]:
        return (self[i] for i in range(len(self)))

    def __len__(self) -> int:
        return len(self.t)
