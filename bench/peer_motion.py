# SPDX-License-Identifier: Apache-2.0
"""The motion of standard.toml as a user of SciPy would compute it, for vtk_peer.py and matplotlib_peer.py.

DOP853 integrates I omega' = -omega x (I omega) in body axes and q' = q (0, omega) / 2. L points down.
"""
import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

SPAN_S = 20.0
CURVE_POINTS = 1200
WIDTH, HEIGHT = 1920, 1080
PLANE_HALF = 3.6  # half the side of the plane's square
VECTOR_L_SCALE = 0.75

MOMENTS = np.array([1.0, 2.0, 3.0])
OMEGA0_B = np.array([0.1, 2.0, 0.1])  # rad/s
L = np.linalg.norm(MOMENTS * OMEGA0_B)
TWICE_ENERGY = MOMENTS @ OMEGA0_B**2
SEMI_AXES = np.sqrt(TWICE_ENERGY / MOMENTS)  # of the ellipsoid, in rad/s
PLANE_DISTANCE = TWICE_ENERGY / L


def _first_attitude():
    """Returns the smallest rotation that takes L in body axes to -z, as (x, y, z, w)."""
    u = MOMENTS * OMEGA0_B / L
    q = np.r_[np.cross(u, [0, 0, -1]), 1 - u[2]]
    return q / np.linalg.norm(q)


def _rate(_, y):
    omega, v, s = y[:3], y[3:6], y[6]
    return np.r_[-np.cross(omega, MOMENTS * omega) / MOMENTS, 0.5 * (s * omega + np.cross(v, omega)), -0.5 * v @ omega]


_solution = solve_ivp(_rate, (0, SPAN_S), np.r_[OMEGA0_B, _first_attitude()], 'DOP853', rtol=1e-10, atol=1e-12,
                      dense_output=True).sol


def states(times_s):
    """Returns omega_B, R_WB and omega_W at the given times."""
    y = _solution(np.atleast_1d(times_s))
    rotation = Rotation.from_quat(y[3:].T)
    return y[:3].T, rotation.as_matrix(), rotation.apply(y[:3].T)


polhode_B, _, herpolhode_W = states(np.linspace(0, SPAN_S, CURVE_POINTS))


def frame_times(frames):
    return [SPAN_S * k / frames for k in range(frames)]


def herpolhode_until(time_s):
    return herpolhode_W[:max(2, 1 + int(time_s / SPAN_S * (CURVE_POINTS - 1)))]
