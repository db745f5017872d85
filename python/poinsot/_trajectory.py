# SPDX-License-Identifier: Apache-2.0
"""The motion as arrays."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Trajectory:
    """The motion at some times, each array with the shape of `t` in front of the shape of one value.

    B: the body's axes, as the scene describes the body. W: inertial axes, z up.
    """

    t: Array  #: motion time, s
    q_WB: Array  #: (..., 4) unit quaternion w, x, y, z with w >= 0; takes components in B to those in W
    R_WB: Array  #: (..., 3, 3) the same rotation as a matrix
    omega_B: Array  #: (..., 3) angular velocity I^-1 L in B, rad/s
    omega_W: Array  #: (..., 3) the same vector in W
    L_W: Array  #: (..., 3) angular momentum, kg m^2/s
    T: Array  #: (...) energy of rotation, J
    rate_B: Array  #: (..., 3) rate at which the attitude turns in B, rad/s; omega_B unless motion.dissipation acts
    rate_W: Array  #: (..., 3) the same vector in W

    @property
    def L_B(self) -> Array:
        """(..., 3) angular momentum along the body's axes, kg m^2/s."""
        return np.asarray(np.einsum("...ji,...j->...i", self.R_WB, self.L_W))

    def __len__(self) -> int:
        return len(self.t)
