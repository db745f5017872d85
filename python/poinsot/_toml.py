# SPDX-License-Identifier: Apache-2.0
"""Python values as TOML, which the standard library only reads."""

import json
import math
import numbers
import tomllib
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ._arguments import refuse, shown, text
from ._errors import UsageError

_MOST_BITS = 1000  # Python writes no integer of 14000


def value(it: Any) -> str:
    """A value on one line: booleans, numbers, texts, and lists, arrays and dictionaries of them."""
    if isinstance(it, (bool, np.bool_)):
        return "true" if it else "false"
    if isinstance(it, numbers.Integral):
        return _integer(int(it))
    if isinstance(it, numbers.Real):
        return _number(it)
    if isinstance(it, str):
        return _text(it)
    if isinstance(it, Mapping):
        return "{" + ", ".join(f"{_key(name)} = {value(of)}" for name, of in it.items()) + "}"
    if isinstance(it, np.ndarray) and it.ndim == 0:
        return value(it[()])
    if isinstance(it, (list, tuple, np.ndarray)):
        return "[" + ", ".join(value(one) for one in it) + "]"
    raise UsageError(f"a scene has no values of the type {type(it).__name__}")


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
        lines.append(f"{_key(name)} = {value(it)}")
    for name, table in tables.items():
        if name not in plain:
            lines += [f"[{_key(name)}]", *(f"{_key(key)} = {value(it)}" for key, it in table.items())]
    return "\n".join(lines) + "\n"


def override(key: str, it: Any) -> str:
    """A word that sets one key of a scene."""
    if not key or "=" in key:
        raise UsageError(f"overrides: {key!r} is no key of a scene; a key is a text such as \"style.theme\"")
    try:
        return f"{key}={value(it)}"
    except RecursionError:
        raise UsageError(f"overrides[{key!r}]: a table or a list that holds itself") from None


def overridden(words: Iterable[str]) -> dict[str, Any]:
    """Keys and values of such words."""
    parts = (word.partition("=") for word in words)
    return {key: tomllib.loads(f"it = {it}")["it"] for key, _, it in parts}


def _integer(it: int) -> str:
    if it.bit_length() > _MOST_BITS:
        raise UsageError(f"a number of {it.bit_length()} bits is no value of a scene")
    return str(it)


def _number(it: numbers.Real) -> str:
    try:
        number = float(it)
    except OverflowError:
        raise UsageError("a number beyond the range of doubles is no value of a scene") from None
    if math.isnan(number):
        return "nan"
    if math.isinf(number):
        return "inf" if number > 0 else "-inf"
    return repr(number)


def _text(it: str) -> str:
    text("a text of a scene", it, "")
    return json.dumps(it, ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(name: object) -> str:
    if not isinstance(name, str):
        raise UsageError(f"the key {shown(name)} is no text")
    bare = name.isascii() and name.replace("_", "").replace("-", "").isalnum()
    return name if bare else _text(name)
