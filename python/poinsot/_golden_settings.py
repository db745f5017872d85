# SPDX-License-Identifier: Apache-2.0
"""Arguments of the marker and the fixture `golden`."""

from __future__ import annotations

import difflib
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from . import _arguments, _core
from ._diff import boxes_of, rule_words
from ._errors import UsageError

_LIMITS = ("max", "pixels", "flip_mean", "flip_max", "level")
_EXCEPTIONS = (*_LIMITS, "ignore", "mask")  # these let more through than a named rule, so they need a reason
_KEYS = ("rule", "name", *_EXCEPTIONS, "reason", "save", "time", "size")


@dataclass
class Settings:
    """How a picture is saved and compared."""

    rule: Mapping[str, Any]
    words: list[tuple[str, str]]  # the rule in the notation of a golden.toml
    ignore: list[list[float]] = field(default_factory=list)
    mask: bytes = b""
    name: str | None = None
    save: Mapping[str, Any] = field(default_factory=dict)  # arguments of Matplotlib's savefig()
    time: Any = None  # film time of a scene
    size: Any = None  # size of a scene's picture
    baseline: Path | None = None  # file of the baseline, if another plugin names it
    tolerance: float | None = None  # limit of pytest-mpl for the root mean square, of 255
    style: Any = "default"  # style of Matplotlib
    backend: str = "agg"
    remove_text: bool = False

    @property
    def boxes(self) -> list[tuple[int, int, int, int]]:
        """Returns the ignored boxes as diff() takes them."""
        return [(int(left), int(top), int(width), int(height)) for left, top, width, height in self.ignore]


def settings_of(given: Mapping[str, Any], rule: str) -> Settings:
    """Checks the arguments of the marker and the fixture. @param rule: the rule if none is given"""
    for key in given:
        if key not in _KEYS:
            near = difflib.get_close_matches(key, _KEYS, n=1)
            hint = f"did you mean {near[0]}?" if near else f"the keys are {', '.join(_KEYS)}"
            raise UsageError(f"golden: unknown argument {key!r}; {hint}")
    limits = _limits(given, rule)
    exceptions = [key for key in _EXCEPTIONS if key in given] or (["rule"] if isinstance(given.get("rule"), Mapping) else [])
    if exceptions and not _text(given, "reason"):
        raise UsageError(f"golden: {exceptions[0]} needs a reason: reason='why the picture may differ there'")
    save = given.get("save", {})
    if not isinstance(save, Mapping):
        _arguments.refuse("golden: save", save, "must be a dictionary with arguments of savefig(): {'dpi': 100}")
    words, ignore = rule_words(limits), boxes_of(given.get("ignore", ()))
    _core.check_rule(words, ignore)
    return Settings(
        rule=limits,
        words=words,
        ignore=ignore,
        mask=os.fsencode(given["mask"]) if "mask" in given else b"",
        name=_text(given, "name"),
        save=save,
        time=given.get("time"),
        size=given.get("size"),
    )


def _limits(given: Mapping[str, Any], rule: str) -> dict[str, Any]:
    base = given.get("rule", rule)
    limits = {"like": base} if isinstance(base, str) else dict(_arguments.table("golden: rule", base, '{"max": 4}, or a name such as "same"'))
    return {**limits, **{key: given[key] for key in _LIMITS if key in given}}


def _text(given: Mapping[str, Any], key: str) -> str | None:
    value = given.get(key)
    if value is not None and (not isinstance(value, str) or not value.strip()):
        _arguments.refuse(f"golden: {key}", value, "must be a text")
    return value
