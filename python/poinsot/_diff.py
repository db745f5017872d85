# SPDX-License-Identifier: Apache-2.0
"""Comparison of pictures: arrays, files and PIL images."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _core
from ._errors import UsageError

_MOST_PER_DEGREE = 1000


def diff(
    reference: Any,
    test: Any,
    rule: str | Mapping[str, Any] | None = None,
    *,
    ignore: Sequence[tuple[int, int, int, int]] = (),
    mask: Any = None,
    pixels_per_degree: float = _core.flip_pixels_per_degree,
    jobs: int | None = None,
    limits: Mapping[str, int | str] | None = None,
) -> dict[str, Any]:
    """Compares two pictures, or two films frame by frame. Returns the figures and the verdict of `poinsot diff --json`.

    reference, test: each a path of a PNG or a film, a PIL image, or an array of uint8 or uint16. The shape of an array
        is (height, width) for grey, or (height, width, n) with n = 1 for grey, 2 for grey and alpha, 3 for RGB, 4 for
        RGBA. Colours are sRGB, alpha is straight, and rows begin at the top. The two may be of different kinds, but a
        film can only be compared with a film.
    rule: limits of a near picture. A name, "same", "near" (the default) or "other_driver", or a dictionary with the
        keys of a [rule] in a golden.toml: like (a name), max and level (of 255), pixels, flip_mean, flip_max. A limit
        is a number or a word of the program: {"max": 4, "pixels": "0-0.5%"}.
    ignore: boxes (x, y, width, height) in pixels from the top left that are not compared.
    mask: a picture as above, or an array of bool (height, width). Pixels where the mask is painted are not compared.
    pixels_per_degree: pixels per degree of view for FLIP, 1 to 1000.
    jobs: number of frames of films that are compared at a time, 1 to 1024; by default one for each CPU.
    limits: limits as for load(). Only the limit of memory has an effect.

    Returns a dictionary with these keys, among others: verdict ("identical", "near" or "different"), beyond (the limits
    that do not hold, in words), notes, differing_pixels, differing_share, max_difference, mean_difference and rmse (of
    255), psnr_db, ssim (mean, worst, worst_at), flip (mean, min, quartiles, max), change (in words), places,
    worst_pixels, limits. An undefined figure is None. reference and test are the paths, None for a picture in memory.
    For films, most of these are replaced by frames (the figures of each frame), worst_frame and film (where the films
    differ).

    Raises UsageError for pictures of different sizes, FileError, LimitError.
    """
    if not 1 <= _arguments.number("pixels_per_degree", pixels_per_degree) <= _MOST_PER_DEGREE:
        _arguments.refuse("pixels_per_degree", pixels_per_degree, f"must be a number from 1 to {_MOST_PER_DEGREE}")
    result: dict[str, Any] = json.loads(
        _core.diff(
            _source("reference", reference),
            _source("test", test),
            rule_words(rule),
            boxes_of(ignore),
            None if mask is None else _source("mask", _painted(mask)),
            float(pixels_per_degree),
            _arguments.jobs(jobs) or len(os.sched_getaffinity(0)),
            _arguments.limits(limits),
        )
    )
    for side, picture in (("reference", reference), ("test", test)):
        result[side] = result[side] if _is_path(picture) else None
    return result


def _is_path(it: Any) -> bool:
    return isinstance(it, (str, bytes, os.PathLike))


def boxes_of(boxes: Any) -> list[list[float]]:
    """Returns boxes of pixels that are not compared: left, top, width, height."""
    takes = "must be a list of boxes (x, y, width, height) in pixels"
    given = _entries(boxes)
    if given is None:
        _arguments.refuse("ignore", boxes, takes)
    found = []
    for box in given:
        sides = [_arguments.whole(side) for side in _entries(box) or ()]
        if len(sides) != 4 or None in sides:
            _arguments.refuse("ignore", boxes, takes)
        found.append([float(side or 0) for side in sides])
    return found


def _entries(it: Any) -> list[Any] | None:
    """Returns the entries of a list or an array; None for anything else."""
    if isinstance(it, np.ndarray):
        return list(it) if it.ndim and not _arguments.is_masked(it) else None
    return list(it) if isinstance(it, Sequence) and not isinstance(it, (str, bytes)) else None


def _source(side: str, it: Any) -> bytes | NDArray[Any]:
    """Returns a file's name as bytes, or pixels as an array with three axes."""
    if _is_path(it):
        path = _arguments.path(side, it)
        if os.path.isdir(path):
            raise UsageError(f"{side}: {path} is a folder; compare its pictures one by one")
        return os.fsencode(path)
    return pixels_of(side, it)


def pixels_of(side: str, it: Any) -> NDArray[Any]:
    """Returns the pixels of an array or a PIL image, with three axes. @param side: the argument, for messages"""
    array = _pil_pixels(side, it) if hasattr(it, "getbands") else _array(side, it)
    if array.dtype.kind != "u" or array.dtype.itemsize > 2:
        raise UsageError(
            f"{side}: expected samples of type uint8 or uint16, got {array.dtype}; convert them, for example by "
            "(255 * picture).round().astype(numpy.uint8)"
        )
    if array.ndim == 2:
        array = array[:, :, np.newaxis]
    if array.ndim != 3 or 0 in array.shape or array.shape[2] > 4:
        raise UsageError(f"{side}: shape {np.shape(it)}; expected (height, width) or (height, width, 1 to 4)")
    return np.ascontiguousarray(array, dtype=array.dtype.newbyteorder("="))


def _array(side: str, it: Any) -> NDArray[Any]:
    if not hasattr(it, "__array__") and not isinstance(it, Sequence):
        _arguments.refuse(side, it, "must be a path, an array of pixels or a PIL image")
    if _arguments.is_masked(it):
        raise UsageError(f"{side}: has masked values; give mask= the boolean array {side}.mask")
    try:
        return np.asarray(it)
    except (ValueError, TypeError, OverflowError):
        _arguments.refuse(side, it, "the rows of an array of pixels must have one length")


def _pil_pixels(side: str, image: Any) -> NDArray[Any]:
    """Returns the visible pixels of a PIL image."""
    if image.mode in ("P", "PA") or "transparency" in image.info:
        see_through = image.mode == "PA" or "transparency" in image.info
        return np.asarray(image.convert("RGBA" if see_through else "RGB"))
    if image.mode == "1":
        return np.asarray(image.convert("L"))
    pixels = np.asarray(image)
    if image.mode.startswith("I") and pixels.min() >= 0 and pixels.max() <= np.iinfo(np.uint16).max:
        return pixels.astype(np.uint16)  # PIL reads a grey PNG of 16 bits as 32-bit integers
    if image.mode in ("L", "LA", "RGB", "RGBA"):
        return pixels
    raise UsageError(f'{side}: a PIL image of mode {image.mode}; convert it, for example by convert("RGB")')


def _painted(mask: Any) -> Any:
    if isinstance(mask, np.ndarray) and mask.dtype == np.bool_:
        return mask.astype(np.uint8) * np.uint8(255)
    return mask


def rule_words(rule: str | Mapping[str, Any] | None) -> list[tuple[str, str]]:
    """Returns the keys and words of a rule as in a golden.toml."""
    if rule is None:
        return []
    if isinstance(rule, str):
        return [("like", _arguments.text("rule", rule, "must be a name"))]
    limits = _arguments.table("rule", rule, '{"max": 4, "pixels": "0-0.5%"}, or a name such as "same"')
    return [(key, _word(key, value)) for key, value in limits.items()]


def _word(key: str, value: Any) -> str:
    """Returns a limit in the notation of a golden.toml: a range from 0."""
    if isinstance(value, str):
        return _arguments.text(f"rule[{key!r}]", value, "must be a string")
    number = _arguments.whole(value)
    if number is None and _arguments.number(f"rule[{key!r}]", value) == 0:
        number = 0
    word = repr(float(value)) if number is None else repr(number)
    return word if key == "level" else f"0-{word}"
