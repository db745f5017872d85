# SPDX-License-Identifier: Apache-2.0
"""Tests films: bytes equal to the program's, progress, stopping, and display in a notebook."""

import base64
import re

import pytest

import poinsot

SIZE = (64, 36)


def test_a_film_equals_the_programs(tmp_path, program):
    seen = []
    film = poinsot.load("scenes/tennis_racket.toml").film(
        tmp_path / "a.mp4", size=SIZE, frames=(0, 29), progress=lambda *counts: seen.append(counts)
    )
    program("render", "scenes/tennis_racket.toml", "--size", "64x36", "--frames", "0-29", "-o", tmp_path / "b.mp4")
    assert film.path.read_bytes() == (tmp_path / "b.mp4").read_bytes()
    assert (film.size, film.frame_count, film.duration) == (SIZE, 30, 1.0)
    assert seen[-1] == (30, 30)
    assert seen == sorted(seen)


def test_a_notebook_embeds_the_film(tmp_path, racket):
    film = racket.film(tmp_path / "a.mp4", size=SIZE, frames=(0, 5), jobs=1)
    shown = re.fullmatch(r'<video src="data:video/mp4;base64,([^"]+)" controls loop [^>]*></video>', film._repr_html_())
    assert base64.b64decode(shown[1]) == film.path.read_bytes()
    picture = racket.film(tmp_path / "a.gif", size=SIZE, frames=(0, 2))._repr_html_()
    assert picture.startswith('<img src="data:image/gif;base64,')
    film.path.rename(tmp_path / "b.mp4")
    assert "no longer exists" in film._repr_html_()
    pictures = racket.film(tmp_path / "<a>{frame}.png", size=SIZE, frames=(0, 1))._repr_html_()
    assert pictures.startswith("<p>2 pictures: ") and "&lt;a&gt;" in pictures


def test_a_film_uses_the_text_that_was_loaded(tmp_path):
    file = tmp_path / "spin.toml"
    file.write_text("[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0, 0.1, 3]\n")
    scene = poinsot.load(file)
    before = scene.film(tmp_path / "a.mp4", size=SIZE, frames=(0, 3)).path.read_bytes()
    file.write_text("no scene any more")
    assert scene.film(tmp_path / "b.mp4", size=SIZE, frames=(0, 3)).path.read_bytes() == before


def test_a_film_stopped_by_its_progress_can_be_resumed(tmp_path, racket):
    def stop(done, total):
        if done >= 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        racket.film(tmp_path / "a.mp4", size=(960, 540), jobs=1, progress=stop)
    assert not (tmp_path / "a.mp4").exists()
    resumed = racket.film(tmp_path / "a.mp4", size=SIZE, frames=(0, 9), resume=True)
    assert resumed.path.exists()


def test_errors_of_films_have_the_reason(tmp_path, racket):
    with pytest.raises(poinsot.FileError, match="no such folder"):
        racket.film(tmp_path / "none" / "a.mp4")
    with pytest.raises(poinsot.UsageError, match="a.doc"):
        racket.film(tmp_path / "a.doc")


def test_motions_work_without_the_program_but_films_fail(tmp_path, monkeypatch, racket):
    monkeypatch.setenv("POINSOT_PROGRAM", str(tmp_path / "nothing"))
    assert racket.trajectory(0).T > 0
    with pytest.raises(poinsot.FileError, match="POINSOT_PROGRAM"):
        racket.film(tmp_path / "a.mp4")
