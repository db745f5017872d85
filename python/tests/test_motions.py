# SPDX-License-Identifier: Apache-2.0
"""Tests that a driven motion is integrated once for each span of time, and that its numbers depend only on the span."""

import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import poinsot

TOP = {
    "body": {"principal_moments": [2, 2, 1]},
    "motion": {"omega_body": [0.1, 0, 20], "gravity": {"mgr_body": [0, 0, 3]}},
}


def seconds(work):
    begin = time.process_time()
    work()
    return time.process_time() - begin


def same(one, other):
    return all(np.array_equal(a, b) for a, b in zip(vars(one).values(), vars(other).values(), strict=True))


def test_a_span_is_integrated_once():
    scene = poinsot.loads(TOP)
    first = seconds(lambda: scene.trajectory(200.0))
    assert first > 0.1  # long enough to notice whether it is cached
    assert seconds(lambda: scene.trajectory(200.0)) < first / 50  # measured 1e-4 of it
    assert seconds(lambda: [scene.trajectory(t, span=(0, 200)) for t in range(200)]) < first / 5


def test_results_do_not_depend_on_earlier_calls():
    asked = [([3.0], None), ([1.0, 7.0], None), ([3.0], (0, 7)), ([-2.0, 3.0], None), ([3.0], (-5, 9)), ([3.0], None)]
    alone = [poinsot.loads(TOP).trajectory(times, span=span) for times, span in asked]
    for order in (asked, asked[::-1]):
        scene = poinsot.loads(TOP)
        kept = [scene.trajectory(times, span=span) for times, span in order]
        expected = alone if order is asked else alone[::-1]
        assert all(same(a, b) for a, b in zip(kept, expected, strict=True))


def test_rows_of_a_span_equal_the_programs_table(program, tmp_path):
    scene = poinsot.loads(TOP)
    (tmp_path / "top.toml").write_text(scene.text)
    table = program("trajectory", tmp_path / "top.toml", "--at=-1,3,10").decode().splitlines()
    rows = np.array([[float(word) for word in line.split(",")] for line in table[1:]])
    for row in rows:
        motion = scene.trajectory(row[0], span=(-1, 10))
        own = [motion.t, *motion.q_WB, *motion.omega_B, *motion.omega_W, *motion.L_W, motion.T]
        assert np.array_equal(row, own)


def test_threads_share_a_motion():
    alone = seconds(lambda: poinsot.loads(TOP).trajectory(200.0))
    scene, expected = poinsot.loads(TOP), poinsot.loads(TOP).trajectory(200.0)

    def together():
        with ThreadPoolExecutor(8) as pool:
            assert all(same(expected, motion) for motion in pool.map(scene.trajectory, [200.0] * 8))

    assert seconds(together) < 3 * alone  # measured 1.0 times on an idle machine; 8 times if each thread integrated


def test_a_time_outside_the_span_is_refused():
    with pytest.raises(poinsot.LimitError, match=r"^times\[1\]: t = 3.5 s: .* computed only from 0 s to 3 s"):
        poinsot.loads(TOP).trajectory([1, 3.5], span=(0, 3))
    assert issubclass(poinsot.LimitError, ValueError)
    for wrong in ((3, 0), (0, 1, 2), 3, "0-3", (0, float("nan"))):
        with pytest.raises(poinsot.UsageError, match="^span"):
            poinsot.loads(TOP).trajectory(1, span=wrong)
