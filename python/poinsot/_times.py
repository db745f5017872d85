# SPDX-License-Identifier: Apache-2.0
"""Conversion of a caller's times to seconds."""

import datetime
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arguments import real, shown
from ._errors import UsageError

#: Time as an argument: a number in s, or a value with a unit.
Time = float | datetime.timedelta | np.timedelta64
Times = ArrayLike | datetime.timedelta | Sequence[datetime.timedelta]

# Units of timedelta64: seconds per unit, and units per second.
_UNITS = {"W": (604800, 1), "D": (86400, 1), "h": (3600, 1), "m": (60, 1), "s": (1, 1)}
_UNITS |= {unit: (1, 1000**power) for power, unit in enumerate(("ms", "us", "ns", "ps", "fs", "as"), 1)}


def times(argument: str, it: Any) -> NDArray[np.float64]:
    """Returns a new array of finite times in s, in the shape of `it`.

    Raises UsageError for a value that is not a time; the message names `argument` and the index.
    """
    given = _array(argument, it)
    seconds = _seconds(argument, given)
    _require(argument, np.isfinite(seconds), lambda index: f"{shown(given[index])}: a time is a finite number of seconds")
    return seconds


def has_unit(it: object) -> bool:
    """Returns whether a value is a duration with its own unit."""
    return isinstance(it, (datetime.timedelta, np.timedelta64))


def span(it: Any) -> tuple[float, float] | None:
    """Returns the first and the last time of a span."""
    if it is None:
        return None
    ends = times("span", it)
    if ends.shape != (2,) or ends[0] > ends[1]:
        raise UsageError(f"span={shown(it)}: must be two times, the first and the last motion time, such as (0, 100)")
    return float(ends[0]), float(ends[1])


def film_times(argument: str, it: Any, duration: float) -> NDArray[np.float64]:
    """Returns film times like times(). Each must be from 0 to the film's duration."""
    t = times(argument, it)
    inside = (t >= 0) & (t <= duration)
    _require(argument, inside, lambda index: f"{t[index]:.12g} s: the film lasts from 0 to {duration:g} s")
    return t


def film_time(argument: str, it: Any, duration: float) -> float:
    """Returns one film time."""
    t = film_times(argument, it, duration)
    if t.ndim:
        raise UsageError(f"{argument}: expected one time, got an array of shape {t.shape}")
    return float(t)


def _array(argument: str, it: Any) -> NDArray[Any]:
    try:
        given = np.asarray(it)
    except (ValueError, TypeError, OverflowError):
        _refuse(argument, it)
    if isinstance(it, np.ma.MaskedArray):
        unmasked = ~np.broadcast_to(it.mask, given.shape)
        _require(argument, unmasked, lambda _: "masked: select the valid times with .compressed()")
    if given.dtype.kind in "iuf" and (hasattr(it, "units") or hasattr(it, "unit")):
        raise UsageError(f"{argument}: {type(it).__name__} has a unit of its own; convert it to plain seconds")
    return given


def _seconds(argument: str, given: NDArray[Any]) -> NDArray[np.float64]:
    kind = given.dtype.kind
    if kind in "iuf" or given.size == 0:
        with np.errstate(over="ignore"):  # long doubles; rejected later as infinite
            return given.astype(np.float64, order="C")
    if kind == "m":
        return _of_timedeltas(argument, given)
    if kind == "O":
        return _of_objects(argument, given)
    _refuse(argument, given)


def _of_timedeltas(argument: str, given: NDArray[Any]) -> NDArray[np.float64]:
    unit, count = np.datetime_data(given.dtype)
    if np.isnat(given).all():
        return np.full(given.shape, np.nan)
    if unit not in _UNITS:
        raise UsageError(f"{argument}: a timedelta64 needs a unit with a fixed length in seconds, got {unit}")
    lengths = given.astype(np.int64).astype(np.float64) * count
    long, per_second = _UNITS[unit]
    return np.where(np.isnat(given), np.nan, lengths * long / per_second)


def _of_objects(argument: str, given: NDArray[Any]) -> NDArray[np.float64]:
    seconds = np.empty(given.shape)
    for index, it in np.ndenumerate(given):
        seconds[index] = _of_object(_at(argument, index), it)
    return seconds


def _of_object(argument: str, it: Any) -> float:
    if isinstance(it, datetime.timedelta):
        return float(it.total_seconds())
    if isinstance(it, (np.generic, np.ndarray)):
        return float(times(argument, it)) if np.ndim(it) == 0 else _refuse(argument, it)
    seconds = real(it)
    return _refuse(argument, it) if seconds is None else seconds


def _require(argument: str, good: NDArray[np.bool_], why: Callable[[tuple[int, ...]], str]) -> None:
    """Raises UsageError for the first element that is not good."""
    if not good.all():
        index = tuple(int(i) for i in np.argwhere(~good)[0])
        raise UsageError(f"{_at(argument, index)} = {why(index)}")


def _at(argument: str, index: tuple[int, ...]) -> str:
    return f"{argument}[{', '.join(map(str, index))}]" if index else argument


def _refuse(argument: str, it: Any) -> NoReturn:
    what = f"an array of {it.dtype}" if isinstance(it, np.ndarray) else shown(it)
    raise UsageError(f"{argument}: a time is a number of seconds, or a timedelta; got {what}")
