# SPDX-License-Identifier: Apache-2.0
"""Times that a caller gives, as seconds."""

import datetime
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arguments import real, shown
from ._errors import UsageError

#: A time of a function's argument: in s, or with a unit.
Time = float | datetime.timedelta | np.timedelta64
Times = ArrayLike | datetime.timedelta | Sequence[datetime.timedelta]

# Of timedelta64: how many seconds a unit has, or how many units a second.
_UNITS = {"W": (604800, 1), "D": (86400, 1), "h": (3600, 1), "m": (60, 1), "s": (1, 1)}
_UNITS |= {unit: (1, 1000**power) for power, unit in enumerate(("ms", "us", "ns", "ps", "fs", "as"), 1)}


def times(argument: str, it: Any) -> NDArray[np.float64]:
    """An array of its own with times in s, all finite, in the shape of `it`.

    Raises UsageError for what is no time, naming `argument` and the index.
    """
    given = _array(argument, it)
    seconds = _seconds(argument, given)
    _require(argument, np.isfinite(seconds), lambda index: f"{shown(given[index])}: a time is a finite number of seconds")
    return seconds


def has_unit(it: object) -> bool:
    """Whether it is a length of time that has its own unit."""
    return isinstance(it, (datetime.timedelta, np.timedelta64))


def span(it: Any) -> tuple[float, float] | None:
    """The first and the last time of a span."""
    if it is None:
        return None
    ends = times("span", it)
    if ends.shape != (2,) or ends[0] > ends[1]:
        raise UsageError(f"span={shown(it)}: a span is a pair, the first motion time and the last: (0, 100)")
    return float(ends[0]), float(ends[1])


def film_times(argument: str, it: Any, duration: float) -> NDArray[np.float64]:
    """As times(), from 0 to the film's duration."""
    t = times(argument, it)
    inside = (t >= 0) & (t <= duration)
    _require(argument, inside, lambda index: f"{t[index]:.12g} s: the film lasts from 0 to {duration:g} s")
    return t


def film_time(argument: str, it: Any, duration: float) -> float:
    """One time of a film."""
    t = film_times(argument, it, duration)
    if t.ndim:
        raise UsageError(f"{argument}: one time is wanted, got an array of shape {t.shape}")
    return float(t)


def _array(argument: str, it: Any) -> NDArray[Any]:
    try:
        given = np.asarray(it)
    except (ValueError, TypeError, OverflowError):
        _refuse(argument, it)
    if isinstance(it, np.ma.MaskedArray):
        unmasked = ~np.broadcast_to(it.mask, given.shape)
        _require(argument, unmasked, lambda _: "masked: choose the times with .compressed()")
    if given.dtype.kind in "iuf" and (hasattr(it, "units") or hasattr(it, "unit")):
        raise UsageError(f"{argument}: {type(it).__name__} has a unit of its own; convert it to plain seconds")
    return given


def _seconds(argument: str, given: NDArray[Any]) -> NDArray[np.float64]:
    kind = given.dtype.kind
    if kind in "iuf" or given.size == 0:
        with np.errstate(over="ignore"):  # of long doubles; refused as infinite
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
        raise UsageError(f"{argument}: a timedelta64 without a unit that has a length in seconds ({unit})")
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
    """Raises for the first that is not good."""
    if not good.all():
        index = tuple(int(i) for i in np.argwhere(~good)[0])
        raise UsageError(f"{_at(argument, index)} = {why(index)}")


def _at(argument: str, index: tuple[int, ...]) -> str:
    return f"{argument}[{', '.join(map(str, index))}]" if index else argument


def _refuse(argument: str, it: Any) -> NoReturn:
    what = f"an array of {it.dtype}" if isinstance(it, np.ndarray) else shown(it)
    raise UsageError(f"{argument}: a time is a number of seconds, or a timedelta; got {what}")
