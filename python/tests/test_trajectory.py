# SPDX-License-Identifier: Apache-2.0
"""Tests the motion as arrays against integrations and closed forms computed here, and against the program's table."""

import re

import numpy as np
import pytest

import poinsot

MOMENTS = np.array([1.0, 2.0, 3.0])
START = np.array([0.3, 2.0, 0.1])


def free(**motion):
    return poinsot.loads({"body": {"principal_moments": list(MOMENTS)}, "motion": {"omega_body": list(START), **motion}})


def euler(omega):
    """Returns the rate of omega by Euler's equations, eq 24 to 26, without torque."""
    return np.cross(MOMENTS * omega, omega) / MOMENTS


def test_omega_solves_eulers_equations():
    step, steps = 1e-3, 5000
    omega, all_omega = START, [START]
    for _ in range(steps):  # Runge-Kutta of fourth order
        a = euler(omega)
        b = euler(omega + step / 2 * a)
        c = euler(omega + step / 2 * b)
        d = euler(omega + step * c)
        omega = omega + step / 6 * (a + 2 * b + 2 * c + d)
        all_omega.append(omega)
    motion = free().trajectory(np.arange(steps + 1) * step)
    assert np.abs(motion.omega_B - all_omega).max() < 1e-10  # measured 6e-12, the error of the integration


def test_the_attitude_follows_omega():
    t, h = np.linspace(0, 20, 50), 1e-5
    scene = free()
    before, now, after = (scene.trajectory(t + shift) for shift in (-h, 0, h))
    rate_W = (after.R_WB - before.R_WB) / (2 * h) @ np.swapaxes(now.R_WB, -1, -2)
    omega_W = np.stack([rate_W[:, 2, 1], rate_W[:, 0, 2], rate_W[:, 1, 0]], axis=-1)
    assert np.abs(omega_W - now.omega_W).max() < 1e-8  # measured 5e-10, the error of differences of second order


def test_the_attitude_of_a_dissipating_body_turns_at_rate_w():
    t, h = np.linspace(1, 19, 20), 1e-4
    scene = free(dissipation={"alpha": 0.005})
    before, now, after = (scene.trajectory(t + shift) for shift in (-h, 0, h))
    turning_W = (after.R_WB - before.R_WB) / (2 * h) @ np.swapaxes(now.R_WB, -1, -2)
    rate_W = np.stack([turning_W[:, 2, 1], turning_W[:, 0, 2], turning_W[:, 1, 0]], axis=-1)
    assert np.abs(rate_W - now.rate_W).max() < 1e-7  # error of differences of second order
    assert np.abs(rate_W - now.omega_W).max() > 1e-2
    L_B = MOMENTS * now.omega_B
    assert np.abs(now.rate_B - now.omega_B - 0.005 * np.cross(L_B, now.omega_B)).max() < 1e-14
    plain = free().trajectory(t)
    assert np.array_equal(plain.rate_B, plain.omega_B) and np.array_equal(plain.rate_W, plain.omega_W)


def test_conserved_quantities_and_orthogonality_are_kept():
    motion = free().trajectory(np.linspace(-1e6, 1e6, 1001))
    assert np.abs(motion.L_W - motion.L_W[0]).max() < 1e-13
    assert np.ptp(motion.T) < 1e-13
    assert np.abs(motion.L_B - MOMENTS * motion.omega_B).max() < 1e-13
    assert np.abs(motion.R_WB @ np.swapaxes(motion.R_WB, -1, -2) - np.eye(3)).max() < 1e-14
    w, x, y, z = motion.q_WB.T
    assert np.abs(1 - 2 * (y * y + z * z) - motion.R_WB[:, 0, 0]).max() < 1e-14
    assert np.abs(2 * (x * y - w * z) - motion.R_WB[:, 0, 1]).max() < 1e-14


def test_a_symmetric_top_precesses_at_L_over_I1():  # eq 20
    scene = poinsot.loads({"body": {"principal_moments": [2, 2, 3]}, "motion": {"omega_body": [0.5, 0, 4]}})
    motion = scene.trajectory([0.0, 1.7])
    L = np.linalg.norm([2 * 0.5, 0, 3 * 4])
    axis = motion.L_W[0] / L
    k = motion.R_WB[:, :, 2]
    angle = L / 2 * 1.7
    turned = k[0] * np.cos(angle) + np.cross(axis, k[0]) * np.sin(angle) + axis * (axis @ k[0]) * (1 - np.cos(angle))
    assert np.abs(turned - k[1]).max() < 1e-14


def test_rows_equal_the_programs_table(tmp_path, program, racket):
    times = [0.0, -3.5, 1e6]
    table = program("trajectory", "scenes/tennis_racket.toml", "--at=0,-3.5,1e6").decode().splitlines()
    rows = np.array([[float(word) for word in line.split(",")] for line in table[1:]])
    motion = racket.trajectory(times)
    own = np.column_stack([motion.t, motion.q_WB, motion.omega_B, motion.omega_W, motion.L_W, motion.T])
    assert np.array_equal(own, rows)  # to the last bit


def test_arrays_have_the_shape_of_the_times():
    scene = free()
    one, grid, none = scene.trajectory(2.0), scene.trajectory(np.zeros((4, 5))), scene.trajectory([])
    assert (one.T.shape, one.omega_B.shape, one.R_WB.shape) == ((), (3,), (3, 3))
    assert (grid.T.shape, grid.q_WB.shape, grid.R_WB.shape) == ((4, 5), (4, 5, 4), (4, 5, 3, 3))
    assert (none.T.shape, none.omega_B.shape, len(none)) == ((0,), (0, 3), 0)


def test_bad_times_are_refused_and_far_times_warned_about():
    with pytest.raises(poinsot.UsageError):
        free().trajectory([0, np.nan])
    for t, words in ((1e14, "no longer exact"), (1e18, "meaningless")):
        with pytest.warns(poinsot.FarTimeWarning, match=words):
            free().trajectory(t)
    for far in (1e291, -1e300, 1.7e308):
        with pytest.raises(poinsot.LimitError, match="too far from the start"):
            free().trajectory([0, far])
    for tiny in (5e-324, -1e-310):
        assert free().trajectory(tiny).q_WB == pytest.approx(free().trajectory(0.0).q_WB)
    with pytest.raises(poinsot.LimitError, match="steps"):
        poinsot.loads(
            {"body": {"principal_moments": [1, 2, 3]}, "motion": {"omega_body": [1, 2, 3], "drag": {"rate": [0.1, 0.2, 0.3]}}},
            limits={"steps": 100},
        ).trajectory(1e3)


def test_repr_shows_the_number_and_range_of_times():
    scene = free()
    assert repr(scene.trajectory([[0, 1.5], [3, -1]])) == "<poinsot trajectory: 4 times, from -1 s to 3 s>"
    assert repr(scene.trajectory(2)) == "<poinsot trajectory: 1 time, from 2 s to 2 s>"
    assert repr(scene.trajectory([])) == "<poinsot trajectory: 0 times>"


def test_each_array_of_a_trajectory_is_documented():
    documented = poinsot.Trajectory.__doc__
    fields = [name for name in vars(free().trajectory(0)) if not name.startswith("_")]
    arrays = [*fields, "columns", "L_B", "q_WB_xyzw"]
    assert len(arrays) == 13
    for name in arrays:
        assert re.search(rf"(?m)(^|[ ,]) *{name}(:|, )", documented), name


def test_quantities_match_the_formulas_of_a_free_symmetric_top():
    """theta is constant and phi grows by L/I1 a second (eq 19 to 37)."""
    scene = poinsot.loads({"body": {"principal_moments": [2, 2, 3]}, "motion": {"omega_body": [0.4, 0, 5]}})
    t = np.array([[0, 0.1, 0.2], [0.3, 0.4, 0.5]])
    motion = scene.trajectory(t, quantities=["theta", "phi", "E"])
    assert list(motion.quantities) == ["theta", "phi", "E"]
    assert motion.columns == ("t", "theta", "phi", "E")
    assert np.abs(motion.quantities["theta"] - np.arctan2(0.8, 15)).max() < 1e-14
    phi = np.unwrap(motion.quantities["phi"].ravel()).reshape(t.shape)
    assert np.abs(phi - phi[0, 0] - np.hypot(0.8, 15) / 2 * t).max() < 1e-13
    assert np.abs(motion.quantities["E"] - motion.T).max() == 0
    assert motion[1, 2].quantities["phi"] == motion.quantities["phi"][1, 2]
    plain = scene.trajectory(t)
    assert plain.quantities == {} and np.array_equal(plain.q_WB, motion.q_WB)
    assert scene.grade(motion)["quantities"]["attitude"]["largest"] < 1e-14
    assert scene.trajectory([], quantities=["theta"]).quantities["theta"].shape == (0,)


def test_quantities_of_a_flight_follow_the_parabola():
    scene = poinsot.loads(
        {
            "body": {"principal_moments": [1, 2, 2.5], "mass": 3},
            "motion": {"omega_body": [0.1, 3, 0.2], "flight": {"position": [1, 2, 3], "velocity": [4, -5, 6]}},
        }
    )
    t = np.linspace(-1, 2, 7)
    motion = scene.trajectory(t, quantities=["R_z", "V_z", "P_z", "T_total", "T"])
    speed_z = 6 - 9.80665 * t
    assert np.abs(motion.quantities["R_z"] - (3 + 6 * t - 9.80665 * t**2 / 2)).max() < 1e-13
    assert np.abs(motion.quantities["V_z"] - speed_z).max() < 1e-13
    assert np.abs(motion.quantities["P_z"] - 3 * speed_z).max() < 1e-13
    total = 1.5 * (4**2 + 5**2 + speed_z**2) + motion.T
    assert np.abs(motion.quantities["T_total"] - total).max() < 1e-11
    assert np.array_equal(motion.quantities["T"], motion.T)


def test_unknown_quantities_are_refused_with_a_suggestion():
    with pytest.raises(poinsot.UsageError, match="quantities: no quantity has the name 'tetha'; did you mean theta?"):
        free().trajectory(0, quantities=["tetha"])
    with pytest.raises(poinsot.UsageError, match="quantities: R_x exists only for a thrown body"):
        free().trajectory(0, quantities=["R_x"])
    for bad in ("theta", [1], None):
        with pytest.raises(poinsot.UsageError, match="quantities"):
            free().trajectory(0, quantities=bad)


def test_events_are_the_flips_of_the_film():
    """omega_2 of a free body is 0 at each flip; a film at the speed -2 from t = 1 has the film time (1 - t)/2."""
    scene = poinsot.loads(
        {
            "body": {"principal_moments": [1, 2, 2.5]},
            "motion": {"omega_body": [0.05, 3, 0.05]},
            "time": {"start": 1, "speed": -2, "duration": 40},
        }
    )
    events = scene.events()
    times = np.array([event["t"] for event in events])
    assert len(times) > 3 and np.all(np.diff(times) < 0)
    assert {event["event"] for event in events} == {"flip"}
    assert np.abs(scene.trajectory(times).omega_B[:, 1]).max() < 1e-12
    film = np.array([event["film_from"] for event in events])
    assert np.abs(film - (1 - times) / 2).max() < 1e-12
    assert np.abs(np.diff(times) + scene.info()["flip_interval"]).max() < 1e-12
    assert all(event["film_to"] is None for event in scene.events(span=(2, 20)))
