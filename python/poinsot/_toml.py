# SPDX-License-Identifier: Apache-2.0
"""Conversion of Python values to TOML, which the standard library cannot write."""

import json
import math
import numbers
import os
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _times
from ._arguments import is_masked, path, real, refuse, shown, text
from ._errors import UsageError

_MOST_INTEGER = 2**63 - 1  # largest integer of TOML
_TAKES = "a scene accepts booleans, numbers, strings, times, and lists and tables of these"


def value(place: str, it: Any) -> str:
    """Returns a value as TOML on one line. Accepts booleans, numbers, strings, paths, times with a unit, and lists,
    arrays, pandas Series and dictionaries of these.

    place: place of the value for messages, such as "motion.omega_body[1]".
    """
    if isinstance(it, (bool, np.bool_)):
        return "true" if it else "false"
    if isinstance(it, str):
        return _text(place, it)
    if isinstance(it, os.PathLike):
        return _text(place, path(place, it))
    if _times.has_unit(it):
        return _text(place, f"{float(_times.times(place, it))!r} s")
    if (number := real(it)) is not None:
        return _number(place, it, number)
    if isinstance(it, Mapping):
        inner = (f"{_key(place, name)} = {value(f'{place}.{name}', of)}" for name, of in it.items())
        return "{" + ", ".join(inner) + "}"
    elements = _elements(place, it)
    if isinstance(elements, np.ndarray) and elements.ndim == 0:
        return value(place, elements[()])
    return "[" + ", ".join(value(f"{place}[{i}]", one) for i, one in enumerate(elements)) + "]"


def scene_text(source: object) -> str:
    """Returns the text of a scene that is given as text or as tables."""
    if isinstance(source, str):
        return text("source", source, "must be a string")
    if not isinstance(source, Mapping):
        refuse("source", source, "must be text in TOML, or a dictionary of tables")
    try:
        return document(source)
    except RecursionError:
        raise UsageError("source: a table or a list contains itself") from None


def document(tables: Mapping[str, Any]) -> str:
    """Returns a dictionary of tables as a scene file, with one line for each key."""
    return "\n".join(line for line, _ in _lines(tables)) + "\n"


def places(tables: Mapping[str, Any]) -> tuple[tuple[str, ...], ...]:
    """Returns the keys by which each line of document() is found in the dictionary, such as ("motion", "spin")."""
    return tuple(keys for _, keys in _lines(tables))


def _lines(tables: Mapping[str, Any]) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yields the lines of a document, each with its keys in the dictionary."""
    plain = {name: it for name, it in tables.items() if not isinstance(it, Mapping)}
    for name, it in plain.items():
        yield _line("", name, it), (name,)
    for name, table in tables.items():
        if name not in plain:
            yield f"[{_key('source', name)}]", (name,)
            for key, it in table.items():
                yield _line(f"{name}.", key, it), (name, key)


def override(key: str, it: Any) -> str:
    """Returns the override that sets one key of a scene, such as "style.theme=\"dark\""."""
    if not key or "=" in key:
        raise UsageError(f"overrides: {key!r} is not a key of a scene; a key is a string such as \"style.theme\"")
    try:
        return f"{key}={value(key, it)}"
    except RecursionError:
        raise UsageError(f"{key}: a table or a list contains itself") from None


def overridden(words: Iterable[str]) -> dict[str, Any]:
    """Returns the keys and values of overrides."""
    parts = (word.partition("=") for word in words)
    return {key: tomllib.loads(f"it = {it}")["it"] for key, _, it in parts}


def _line(table: str, key: object, it: Any) -> str:
    return f"{_key(table.rstrip('.') or 'source', key)} = {value(f'{table}{key}', it)}"


def _elements(place: str, it: Any) -> Sequence[Any] | NDArray[Any]:
    """Converts a list, an array or a pandas Series to a list or a plain array."""
    if isinstance(it, (list, tuple)):
        return it
    if is_masked(it):
        raise UsageError(f"{place}: has masked values, which a scene cannot contain; fill them or leave them out")
    if hasattr(it, "to_numpy"):  # a pandas object, tested without importing pandas
        it = it.to_numpy()
    if not isinstance(it, np.ndarray):
        refuse(place, it, _TAKES)
    return np.asarray(it)  # also converts a masked array without masked values


def _number(place: str, it: Any, number: float) -> str:
    if isinstance(it, numbers.Integral) and abs(int(it)) <= _MOST_INTEGER:
        return str(int(it))
    if math.isnan(number):
        return "nan"
    if math.isinf(number):
        if not isinstance(it, (float, np.floating)):
            refuse(place, it, "is beyond the range of doubles")
        return "inf" if number > 0 else "-inf"
    return repr(number)


def _text(place: str, it: str) -> str:
    return json.dumps(text(place, it, ""), ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(place: str, name: object) -> str:
    if not isinstance(name, str):
        raise UsageError(f"{place}: the key {shown(name)} is not a string")
    bare = name.isascii() and name.replace("_", "").replace("-", "").isalnum()
    return name if bare else _text(f"a key of {place}", name)
