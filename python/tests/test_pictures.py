# SPDX-License-Identifier: Apache-2.0
"""Tests pictures as arrays: they equal the program's, in any thread and process."""

import io
import multiprocessing
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest
from PIL import Image

import poinsot


def pixels(file):
    return np.asarray(Image.open(file))


def test_pictures_equal_the_programs(tmp_path, program, racket):
    program("still", "scenes/tennis_racket.toml", "--size", "160x90", "--time", "2", "-o", tmp_path / "a.png")
    program("still", "scenes/tennis_racket.toml", "--size", "90x160", "--transparent", "-o", tmp_path / "b.png")
    one, other = racket.render(2), racket.render(size=(90, 160), transparent=True)
    assert (one.shape, one.dtype, other.shape) == ((90, 160, 3), np.uint8, (160, 90, 4))
    assert np.array_equal(one, pixels(tmp_path / "a.png"))
    assert np.array_equal(other, pixels(tmp_path / "b.png"))


def test_pictures_of_16_bits_refine_those_of_8_bits(racket):
    deep = racket.render(1, bits=16)
    assert deep.dtype == np.uint16
    assert np.abs(deep / 257.0 - racket.render(1)).max() < 1  # less than a step of 8 bits
    assert len(np.unique(deep)) > 300


def test_an_array_outlives_its_scene(racket):
    def made():
        return racket.replace({"output.size": [32, 32]}).render(0)

    first = made()
    kept = first.copy()
    for _ in range(10):
        made()
    assert np.array_equal(first, kept)
    first[:] = 0  # the caller owns the array


def test_threads_draw_the_same_pictures(racket):
    times = [0.5 * i for i in range(16)]
    alone = [racket.render(t) for t in times]
    with ThreadPoolExecutor(8) as pool:
        together = list(pool.map(racket.render, times))
    assert all(np.array_equal(a, b) for a, b in zip(alone, together, strict=True))


def _sum(t):
    return int(poinsot.loads({"body": {"principal_moments": [1, 2, 3]}, "motion": {"omega_body": [1, 2, 3]}}).render(
        t, size=(64, 48)
    ).sum())


def test_a_spawned_process_draws_the_same_pictures(racket):
    racket.render(0)
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        assert pool.map(_sum, [0, 1, 2]) == [_sum(0), _sum(1), _sum(2)]


def _bytes(scene, t):
    return scene.render(t).tobytes()


def test_a_scene_can_be_sent_to_another_process(racket):
    scene = racket.replace({"output.size": [96, 54], "style.theme": "dark"})
    times = [0.0, 2.5]
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        there = list(pool.map(_bytes, [scene] * len(times), times))
    assert there == [_bytes(scene, t) for t in times]


def _refused(t):
    with pytest.raises(poinsot.UsageError, match="spawn"):
        _sum(t)
    return True


def test_a_fork_of_a_process_that_has_drawn_is_refused(racket):
    racket.render(0)
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert pool.map(_refused, [0, 1]) == [True, True]


def test_a_notebook_shows_a_picture_of_the_scene():
    scene = poinsot.load("scenes/tennis_racket.toml")
    shown = pixels(io.BytesIO(scene._repr_png_()))
    assert shown.shape == (540, 960, 3)
    assert np.array_equal(shown, scene.render(size=(960, 540)))


@pytest.mark.parametrize(
    "asked", [{"t": -1}, {"t": 14.1}, {"t": float("nan")}, {"size": (8, 90)}, {"bits": 12}]
)
def test_invalid_arguments_of_render_are_refused(racket, asked):
    with pytest.raises(poinsot.UsageError):
        racket.render(**asked)


def test_more_memory_than_the_limit_is_refused():
    scene = poinsot.load("scenes/tennis_racket.toml", limits={"memory": "100 MiB"})
    with pytest.raises(poinsot.LimitError, match="MiB"):
        scene.render(size=(8000, 8000))


def test_figures_are_saved(tmp_path, racket):
    for name, mark in (("a.pdf", b"%PDF"), ("a.svg", b"<?xml"), ("a.png", b"\x89PNG")):
        assert racket.save(tmp_path / name, 1.5, width="60mm").read_bytes().startswith(mark)
    assert np.array_equal(pixels(racket.save(tmp_path / "b.png", 1.5)), racket.render(1.5))
    with pytest.raises(poinsot.UsageError):
        racket.save(tmp_path / "a.doc")
