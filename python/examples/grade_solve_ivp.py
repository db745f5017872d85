#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Grades SciPy's integrators on Euler's equations and the attitude, at two tolerances each.

Needs python3-scipy. Prints the largest errors of the attitude and of omega, and whether they drift.
"""

import numpy as np
from scipy.integrate import solve_ivp

import poinsot

MOMENTS = np.array([1.0, 2.0, 2.5])  # kg m^2
SCENE = {"body": {"principal_moments": MOMENTS}, "motion": {"omega_body": [0.05, 2.0, 0.1]}}


def rate(_, state):
    """Time derivative of the quaternion (w, x, y, z) and omega_B."""
    (w, x, y, z), omega = state[:4], state[4:]
    p, q, r = omega / 2
    return np.concatenate(
        [
            [-x * p - y * q - z * r, w * p + y * r - z * q, w * q + z * p - x * r, w * r + x * q - y * p],
            np.cross(MOMENTS * omega, omega) / MOMENTS,
        ]
    )


def main():
    scene = poinsot.loads(SCENE)
    start, t = scene.trajectory(0.0), np.linspace(0, 20, 201)
    for method in ("RK45", "DOP853"):
        for tolerance in (1e-6, 1e-10):
            first = np.concatenate([start.q_WB, start.omega_B])
            rows = solve_ivp(rate, (0, 20), first, method, t, rtol=tolerance, atol=tolerance).y.T
            grade = scene.grade({"t": t, "q_WB": rows[:, :4], "omega_B": rows[:, 4:]}, max_attitude_error="0.1 deg")
            attitude, omega = (grade["quantities"][name] for name in ("attitude", "omega_B"))
            print(
                f"{method:7} {tolerance:.0e}  attitude {attitude['largest']:.1e} rad, {attitude['drift']['kind']}"
                f"  omega {omega['largest']:.1e}  {'passes' if grade['passes'] else 'fails'}"
            )


if __name__ == "__main__":
    main()
