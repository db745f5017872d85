# SPDX-License-Identifier: Apache-2.0
"""Tests poinsot.diff(). Oracles: the program's JSON for files of the same pixels, and NumPy for the figures."""

import itertools
import json
import os
import subprocess

import numpy as np
import pytest
from PIL import Image

import poinsot

SIZE = (48, 32)


def shown(seed, shape=(32, 48, 3), dtype=np.uint8):
    return np.random.default_rng(seed).integers(0, np.iinfo(dtype).max, shape, dtype, endpoint=True)


def near(picture, step=1, share=0.3):
    """Returns a copy of a picture with some samples changed by up to `step`."""
    random = np.random.default_rng(7)
    steps = random.integers(-step, step + 1, picture.shape) * (random.random(picture.shape) < share)
    moved = picture.astype(np.int64) + steps
    return moved.clip(0, np.iinfo(picture.dtype).max).astype(picture.dtype)


def by_program(a, b, *words):
    command = [os.environ["POINSOT_TESTED_PROGRAM"], "diff", str(a), str(b), "--json", *words]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return json.loads(done.stdout)


def in_memory(figures):
    return {**figures, "reference": None, "test": None}


@pytest.fixture
def saved(tmp_path):
    names = (tmp_path / f"{i}.png" for i in itertools.count())

    def save(picture):
        path = next(names)
        Image.fromarray(picture).save(path)
        return path

    return save


@pytest.mark.parametrize("shape", [(32, 48), (32, 48, 2), (32, 48, 3), (32, 48, 4)], ids=str)
def test_figures_equal_the_programs_to_the_last_bit(saved, shape):
    a = shown(1, shape)
    for b in (a.copy(), near(a), near(a, 60, 0.1)):
        file_a, file_b = saved(a), saved(b)
        expected = by_program(file_a, file_b)
        assert poinsot.diff(file_a, file_b) == expected
        for one, other in ((a, b), (Image.fromarray(a), b), (a, Image.fromarray(b))):
            assert poinsot.diff(one, other) == in_memory(expected)
        assert poinsot.diff(file_a, b) == {**expected, "test": None}
        assert poinsot.diff(Image.open(file_a), str(file_b)) == {**expected, "reference": None}


def test_figures_of_16_bits_equal_the_programs(tmp_path, program):
    for name, theme in (("a.png", "light"), ("b.png", "dark")):
        form = ("--size", "48x32", "--bits", "16", "-D", f"style.theme={theme}")
        program("still", "scenes/tennis_racket.toml", *form, "-o", tmp_path / name)
    scene = poinsot.load("scenes/tennis_racket.toml")
    a, b = scene.render(size=SIZE, bits=16), scene.replace({"style.theme": "dark"}).render(size=SIZE, bits=16)
    expected = by_program(tmp_path / "a.png", tmp_path / "b.png")
    assert poinsot.diff(a, b) == in_memory(expected)
    assert poinsot.diff(a.astype(">u2"), tmp_path / "b.png") == {**expected, "reference": None}
    assert (expected["verdict"], poinsot.diff(a, tmp_path / "a.png")["verdict"]) == ("different", "identical")


def test_a_grey_png_of_16_bits_is_read_as_by_pil(saved):
    deep = shown(3, (32, 48), np.uint16)
    file = saved(deep)
    assert Image.open(file).mode.startswith("I")
    assert poinsot.diff(Image.open(file), deep)["verdict"] == "identical"
    assert poinsot.diff(file, Image.open(file))["notes"] == []


def test_palette_and_bilevel_pictures_are_compared_by_colour(saved):
    plain = shown(4)
    palette = Image.fromarray(plain).quantize(16)
    assert poinsot.diff(palette, np.asarray(palette.convert("RGB")))["verdict"] == "identical"
    bilevel = Image.fromarray(plain).convert("1")
    assert poinsot.diff(bilevel, np.asarray(bilevel.convert("L")))["verdict"] == "identical"
    palette.info["transparency"] = 0  # colour 0 becomes transparent
    assert poinsot.diff(palette, np.asarray(palette.convert("RGBA")))["verdict"] == "identical"
    with pytest.raises(poinsot.UsageError, match="reference: a PIL image of mode CMYK"):
        poinsot.diff(Image.fromarray(plain).convert("CMYK"), plain)


def test_figures_equal_those_of_numpy():
    a = shown(1)
    b = near(a, 60, 0.1)
    figures = poinsot.diff(a, b)
    difference = np.abs(a.astype(int) - b)
    per_pixel = difference.max(axis=2)
    assert figures["max_difference"] == difference.max()
    assert figures["differing_pixels"] == (per_pixel > 0).sum()
    assert figures["differing_share"] == (per_pixel > 0).mean()
    assert figures["mean_difference"] == pytest.approx(difference.mean(), rel=1e-14)
    assert figures["rmse"] == pytest.approx(np.sqrt((difference.astype(float) ** 2).mean()), rel=1e-14)
    assert figures["psnr_db"] == pytest.approx(20 * np.log10(255 / figures["rmse"]), rel=1e-14)
    worst = figures["worst_pixels"][0]
    assert worst["difference"] == per_pixel[worst["y"], worst["x"]] == per_pixel.max()
    assert worst["reference"] == a[worst["y"], worst["x"]].tolist()
    same = poinsot.diff(a, a)
    assert (same["verdict"], same["rmse"], same["psnr_db"], same["change"]) == ("identical", 0, None, None)
    assert (same["ssim"]["mean"], same["flip"]["max"]) == (1, 0)


@pytest.mark.parametrize(
    "rule, words",
    [
        ("same", ["--rule", "same"]),
        ("other_driver", ["--rule", "other_driver"]),
        (
            {"max": 80, "pixels": "0-50%", "flip_mean": 1, "flip_max": np.float64(1)},
            ["--max", "0-80", "--pixels", "0-50%", "--flip-mean", "0-1", "--flip-max", "0-1"],
        ),
        (
            {"like": "other_driver", "pixels": 10, "level": 3},
            ["--rule", "other_driver", "--pixels", "0-10", "--level", "3"],
        ),
    ],
    ids=str,
)
def test_rules_equal_the_programs_options(saved, rule, words):
    a = shown(1)
    b = near(a, 60, 0.1)
    expected = by_program(saved(a), saved(b), *words)
    assert poinsot.diff(a, b, rule) == in_memory(expected)
    assert poinsot.diff(a, b, rule=rule)["limits"] == expected["limits"]


def test_ignored_boxes_and_masks_are_left_out(saved):
    a = shown(1)
    b = a.copy()
    b[4:9, 10:30] ^= 255
    mask = np.zeros(a.shape[:2], bool)
    mask[4:9, 10:20] = True
    file = saved(mask.astype(np.uint8) * 255)
    words = ["--ignore", "20,4,10,4", "--ppd", "30"]
    expected = by_program(saved(a), saved(b), "--mask", str(file), *words)
    for painted in (mask, mask.astype(np.uint8), file, Image.fromarray(mask)):
        figures = poinsot.diff(a, b, ignore=[(20, 4, 10, 4)], mask=painted, pixels_per_degree=30)
        figures["limits"]["mask"] = expected["limits"]["mask"]
        assert figures == in_memory(expected)
    assert expected["differing_pixels"] == 10


def test_films_are_compared_frame_by_frame(tmp_path):
    scene = poinsot.load("scenes/tennis_racket.toml", {"time.fps": 4})
    films = [
        one.film(tmp_path / name, size=SIZE, frames=(0, 2), jobs=1).path
        for one, name in ((scene, "a.mp4"), (scene.replace({"motion.omega_body": [0.04, 3, 0]}), "b.mp4"))
    ]
    figures = poinsot.diff(*films)
    assert figures == by_program(*films)
    assert (len(figures["frames"]), figures["verdict"]) == (3, "different")
    assert poinsot.diff(films[0], films[0], jobs=2)["verdict"] == "identical"
    with pytest.raises(poinsot.UsageError, match="the reference is a film, but the test is a picture"):
        poinsot.diff(films[0], shown(1))


PICTURE = shown(1)


@pytest.mark.parametrize(
    "asked, message",
    [
        ({"test": shown(1, (32, 47, 3))}, "the size is 47x32, not 48x32: only pictures of the same size can be compared"),
        ({"test": PICTURE / 255}, "test: expected samples of type uint8 or uint16, got float64"),
        ({"test": PICTURE.astype(np.int64)}, "test: expected samples of type uint8 or uint16, got int64"),
        ({"test": PICTURE > 3}, "test: expected samples of type uint8 or uint16, got bool"),
        ({"test": [[1, 2], [3, 4]]}, "test: expected samples of type uint8 or uint16, got int64"),
        ({"test": None}, "test=None: must be a path, an array of pixels or a PIL image"),
        ({"test": PICTURE[0, 0]}, r"test: shape \(3,\)"),
        ({"test": PICTURE[:, :, :, np.newaxis]}, "test: shape"),
        ({"test": PICTURE[:0]}, "test: shape"),
        ({"test": np.zeros((4, 4, 5), np.uint8)}, r"test: shape \(4, 4, 5\)"),
        ({"test": "/"}, "test: / is a folder"),
        ({"rule": "alike"}, "rule 'alike': unknown rule; known rules: same, near, other_driver"),
        ({"rule": {"maxx": 3}}, "rule: unknown key 'maxx'; the keys are like, max, pixels"),
        ({"rule": {"max": 256}}, "rule: max '0-256': the end of the range must be a number from 0 to 255"),
        ({"rule": {"max": "2"}}, "rule: max '2': write 0-2"),
        ({"rule": {"max": True}}, r"rule\['max'\]=True: must be a finite number"),
        ({"rule": {"max": [2]}}, r"rule\['max'\]=\[2\]: must be a finite number"),
        ({"rule": {"max": 255, "pixels": "0-100%", "flip_mean": 1, "flip_max": 1}}, "rule: every picture would pass"),
        ({"rule": 3}, "rule=3: must be a dictionary"),
        ({"ignore": [(1, 2, 3)]}, "ignore=.*: must be a list of boxes"),
        ({"ignore": np.array(3)}, "ignore=.*: must be a list of boxes"),
        ({"ignore": [np.array(3)]}, "ignore=.*: must be a list of boxes"),
        ({"test": np.ma.array(PICTURE, mask=PICTURE == PICTURE)}, "test: has masked values"),
        ({"ignore": [(100, 0, 1, 1)]}, r"ignore \[100, 0, 1, 1\]: outside of the picture"),
        ({"mask": np.ones((3, 3), bool)}, "mask: its size is 3x3; the picture's is 48x32"),
        ({"mask": np.ones((32, 48), bool)}, "nothing is left to compare"),
        ({"pixels_per_degree": 0}, "pixels_per_degree=0: must be a number from 1 to 1000"),
        ({"jobs": 0}, "jobs=0: must be 1 to 1024"),
        ({"limits": {"memry": 3}}, "memry"),
    ],
    ids=str,
)
def test_invalid_arguments_are_refused(asked, message):
    with pytest.raises(poinsot.UsageError, match=message):
        poinsot.diff(**{"reference": PICTURE, "test": PICTURE, **asked})


def test_missing_files_and_memory_are_reported(tmp_path):
    with pytest.raises(poinsot.FileError, match="none.png"):
        poinsot.diff(PICTURE, tmp_path / "none.png")
    (tmp_path / "text.png").write_text("no picture")
    with pytest.raises(poinsot.FileError, match="text.png"):
        poinsot.diff(tmp_path / "text.png", PICTURE)
    large = np.zeros((4000, 4000), np.uint8)
    with pytest.raises(poinsot.LimitError, match="comparing pictures of 4000x4000"):
        poinsot.diff(large, large, limits={"memory": "64 MiB"})
