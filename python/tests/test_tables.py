# SPDX-License-Identifier: Apache-2.0
"""Tests trajectories as pandas and SciPy objects, and grades of trajectories of other programs.

Oracles: the program's CSV and JSON, NumPy's indexing, SciPy's rotations.
"""

import io
import json
import os
import subprocess
import sys

import numpy as np
import pytest

import poinsot

RACKET = "scenes/tennis_racket.toml"


@pytest.fixture
def pandas():
    return pytest.importorskip("pandas", reason="python3-pandas is not installed")


@pytest.fixture
def rotations():
    return pytest.importorskip("scipy.spatial.transform", reason="python3-scipy is not installed").Rotation


@pytest.mark.parametrize("overrides", [{}, {"motion.dissipation.alpha": 0.5}])
def test_a_data_frame_equals_the_programs_table(pandas, program, overrides):
    words = [word for key, value in overrides.items() for word in ("-D", f"{key}={value}")]
    table = program("trajectory", RACKET, "--at=2.25,0,7.5", *words)
    frame = poinsot.load(RACKET, overrides).trajectory([2.25, 0, 7.5]).to_frame()
    assert ("rate_B_x" in frame.columns) == bool(overrides)
    expected = pandas.read_csv(io.BytesIO(table), float_precision="round_trip")
    pandas.testing.assert_frame_equal(frame, expected, check_exact=True)


def test_a_data_frame_of_quantities_equals_the_programs_table(pandas, program):
    names = ["theta", "E", "omega_W_z", "phi"]
    table = program("trajectory", RACKET, "--at=2.25,0,7.5", "--quantities", ",".join(names))
    frame = poinsot.load(RACKET).trajectory([2.25, 0, 7.5], quantities=names).to_frame()
    assert list(frame.columns) == ["t", *names]
    expected = pandas.read_csv(io.BytesIO(table), float_precision="round_trip")
    pandas.testing.assert_frame_equal(frame, expected, check_exact=True)


def test_a_data_frame_has_a_row_for_each_time_of_any_shape(pandas, racket):
    times = np.linspace(0, 5, 6).reshape(2, 3)
    grid = racket.trajectory(times)
    pandas.testing.assert_frame_equal(grid.to_frame(), racket.trajectory(times.ravel()).to_frame(), check_exact=True)
    assert np.array_equal(grid.to_frame()[["L_W_x", "L_W_y", "L_W_z"]], grid.L_W.reshape(6, 3))
    assert (len(racket.trajectory(1.5).to_frame()), len(racket.trajectory([]).to_frame())) == (1, 0)


def test_a_rotation_takes_body_components_to_inertial_ones(rotations, racket):
    motion = racket.trajectory(np.linspace(0, 7, 50))
    # Measured 4.5e-16, and 1.8e-15 of 4.2 rad/s.
    assert np.abs(motion.rotation.as_matrix() - motion.R_WB).max() < 2e-15
    assert np.abs(motion.rotation.apply(motion.omega_B) - motion.omega_W).max() < 2e-14
    assert np.abs(rotations.from_quat(motion.q_WB_xyzw).as_matrix() - motion.R_WB).max() < 2e-15
    assert racket.trajectory(1.5).rotation.single
    grid = racket.trajectory([[0, 1], [2, 3]])
    assert np.abs(grid.rotation.as_matrix() - grid.R_WB.reshape(4, 3, 3)).max() < 2e-15


def test_the_quaternion_comes_in_both_orders(racket):
    motion = racket.trajectory([[0, 1], [2, 3]])
    assert np.array_equal(motion.q_WB_xyzw[..., 3], motion.q_WB[..., 0])
    assert np.array_equal(motion.q_WB_xyzw[..., :3], motion.q_WB[..., 1:])


@pytest.mark.parametrize(
    "key",
    [
        *(0, -1, slice(None, None, -2), slice(5, 2), [2, 0], (1, 2), (slice(None), 1), (Ellipsis, 0)),
        np.array([True, False, True]),
    ],
    ids=repr,
)
def test_rows_are_selected_as_numpy_selects_times(racket, key):
    motion = racket.trajectory(np.arange(12.0).reshape(3, 4))
    picked, places = motion[key], np.arange(12).reshape(3, 4)[key]
    assert np.array_equal(picked.t, motion.t.ravel()[places])
    assert np.array_equal(picked.T, motion.T.ravel()[places])
    assert np.array_equal(picked.R_WB, motion.R_WB.reshape(12, 3, 3)[places])
    assert np.array_equal(picked.L_B, motion.L_B.reshape(12, 3)[places])
    assert picked.R_WB.shape == (*picked.t.shape, 3, 3)


def test_iterating_a_trajectory_yields_each_time(racket):
    motion = racket.trajectory([0.0, 1.5, 4.0])
    assert [float(one.t) for one in motion] == [0.0, 1.5, 4.0]
    with pytest.raises(IndexError):
        motion[3]


@pytest.mark.parametrize(
    "module, use",
    [("pandas", lambda motion: motion.to_frame()), ("scipy.spatial.transform", lambda motion: motion.rotation)],
)
def test_a_missing_package_is_named(racket, monkeypatch, module, use):
    monkeypatch.setitem(sys.modules, module, None)  # as if it were not installed
    with pytest.raises(poinsot.MissingPackageError, match=f"needs the package {module.split('.')[0]}: ") as caught:
        use(racket.trajectory([0, 1]))
    assert isinstance(caught.value, ImportError)


def test_nothing_optional_is_imported_before_it_is_used():
    code = "import sys, poinsot; sys.exit(any(name in sys.modules for name in ('pandas', 'scipy', 'PIL')))"
    assert subprocess.run(["/usr/bin/python3", "-B", "-c", code]).returncode == 0


# ---- grading


@pytest.fixture
def engine(racket):
    """Returns arrays of a log with a slow drift of the attitude about z, and a smaller drift of omega."""
    t = np.linspace(0, 7, 40)
    motion = racket.trajectory(t)
    half = 0.5e-4 * t
    w, x, y, z = motion.q_WB.T
    c, s = np.cos(half), np.sin(half)
    q = np.stack([c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w], axis=-1)
    return {"t": t, "q_WB": q, "omega_B": motion.omega_B * (1 + 1e-6 * t[:, np.newaxis])}


def columns_of(engine):
    """Returns the log with a column for each component, and a column that grading ignores."""
    columns = {"t": engine["t"], "note": np.array(["x"] * len(engine["t"]))}
    columns |= {f"q_{part}": engine["q_WB"][:, i] for i, part in enumerate("wxyz")}
    return columns | {f"omega_B_{part}": engine["omega_B"][:, i] for i, part in enumerate("xyz")}


@pytest.fixture
def log(tmp_path, engine):
    """Returns the CSV file of the log."""
    columns = columns_of(engine)
    rows = zip(*columns.values(), strict=True)
    lines = [columns, *([it if isinstance(it, str) else repr(float(it)) for it in row] for row in rows)]
    (tmp_path / "log.csv").write_text("".join(",".join(line) + "\n" for line in lines))
    return tmp_path / "log.csv"


def test_grading_finds_a_known_drift(racket, engine):
    grade = racket.grade(engine)
    attitude, omega = grade["quantities"]["attitude"], grade["quantities"]["omega_B"]
    assert attitude["largest"] == pytest.approx(7e-4, rel=1e-9)  # 1e-4 t, in rad
    assert attitude["rms"] == pytest.approx(1e-4 * np.sqrt(np.mean(engine["t"] ** 2)), rel=1e-9)
    size = np.linalg.norm(racket.trajectory(engine["t"]).omega_B, axis=1)
    assert omega["largest"] == pytest.approx((1e-6 * engine["t"] * size).max() / size.max(), rel=1e-8)
    assert (attitude["largest_at_s"], attitude["drift"]["kind"]) == (7.0, "drift")
    assert grade["passes"] is None


def test_a_grade_equals_the_programs(racket, program, log, engine):
    expected = json.loads(program("grade", RACKET, log, "--json"))
    grade = racket.grade(log)
    assert {**expected, "passes": None} == grade
    scalar_last = {"t": engine["t"], "q_WB_xyzw": engine["q_WB"][:, [1, 2, 3, 0]], "omega_B": engine["omega_B"]}
    for table in (engine, columns_of(engine), structured(engine), scalar_last):
        assert racket.grade(table) == {**grade, "file": None}


def structured(engine):
    table = np.zeros(len(engine["t"]), dtype=[("t", "f8"), ("q_WB", "f8", 4), ("omega_B", ">f8", 3)])
    for name in table.dtype.names:
        table[name] = engine[name]
    return table


def test_data_frames_are_graded(pandas, racket, engine, log):
    expected = {**racket.grade(log), "file": None}
    frame = pandas.DataFrame(columns_of(engine))
    assert racket.grade(frame) == expected
    assert racket.grade(frame.set_index("t")) == expected
    doubled = pandas.concat([frame, frame[["q_w"]]], axis=1)
    with pytest.raises(poinsot.UsageError, match="column q_w occurs twice"):
        racket.grade(doubled)
    own = racket.trajectory([0, 1, 2])
    assert racket.grade(own.to_frame())["quantities"] == racket.grade(own)["quantities"]


@pytest.mark.parametrize(
    "limit, word", [(1e-3, "1e-3"), (5e-4, "5e-4"), ("0.1 deg", "0.1 deg"), ("0.01 deg", "0.01 deg")]
)
def test_a_grade_passes_where_the_programs_exit_code_is_0(racket, log, limit, word):
    program = [os.environ["POINSOT_TESTED_PROGRAM"], "grade", RACKET, str(log), "--max-attitude-error", word]
    code = subprocess.run(program, capture_output=True).returncode
    assert code in (0, 1)
    assert racket.grade(log, max_attitude_error=limit)["passes"] == (code == 0)


def test_a_clock_in_timedeltas_is_in_seconds(racket, engine):
    ms = {**engine, "t": (engine["t"] * 1000).round().astype("m8[ms]")}
    s = {**engine, "t": (engine["t"] * 1000).round() / 1000}
    assert racket.grade(ms)["quantities"] == racket.grade(s)["quantities"]


GOOD = {"t": [0.0, 1.0], "omega_B": np.ones((2, 3))}


@pytest.mark.parametrize(
    "table, message",
    [
        (3, "table: got int"),
        ([1, 2], "table: got list"),
        ({}, "no column t"),
        ({"time": [1.0]}, "no column t; if 'time' is the time, name it t"),
        ({"t": [0, 1]}, r"table: no motion to grade; give q_WB, an array \(n, 4\), or omega_B, an array \(n, 3\)"),
        ({"t": [0, 1], "qx": [1, 1], "qy": [0, 0]}, "no motion to grade; .*; got 'qx', 'qy'$"),
        ({"t": [0, 1], "q_w": [1, 1]}, "column q_z is missing"),
        ({**GOOD, "t": [0, 1, 2]}, "table: omega_B has 2 rows, t has 3"),
        ({**GOOD, "t": [0, np.nan]}, r"t\[1\] = nan: a time is a finite"),
        ({**GOOD, "t": [], "omega_B": np.ones((0, 3))}, "no rows"),
        ({**GOOD, "omega_B": np.ones((3, 2))}, r"omega_B: shape \(3, 2\); its last axis must have 3"),
        ({**GOOD, "omega_B": np.ones((2, 3)) * 1j}, "omega_B: expected real numbers, got values of type complex"),
        ({**GOOD, "T": np.array(["a", "b"])}, "T: expected real numbers, got values of type <U1"),
        ({**GOOD, "T": np.array([1, "b"], object)}, "T: has values that are not real numbers$"),
        ({**GOOD, "omega_B": np.ma.array(np.ones((2, 3)), mask=np.eye(2, 3))}, r"omega_B: has masked .*\.any\(axis=-1\)$"),
        ({**GOOD, "t": np.ma.array([0, 1], mask=[0, 1])}, r"t\[1\] = masked"),
        ({**GOOD, "t": np.array(["2024-01-01", "2024-01-02"], "M8[D]")}, "t: a time is a number of seconds"),
    ],
    ids=lambda it: it if isinstance(it, str) else "",
)
def test_malformed_tables_are_refused(racket, table, message):
    with pytest.raises(poinsot.UsageError, match=message):
        racket.grade(table)


def test_bad_limits_files_and_times_are_refused(racket, tmp_path):
    for limit in (-1, "3 kg", "", float("nan")):
        with pytest.raises(poinsot.UsageError, match="max_attitude_error"):
            racket.grade(GOOD, max_attitude_error=limit)
    with pytest.raises(poinsot.UsageError, match="no attitude"):
        racket.grade(GOOD, max_attitude_error=1)
    with pytest.raises(poinsot.FileError, match="none.csv"):
        racket.grade(tmp_path / "none.csv")
    with pytest.raises(poinsot.LimitError, match=r"^t\[1\]: t = 1e\+300 s: too far from the start"):
        racket.grade({**GOOD, "t": [0, 1e300]})
    with pytest.raises(poinsot.LimitError, match=r"^t\[1\]: .*steps"):
        racket.replace({"motion.torque.body": [1, 0, 0]}).grade({**GOOD, "t": [0, 1e300]})


def test_the_advice_for_masked_values_works(racket):
    omega_B = np.ma.array(np.ones((3, 3)), mask=[[0, 0, 1], [0, 0, 0], [0, 0, 0]])
    t = np.array([0.0, 1.0, 2.0])
    with pytest.raises(poinsot.UsageError) as caught:
        racket.grade({"t": t, "omega_B": omega_B})
    advice = str(caught.value).partition("keep = ")[2]
    keep = eval(advice, {"numpy": np, "omega_B": omega_B})
    assert racket.grade({"t": t[keep], "omega_B": omega_B[keep]})["rows"] == 2
