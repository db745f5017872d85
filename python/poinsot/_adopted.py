# SPDX-License-Identifier: Apache-2.0
"""Reads the marks of pytest-mpl 0.11 to 0.17: where a baseline is, and how a figure is drawn and compared."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ._diff import rule_words
from ._errors import UsageError
from ._golden_settings import Settings, settings_of

_TOLERANCE = 2.0  # pytest-mpl's default
_UNSUPPORTED = {
    "hash_library": "hashes of pictures are not read; approve pictures instead: pytest --golden-update",
}


def adopted(item: Any) -> Settings | None:
    """Returns the settings of a test that is marked for pytest-mpl; None for other tests.

    A limit of the marker `golden` beside it replaces pytest-mpl's tolerance.
    """
    mark = item.get_closest_marker("mpl_image_compare")
    if mark is None:
        return None
    given = dict(mark.kwargs)
    for key, reason in _UNSUPPORTED.items():
        if given.get(key) is not None:
            raise UsageError(f"mpl_image_compare: {key}: {reason}")
    own = item.get_closest_marker("golden")
    rule = item.config.getini("golden_rule")
    settings = settings_of(own.kwargs, rule) if own else Settings({"like": rule}, rule_words({"like": rule}))
    if own is None:
        settings.tolerance = float(given.get("tolerance", _setting(item.config, "mpl-default-tolerance") or _TOLERANCE))
    settings.baseline = _folder(item, given) / _file_name(item, given)
    settings.save = given.get("savefig_kwargs") or {}
    settings.style = given.get("style") or _setting(item.config, "mpl-default-style") or "classic"
    settings.backend = given.get("backend") or _setting(item.config, "mpl-default-backend") or "agg"
    settings.remove_text = bool(given.get("remove_text", False))
    return settings


def _setting(config: Any, name: str) -> str:
    """Returns a setting of pytest-mpl, also if pytest-mpl is not installed."""
    try:
        value = config.getini(name)
    except ValueError:
        value = config.inicfg.get(name, "")
    return str(getattr(value, "value", value) or "")


def _folder(item: Any, given: dict[str, Any]) -> Path:
    folder = given.get("baseline_dir")
    if folder is None:
        named = getattr(item.config.option, "mpl_baseline_path", None) or _setting(item.config, "mpl-baseline-path")
        if named and not getattr(item.config.option, "mpl_baseline_relative", False):
            folder = Path(item.config.invocation_params.dir) / named
        else:
            folder = named or "baseline"
    if str(folder).startswith(("http://", "https://")):
        raise UsageError(f"mpl_image_compare: baseline_dir={folder!r}: baselines are not downloaded; copy them beside the tests")
    return Path(item.path).parent / folder


def _file_name(item: Any, given: dict[str, Any]) -> str:
    """Returns the name that pytest-mpl gives to a baseline: brackets and slashes become underscores."""
    if _setting(item.config, "mpl-use-full-test-name").lower() in ("true", "1", "yes", "on"):
        of_class = f".{item.cls.__name__}" if item.cls is not None else ""
        name = f"{item.module.__name__}{of_class}.{item.name}.png"
    else:
        name = given.get("filename") or f"{item.name}.png"
    stem = str(name).split(".png")[0]
    for special in "[]/":
        stem = stem.replace(special, "_")
    return f"{stem.removesuffix('_')}.png"
