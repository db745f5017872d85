# SPDX-License-Identifier: Apache-2.0
"""Python values as TOML, which the standard library only reads."""

import json
import math
import numbers
from collections.abc import Mapping
from typing import Any

import numpy as np

from ._errors import UsageError


def value(it: Any) -> str:
    """A value on one line: booleans, numbers, texts, and lists, arrays and dictionaries of them."""
    if isinstance(it, (bool, np.bool_)):
        return "true" if it else "false"
    if isinstance(it, numbers.Integral):
        return str(int(it))
    if isinstance(it, numbers.Real):
        return _number(float(it))
    if isinstance(it, str):
        return _text(it)
    if isinstance(it, Mapping):
        return "{" + ", ".join(f"{_key(name)} = {value(of)}" for name, of in it.items()) + "}"
    if isinstance(it, (list, tuple, np.ndarray)):
        return "[" + ", ".join(value(one) for one in it) + "]"
    raise UsageError(f"a scene has no values of the type {type(it).__name__}")


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
    """As after -D."""
    return f"{key}={value(it)}"


def _number(it: float) -> str:
    if math.isnan(it):
        return "nan"
    if math.isinf(it):
        return "inf" if it > 0 else "-inf"
    return repr(it)


def _text(it: str) -> str:
    return json.dumps(it, ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(name: object) -> str:
    if not isinstance(name, str):
        raise UsageError(f"the key {name!r} is no text")
    bare = name.isascii() and name.replace("_", "").replace("-", "").isalnum()
    return name if bare else _text(name)
