# SPDX-License-Identifier: Apache-2.0
"""Tests stability maps, checks and explanations. Oracles: the closed form by SciPy; info, check and explain."""

import json
import os
import re
import subprocess

import numpy as np
import pytest

import poinsot

RACKET = "scenes/tennis_racket.toml"
INERTIA = np.array([[2.0, 0.3, 0.1], [0.3, 3.0, -0.2], [0.1, -0.2, 3.5]])


@pytest.fixture
def tilted():
    """Returns the scene of a body whose principal axes differ from the axes of its description."""
    return poinsot.loads({"body": {"inertia": INERTIA}, "motion": {"omega_body": [0.1, 2, 0.3]}})


def closed_form(moments, m_P):
    """Returns 2K/lambda for L = m_P, from energy and |L| alone; sorted axes a < b < c (Landau, Lifshitz, section 37)."""
    special = pytest.importorskip("scipy.special", reason="python3-scipy is not installed")
    (a, b, c), T2, L2 = np.sort(moments), (m_P**2 / moments).sum(axis=-1), (m_P**2).sum(axis=-1)
    about_c = L2 > T2 * b
    near, far = np.where(about_c, c, a), np.where(about_c, a, c)
    rate = np.sqrt((near - b) * (L2 - T2 * far) / (a * b * c))  # both factors change sign together
    complement = (b - far) * (T2 * near - L2) / ((near - b) * (L2 - T2 * far))
    return 2 * special.ellipk(complement) / rate


def test_the_map_equals_the_closed_form(tilted):
    map = tilted.sweep_map(shape=(19, 37))
    assert (map["flip_interval"].shape, map["direction_B"].shape) == ((19, 37), (19, 37, 3))
    expected = closed_form(map["moments"], map["L"] * map["direction_P"])
    far = expected < 20 * map["scale"]["least"]  # nearer to the separatrix, this formula loses 1 - k^2
    assert far.mean() > 0.9
    assert np.abs(map["flip_interval"] / expected - 1)[far].max() < 1.6e-13  # measured 1.6e-14


def test_the_maps_directions_match_its_angles(tilted):
    map = tilted.sweep_map(shape=(5, 9))
    theta, phi = np.meshgrid(map["theta"], map["phi"], indexing="ij")
    expected = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)
    assert np.abs(map["direction_P"] - expected).max() < 3e-16
    assert (map["theta"][[0, -1]] == [0, np.pi]).all() and (map["phi"][[0, -1]] == [0, 2 * np.pi]).all()
    R = map["R_BP"]
    # In the principal axes P, the inertia tensor is diagonal; measured 4.4e-16.
    assert np.abs(R.T @ INERTIA @ R - np.diag(map["moments"])).max() < 5e-15
    assert np.abs(map["direction_B"] - map["direction_P"] @ R.T).max() == 0


def test_a_cell_equals_info_of_a_body_with_this_start(program, tilted):
    map = tilted.sweep_map(shape=(5, 8))
    for cell in ((1, 1), (2, 3)):
        omega_B = np.linalg.solve(INERTIA, map["L"] * map["direction_B"][cell])
        scene = tilted.replace({"motion.omega_body": omega_B.tolist()})
        assert map["flip_interval"][cell] == pytest.approx(scene.info()["flip_interval"], rel=6e-15)  # measured 5.6e-16
    racket = poinsot.load(RACKET).sweep_map(shape=(2, 2))
    printed = json.loads(program("info", RACKET, "--json"))["flip_interval"]
    assert racket["scene"]["flip_interval"] == pytest.approx(printed, rel=1e-14)


def test_flip_intervals_are_infinite_on_the_middle_axis():
    scene = poinsot.loads({"body": {"principal_moments": [1, 2, 3]}, "motion": {"omega_body": [0.1, 2, 0.3]}})
    map = scene.sweep_map(shape=(3, 5))
    assert np.isinf(map["flip_interval"][1, 1]) and np.isinf(map["flip_interval"][1, 3])  # along e2 and -e2
    assert np.isfinite(map["flip_interval"]).sum() == 13
    L_P = map["L"] * map["separatrix_P"]
    assert map["separatrix_P"].shape[::2] == (2, 3)
    assert np.abs(np.linalg.norm(map["separatrix_P"], axis=-1) - 1).max() < 3e-16
    T = 0.5 * (L_P**2 / map["moments"]).sum(axis=-1)
    assert np.abs(T - 0.5 * map["L"] ** 2 / 2).max() < 4e-15 * T.max()  # the energy of a spin about the middle axis
    x, y, z = np.array([0.1, 4, 0.9]) / map["L"]  # the scene's own L
    assert (map["scene"]["theta"], map["scene"]["phi"]) == pytest.approx((np.arccos(z), np.arctan2(y, x)), rel=1e-14)


NOTHING_SHOWN = {
    f"show.{name}": False
    for name in ("L", "omega", "ellipsoid", "plane", "contact", "polhode", "herpolhode", "height")
}


@pytest.mark.parametrize(
    "changes, message",
    [
        ({"motion.drag.rate": [0.1, 0.1, 0.1]}, "not free"),
        ({"body.principal_moments": [2, 2, 3]}, "two principal moments are equal"),
        ({"motion.omega_body": [0, 0, 0], "motion.orientation": [1, 0, 0, 0], **NOTHING_SHOWN}, "at rest"),
    ],
)
def test_bodies_without_a_map_are_refused(changes, message):
    scene = poinsot.loads({"body": {"principal_moments": [1, 2, 3]}, "motion": {"omega_body": [0.1, 2, 0.3]}})
    with pytest.raises(poinsot.PhysicsError, match=message):
        scene.replace(changes).sweep_map()


@pytest.mark.parametrize("shape", [3, (3,), (1, 5), (2.5, 3), (4, 5, 6), "ab", (10**4, 10**4), None])
def test_invalid_shapes_are_refused(racket, shape):
    with pytest.raises(poinsot.UsageError, match="shape="):
        racket.sweep_map(shape=shape)


# ---- check


def run(*words):
    return subprocess.run([os.environ["POINSOT_TESTED_PROGRAM"], *map(str, words)], capture_output=True, text=True)


def test_notes_equal_those_of_the_programs_check(tmp_path):
    file = tmp_path / "slips.toml"
    file.write_text(
        "[body]\nshape = 'box'\nsize = [1, 2, 3]\nmass = 1\n[motion]\nomega_body = [1, 2, 3]\n"
        "[camera]\nazimuth = 3\n"
    )
    said = run("check", file)
    checked = poinsot.load(file).check()
    notes = [f"{one.file}:{one.line}:{one.column}: note: {one.message}" for one in checked["notes"]]
    assert notes == said.stderr.splitlines()
    assert (checked["ok"], checked["problems"], len(checked["notes"])) == (said.returncode == 0, [], 1)
    assert poinsot.load(RACKET).check()["notes"] == []


def test_a_scene_that_cannot_be_drawn_has_a_problem(tmp_path):
    file = tmp_path / "driven.toml"
    file.write_text(
        "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [1, 2, 3]\ndrag.rate = [0.1, 0.1, 0.1]\n"
        "[show]\npolhodes.visible = true\n"
    )
    said = run("check", file)
    checked = poinsot.load(file).check()
    assert (checked["ok"], said.returncode) == (False, 2), said
    (problem,) = checked["problems"]
    assert problem.message in said.stderr
    assert problem.file == str(file)


def test_memory_limits_below_the_estimates_are_refused(racket):
    estimates = racket.check()["estimates"]
    assert estimates["frames"] == racket.frame_count
    assert {type(estimate) for estimate in estimates.values()} == {int}
    need = estimates["picture_memory_bytes"]

    def limited(memory):
        return poinsot.load(RACKET, {"output.size": [160, 90]}, limits={"memory": memory})

    assert limited(need).render(0).shape == (90, 160, 3)
    with pytest.raises(poinsot.LimitError, match="of memory"):
        limited(need - 1).render(0)
    need = estimates["film_memory_bytes"]
    dry = ("render", RACKET, "--size", "160x90", "--dry-run", "-o", "film.mp4")
    assert run(*dry, "--limit", f"memory={need}").returncode == 0
    assert "of memory" in run(*dry, "--limit", f"memory={need - 1}").stderr


# ---- explain


@pytest.mark.parametrize("word", ["camera.fov", "fov", "camera", "racket", "slug", "units", ""])
def test_explanations_equal_those_of_the_program(program, word):
    said = program("explain", *([word] if word else [])).decode()

    def words(text):
        return re.sub(r"\s+", " ", text)

    explained = poinsot.explain(word)
    assert explained
    for title, rows in explained.items():
        assert title in said
        for text in rows.values():
            assert words(text).strip() in words(said)


def test_an_unknown_name_gets_a_suggestion():
    with pytest.raises(poinsot.UsageError, match="did you mean camera.fov"):
        poinsot.explain("camera.fow")
    assert poinsot.explain("camera.fov")["camera.fov"]["default"] == '"24 deg"'
