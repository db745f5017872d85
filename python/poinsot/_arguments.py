# SPDX-License-Identifier: Apache-2.0
"""Checks of arguments. A value that a function does not accept raises UsageError, which names the accepted values."""

import decimal
import math
import numbers
import operator
import os
from collections.abc import Mapping, Sequence
from typing import Any, NoReturn

import numpy as np

from ._errors import UsageError

_LONGEST = 60  # characters of a value in a message
_MOST = 2**63 - 1  # largest integer of _core
_MOST_JOBS = 1024


def refuse(argument: str, it: object, takes: str) -> NoReturn:
    raise UsageError(f"{argument}={shown(it)}: {takes}")


def shown(it: object) -> str:
    """Returns the text of a value for a message: the value itself if it is plain and short, else its type."""
    text = _plain(it)
    if isinstance(it, (tuple, list)) and len(it) < _LONGEST:
        parts = ", ".join(_plain(one) or _type(one) for one in it)
        text = f"[{parts}]" if isinstance(it, list) else f"({parts})"
    return text if 0 < len(text) <= _LONGEST else _type(it)


def _plain(it: object) -> str:
    if isinstance(it, int) and it.bit_length() > 64:
        return ""
    if isinstance(it, (np.number, np.bool_)):  # np.float64 is a float, too
        return str(it)
    return repr(it) if it is None or isinstance(it, (bool, int, float, complex, str, bytes, range)) else ""


def _type(it: object) -> str:
    return f"<{type(it).__name__}>"


def whole(it: object) -> int | None:
    """Returns an integer of Python or NumPy as an int; None for anything else."""
    if isinstance(it, (bool, np.bool_)):
        return None
    try:
        number = operator.index(it)  # type: ignore[arg-type]
    except TypeError:
        return None
    return number if abs(number) <= _MOST else None


def pair(it: object) -> tuple[int, int] | None:
    """Returns two integers; None for anything else."""
    if not isinstance(it, (tuple, list)) and not (isinstance(it, np.ndarray) and it.ndim == 1):
        return None
    if len(it) != 2:
        return None
    first, second = whole(it[0]), whole(it[1])
    return None if first is None or second is None else (first, second)


def size(it: object) -> tuple[int, int] | None:
    if it is None:
        return None
    return pair(it) or refuse("size", it, "must be two integers, width and height in pixels: (1280, 720)")


def frames(it: object, count: int) -> tuple[int, int] | None:
    """Returns the first and the last frame."""
    if it is None:
        return None
    steps = isinstance(it, range) and it.step == 1 and len(it) > 0
    found = (it.start, it.stop - 1) if isinstance(it, range) and steps else pair(it)
    if found is None:
        refuse("frames", it, "must be the first and the last frame: (0, 9), or a range without gaps: range(0, 10)")
    first, last = found
    if first > last:
        refuse("frames", it, f"the first frame, {first}, comes after the last, {last}")
    if not (0 <= first and last < count):
        refuse("frames", it, f"the film has frames 0 to {count - 1}")
    return found


def flag(argument: str, it: object) -> bool:
    if not isinstance(it, (bool, np.bool_)):
        refuse(argument, it, "must be True or False")
    return bool(it)


def jobs(it: object) -> int | None:
    """Returns how many processes or threads work at a time; None if the function chooses the number."""
    if it is None:
        return None
    found = whole(it)
    return found if found is not None and 1 <= found <= _MOST_JOBS else refuse("jobs", it, f"must be 1 to {_MOST_JOBS}")


def function(argument: str, it: object) -> None:
    if it is not None and not callable(it):
        refuse(argument, it, "must be a function")


def bits(it: object) -> int:
    return 16 if whole(it) == 16 else 8 if whole(it) == 8 else refuse("bits", it, "must be 8 or 16")


def is_masked(it: object) -> bool:
    """Returns whether a value is an array that masks at least one of its elements."""
    return isinstance(it, np.ma.MaskedArray) and bool(np.any(it.mask))


def real(it: object) -> float | None:
    """Returns a real number as a float, infinite beyond the range of doubles; None for anything else.

    Booleans, text and timedelta64, which NumPy registers as an integer type, are not real numbers.
    """
    if isinstance(it, (bool, np.bool_, np.timedelta64)) or not isinstance(it, (numbers.Real, decimal.Decimal)):
        return None
    try:
        return float(it)
    except OverflowError:
        return math.inf
    except ValueError:  # a signalling NaN
        return math.nan


def number(argument: str, it: object) -> float:
    value = real(it)
    return value if value is not None and math.isfinite(value) else refuse(argument, it, "must be a finite number")


def text(argument: str, it: object, takes: str) -> str:
    """Returns a string of valid Unicode without NUL."""
    if not isinstance(it, str):
        refuse(argument, it, takes)
    if "\0" in it:
        refuse(argument, it, "must not contain NUL")
    try:
        it.encode()
    except UnicodeEncodeError:
        refuse(argument, it, "must not contain half of a surrogate pair")
    return str(it)


def path(argument: str, it: object) -> str:
    """Returns a path as text; os.fsdecode() keeps bytes that are not UTF-8."""
    try:
        name = os.fsdecode(it)  # type: ignore[arg-type]
        os.fsencode(name)
    except (TypeError, UnicodeEncodeError):
        refuse(argument, it, 'must be a path, such as "scenes/top.toml" or a pathlib.Path')
    if "\0" in name:
        refuse(argument, it, "must not contain NUL")
    return name


def stem(argument: str, it: object) -> str:
    """Returns the name of a file without folder and suffix."""
    name = text(argument, it, "must be a string")
    if not name or "/" in name:
        refuse(argument, it, 'must be a file name without folder and suffix, such as "top"')
    return name


def paths(argument: str, it: object) -> list[str]:
    if isinstance(it, (str, bytes, os.PathLike)) or not isinstance(it, Sequence):
        refuse(argument, it, 'must be a list of folders, such as ["meshes"]')
    return [path(f"{argument}[{i}]", one) for i, one in enumerate(it)]


def names(argument: str, it: object, example: str) -> list[str]:
    """Returns a list of strings. A single string is refused, because it is a sequence of its letters."""
    if isinstance(it, (str, bytes)) or not isinstance(it, Sequence):
        refuse(argument, it, f"must be a list of names, such as {example}")
    return [text(f"{argument}[{i}]", one, "must be a string") for i, one in enumerate(it)]


def table(argument: str, it: object, example: str) -> dict[str, Any]:
    """Returns a dictionary with strings as keys; an empty one for None."""
    if it is None:
        return {}
    if not isinstance(it, Mapping):
        refuse(argument, it, f"must be a dictionary, such as {example}")
    return {text(f"a key of {argument}", key, "must be a string"): value for key, value in it.items()}


def limits(it: object) -> list[str]:
    """Returns limits as words for the program, such as "side=16384"."""
    given = table("limits", it, '{"side": 16384, "memory": "4 GiB"}')
    return [f"{name}={_limit(f'limits[{shown(name)}]', most)}" for name, most in given.items()]


def _limit(argument: str, most: object) -> str:
    if isinstance(most, str):
        return text(argument, most, "must be a string")
    number = whole(most)
    return refuse(argument, most, 'must be an integer, or a size such as "4 GiB"') if number is None else str(number)
