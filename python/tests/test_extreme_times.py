# SPDX-License-Identifier: Apache-2.0
"""Tests extreme times in every kind of motion: each gives a state, or an error that names the time; none aborts."""

import json
import re
import subprocess
import sys

import pytest

NO_NUMBERS = [float("inf"), float("nan")]
TINY = [0.0, 5e-324, 1e-310, 2.2250738585072014e-308, 1e-300]
HUGE = [1e290, 1e291, 1e295, 1e299, 1e300, 1e301, 1e303, 1e305, 1e307, 1e308, 1.5e308, 1.7e308, 1.7976931348623157e308]
TIMES = [sign * t for t in (*TINY, *HUGE, *NO_NUMBERS) for sign in (1, -1)]

TURNING, START = [1, 2, 2.5], [0.05, 2, 0.1]
FREE = {
    "sphere": ([2, 2, 2], [1, 2, 3], {}),
    "symmetric": ([1, 1, 2], [0.1, 0, 3], {}),
    "asymmetric": (TURNING, START, {}),
    "separatrix": ([1, 2, 3], [1, 0, 1], {}),
    "steady": (TURNING, [0, 0, 2], {}),
}
DRIVEN = {
    "dissipation": (TURNING, START, {"dissipation": {"alpha": 0.01}}),
    "torque of the body": (TURNING, START, {"torque": {"body": [0.1, 0.2, 0.3]}}),
    "torque of space": (TURNING, START, {"torque": {"space": [0.1, 0.2, 0.3]}}),
    "drag": (TURNING, START, {"drag": {"rate": 0.1}}),
    "unequal drag": (TURNING, START, {"drag": {"rate": [0.1, 0.2, 0.3]}}),
    "heavy top": ([2, 2, 1], [0.1, 0, 20], {"gravity": {"mgr_body": [0, 0, 3]}}),
    "hanging": (TURNING, [0, 0, 1e-40], {"gravity": {"mgr_body": [0, 0, -1]}, "orientation": [1, 0, 0, 0]}),
}

# Prints the outcome of each kind of motion at each time, given alone or in an array.
PROGRAM = """
import json, sys, warnings
import numpy as np
import poinsot

warnings.simplefilter("ignore")
for kind, (moments, omega, more) in json.loads(sys.argv[1]).items():
    tables = {"body": {"principal_moments": moments}, "motion": {"omega_body": omega, **more}}
    scene = poinsot.loads(tables, limits={"steps": 500})
    start = scene.trajectory(0).R_WB
    for i, t in enumerate(json.loads(sys.argv[2])):
        index, asked = ("", t) if i % 4 < 2 else ("[1, 2]", [[0, 0, 0], [0, 0, t]])
        try:
            motion = scene.trajectory(asked)
            arrays = [it for it in (*vars(motion).values(), motion.L_B) if isinstance(it, np.ndarray)]
            said = "finite" if all(np.isfinite(array).all() for array in arrays) else "NaN"
            detail = float(np.abs(motion.R_WB - start).max())
        except poinsot.Error as error:
            said, detail = type(error).__name__, str(error)
        print(json.dumps([kind, t, index, said, detail]))
"""


def outcomes(kinds):
    words = [sys.executable, "-c", PROGRAM, json.dumps(kinds), json.dumps(TIMES)]
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr  # a negative code means a signal
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(rows) == len(kinds) * len(TIMES)
    return rows


def named(text, index):
    """Returns the time at the beginning of a message."""
    begin = rf"times{re.escape(index)}: t|times{re.escape(index)}" if index else "t|times"
    return re.match(rf"(?:{begin}) = (\S+?)(?: s)?: ", text)[1]


@pytest.mark.parametrize("kinds", [FREE, DRIVEN], ids=["free", "driven"])
def test_a_time_has_a_finite_state_or_an_error_that_names_it(kinds):
    assert len(TIMES) == 40
    for kind, t, index, said, detail in outcomes(kinds):
        where = f"{kind}, {t}: {said}: {detail}"
        if t != t or abs(t) == float("inf"):
            assert said == "UsageError", where
        elif abs(t) <= max(TINY):
            assert said == "finite" and detail < 1e-12, where  # measured 0: at 1e-300 s nothing has moved
            continue
        elif kinds is FREE and abs(t) > 1e290:  # largest phase of a motion, in rad (physics/motion.h)
            assert said == "LimitError", where
        else:
            assert said in ("finite", "LimitError", "PhysicsError"), where
        if said != "finite":
            assert named(detail, index) == repr(t), where
