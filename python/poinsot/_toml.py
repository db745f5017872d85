# SPDX-License-Identifier: Apache-2.0
"""Python values as TOML, which the standard library only reads."""

import json
import math
import numbers
import os
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _times
from ._arguments import is_masked, path, real, refuse, shown, text
from ._errors import UsageError

_MOST_INTEGER = 2**63 - 1  # of TOML
_TAKES = "a scene has truth values, numbers, texts, times, and lists and tables of them"


def value(place: str, it: Any) -> str:
    """A value on one line. Takes truth values, numbers, texts, paths, times with a unit, and lists, arrays, pandas
    Series and dictionaries of them.

    place: what the value is of, for messages: "motion.omega_body[1]".
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
    """A scene as text or as tables, as a text."""
    if isinstance(source, str):
        return text("source", source, "a text")
    if not isinstance(source, Mapping):
        refuse("source", source, "a text in TOML, or a dictionary of tables")
    try:
        return document(source)
    except RecursionError:
        raise UsageError("source: a table or a list that holds itself") from None


def document(tables: Mapping[str, Any]) -> str:
    """A dictionary of tables as a scene file: a table has its keys on lines of their own."""
    lines = []
    plain = {name: it for name, it in tables.items() if not isinstance(it, Mapping)}
    for name, it in plain.items():
        lines.append(_line("", name, it))
    for name, table in tables.items():
        if name not in plain:
            lines.append(f"[{_key('source', name)}]")
            lines += [_line(f"{name}.", key, it) for key, it in table.items()]
    return "\n".join(lines) + "\n"


def override(key: str, it: Any) -> str:
    """A word that sets one key of a scene."""
    if not key or "=" in key:
        raise UsageError(f"overrides: {key!r} is no key of a scene; a key is a text such as \"style.theme\"")
    try:
        return f"{key}={value(key, it)}"
    except RecursionError:
        raise UsageError(f"{key}: a table or a list that holds itself") from None


def overridden(words: Iterable[str]) -> dict[str, Any]:
    """Keys and values of such words."""
    parts = (word.partition("=") for word in words)
    return {key: tomllib.loads(f"it = {it}")["it"] for key, _, it in parts}


def _line(table: str, key: object, it: Any) -> str:
    return f"{_key(table.rstrip('.') or 'source', key)} = {value(f'{table}{key}', it)}"


def _elements(place: str, it: Any) -> Sequence[Any] | NDArray[Any]:
    """A list, an array or a pandas Series as a list or a plain array."""
    if isinstance(it, (list, tuple)):
        return it
    if is_masked(it):
        raise UsageError(f"{place}: has masked values, which a scene has not; fill them or leave them out")
    if hasattr(it, "to_numpy"):  # of pandas, without importing it
        it = it.to_numpy()
    if not isinstance(it, np.ndarray):
        refuse(place, it, _TAKES)
    return np.asarray(it)  # also of a masked one whose mask masks nothing


def _number(place: str, it: Any, number: float) -> str:
    if isinstance(it, numbers.Integral) and abs(int(it)) <= _MOST_INTEGER:
        return str(int(it))
    if math.isnan(number):
        return "nan"
    if math.isinf(number):
        if not isinstance(it, (float, np.floating)):
            refuse(place, it, "a number beyond the range of doubles")
        return "inf" if number > 0 else "-inf"
    return repr(number)


def _text(place: str, it: str) -> str:
    return json.dumps(text(place, it, ""), ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(place: str, name: object) -> str:
    if not isinstance(name, str):
        raise UsageError(f"{place}: the key {shown(name)} is no text")
    bare = name.isascii() and name.replace("_", "").replace("-", "").isalnum()
    return name if bare else _text(f"a key of {place}", name)
