# SPDX-License-Identifier: Apache-2.0
"""Tests reading scenes from files, texts and dictionaries, and the reports of their mistakes."""

import copy
import pickle
import tomllib

import numpy as np
import pytest

import poinsot
from poinsot import _toml

OWN = {"body": {"principal_moments": [1, 2, 2.5]}, "motion": {"omega_body": [0.05, "20 rpm", 0]}}


def test_a_dictionary_gives_the_same_scene_as_its_text():
    text = '[body]\nprincipal_moments = [1, 2, 2.5]\n[motion]\nomega_body = [0.05, "20 rpm", 0]\n'
    assert poinsot.loads(OWN).info() == poinsot.loads(text).info()


@pytest.mark.parametrize(
    "it",
    [True, 3, -2.5, 1e300, 5e-324, float("inf"), "", 'q"uo\\te\n\t\x01\x7f ω', [1, [2.5, "x"]], {"a b": {"c": [False]}}],
)
def test_values_are_written_as_toml_reads_them(it):  # oracle: Python's tomllib
    assert tomllib.loads(_toml.document({"key": it, "table": {"of": it}})) == {"key": it, "table": {"of": it}}


def test_arrays_and_numpy_numbers_are_written_as_toml():
    assert tomllib.loads(_toml.document({"m": np.eye(2), "n": np.int64(3), "b": np.bool_(True)})) == {
        "m": [[1.0, 0.0], [0.0, 1.0]],
        "n": 3,
        "b": True,
    }


def test_values_that_toml_lacks_are_refused():
    for it in (object(), None, 1j, {1: 2}):
        with pytest.raises(poinsot.UsageError):
            poinsot.loads({"body": {"mass": it}})


def test_a_mistake_has_file_line_and_column(tmp_path):
    file = tmp_path / "spin.toml"
    file.write_text("[body]\nprincipal_moments = [1, 2, 2.5]\n[motion]\nomega_bdoy = [1, 2, 3]\n")
    with pytest.raises(poinsot.SceneError, match="did you mean motion.omega_body") as caught:
        poinsot.load(file)
    assert isinstance(caught.value, ValueError)
    places = [(one.file, one.line, one.column) for one in caught.value.problems]
    assert places == [(str(file), 4, 1)]


def mistakes(tables, **more):
    with pytest.raises(poinsot.SceneError) as caught:
        poinsot.loads(tables, **more)
    return caught.value


def test_a_mistake_in_a_dictionary_has_a_place_in_the_dictionary():
    error = mistakes({"body": OWN["body"], "motion": {"omega_bdoy": [1, 2, 3]}})
    message = "motion.omega_bdoy: unknown key; did you mean motion.omega_body?"
    assert error.problems == (poinsot.Problem("", 0, 0, message, place='scene["motion"]["omega_bdoy"]'),)
    assert str(error) == f'scene["motion"]["omega_bdoy"]: error: {message}'
    assert str(pickle.loads(pickle.dumps(error))) == str(error)


@pytest.mark.parametrize(
    ("tables", "place"),
    [
        ({"body": {"mass": -1}, "motion": OWN["motion"]}, 'scene["body"]["mass"]'),
        ({"body": {"part": [{"shape": "cube", "edge": 1, "mass": 2}, {"shpe": 3}]}}, 'scene["body"]["part"][1]["shpe"]'),
        ({"body": OWN["body"]}, "scene"),
        ({"body": OWN["body"], "motion": {}}, 'scene["motion"]["omega_body"]'),
        ({"schema": 2, **OWN}, 'scene["schema"]'),
        ({"sceem": 1, **OWN}, 'scene["sceem"]'),
        ({**OWN, "tíme": {}}, 'scene["tíme"]'),
    ],
)
def test_places_in_a_dictionary_lead_to_the_value(tables, place):
    assert place in [one.place for one in mistakes(tables).problems]


@pytest.mark.parametrize(
    ("motion", "line"),
    [
        ({"w": [0, 0, 3]}, 'scene["motion"]["omega_body"] = [0, 0, 3]'),
        ({**OWN["motion"], "gravity": 9.81}, 'scene["motion"]["gravity"] = {"g": 9.81}'),
        ({**OWN["motion"], "t_end": 5}, 'scene["time"] = {"duration": 5}'),
    ],
)
def test_examples_are_lines_of_python(motion, line):
    tables = {"body": {"shape": "box", "size": [3, 2, 1], "mass": 1, "pivot": [0, 0, -1]}, "motion": motion}
    message = mistakes(tables).problems[0].message
    assert message.endswith(f"For example:\n    {line}")
    scene = copy.deepcopy(tables)
    scene["motion"] = {name: it for name, it in motion.items() if name not in ("w", "t_end")}
    exec(message.rpartition("\n    ")[2])  # the example, as a user pastes it
    assert poinsot.loads(scene).frame_count > 0


def test_notes_on_a_dictionary_have_places_too():
    notes = poinsot.loads({**OWN, "camera": {"azimuth": 2}}).check()["notes"]
    assert [(one.place, one.file) for one in notes] == [('scene["camera"]["azimuth"]', "")]


def test_overrides_of_a_dictionary_keep_their_names():
    error = mistakes({"body": {**OWN["body"], "mas": 1}, "motion": OWN["motion"]}, overrides={"camera.zoom": 0})
    assert [(one.place, one.override) for one in error.problems] == [('scene["body"]["mas"]', ""), ("", "camera.zoom")]
    assert str(error).splitlines()[1].startswith("camera.zoom=0: error: ")


def test_overrides_win_over_the_file_and_replace_over_both(racket):
    assert racket.size == (160, 90)
    dark = racket.replace({"style.theme": "dark", "output.size": [64, 48]})
    assert dark.size == (64, 48)
    assert racket.size == (160, 90)
    with pytest.raises(poinsot.SceneError) as caught:
        racket.replace({"motion.omega_body": [1, 2]})
    assert str(caught.value).startswith("motion.omega_body=[1, 2]: error: motion.omega_body: ")


def test_overrides_can_be_read_back():
    given = {"output.size": np.array([64, 48]), "motion.omega_body": (1, 2.5, "3 rpm"), "style": {"theme": "dark"}}
    scene = poinsot.loads(OWN, given)
    plain = {"output.size": [64, 48], "motion.omega_body": [1, 2.5, "3 rpm"], "style": {"theme": "dark"}}
    assert scene.overrides == plain
    later = scene.replace({"time.duration": 2, "output.size": [32, 32]})
    assert later.overrides == {**plain, "time.duration": 2, "output.size": [32, 32]}
    assert list(later.overrides)[-2:] == ["time.duration", "output.size"]  # set last, so that they win
    scene.overrides.clear()
    assert scene.overrides == plain
    assert poinsot.loads(OWN, later.overrides).info() == later.info()


def test_a_scene_can_be_pickled_and_copied(tmp_path, monkeypatch):
    (tmp_path / "assets").mkdir()
    (tmp_path / "assets" / "own.toml").write_text('[style]\ntheme = "dark"\n')
    monkeypatch.chdir(tmp_path)
    scene = poinsot.loads(
        {**OWN, "style": {"file": "own.toml"}, "time": {"duration": 4000}},
        {"output.size": [32, 32]},
        name="pale",
        limits={"duration": 5000, "frames": 200_000},
        asset_roots=["assets"],
    ).replace({"motion.omega_body": [3, 2, 1]})
    pickled = pickle.dumps(scene)
    monkeypatch.chdir("/")  # as in another process
    again = pickle.loads(pickled)
    for of in ("name", "text", "size", "duration", "overrides", "frame_count"):
        assert getattr(again, of) == getattr(scene, of)
    assert np.array_equal(again.trajectory([1, 2]).q_WB, scene.trajectory([1, 2]).q_WB)
    assert np.array_equal(again.render(1), scene.render(1))
    assert copy.copy(scene) is scene and copy.deepcopy({"of": [scene]})["of"][0] is scene  # a scene never changes


def test_limits_hold_and_can_be_raised():
    long = {**OWN, "time": {"duration": 5000}}
    with pytest.raises(poinsot.LimitError, match="duration: must be from 0.001 to 3600 s"):
        poinsot.loads(long)
    assert poinsot.loads(long, limits={"duration": 6000, "frames": 200_000}).frame_count == 150_000
    with pytest.raises(poinsot.UsageError, match="no_such"):
        poinsot.loads(OWN, limits={"no_such": 3})


def test_files_that_a_scene_names_lie_in_its_folder_or_an_asset_root(tmp_path):
    (tmp_path / "own.toml").write_text('[style]\ntheme = "dark"\n')
    styled = {**OWN, "style": {"file": "own.toml"}}
    with pytest.raises(poinsot.SceneError, match="own.toml"):
        poinsot.loads(styled, folder=tmp_path / "elsewhere")
    for scene in (
        poinsot.loads(styled, folder=tmp_path),
        poinsot.loads(styled, folder=tmp_path / "elsewhere", asset_roots=[tmp_path]),
    ):
        assert scene.render(0, size=(32, 32)).mean() < 100  # dark background
        scene.save(tmp_path / "still.png", 0, size=(32, 32))
        (tmp_path / "still.png").unlink()


def test_a_scene_has_properties_and_descriptions(racket):
    assert (racket.name, racket.duration, racket.fps, racket.frame_count) == ("tennis_racket", 14, 30, 420)
    assert racket.motion_time(10.0) == pytest.approx(9.0)  # at speed 0.9
    assert racket.motion_time([[0, 1], [2, 3]]).shape == (2, 2)
    assert racket.info()["body_flips"] is True
    assert type(poinsot.load("scenes/heavy_top.toml").info()["steps"]) is int
    assert "racket" in racket.alt_text()
    assert "tennis_racket" in repr(racket)
