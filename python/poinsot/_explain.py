# SPDX-License-Identifier: Apache-2.0
"""Explanations of the names in a scene file."""

from . import _arguments, _core


def explain(name: str = "") -> dict[str, dict[str, str]]:
    """Explains a name of a scene file, as `poinsot explain` does.

    name: a key ("camera.fov", or "fov" for all keys of that name), a table ("camera"), a shape, a body of the
        catalogue, a quantity or a unit; "units" for all units; without a name, all tables.

    Returns a dictionary from each title to its rows. The rows of a key are help, takes, units, default and example; the
    rows of a table are its keys. Raises UsageError for any other word; the message suggests the nearest word.
    """
    explained = {}
    for title, text, rows in _core.explain(_arguments.text("name", name, 'must be a name, such as "camera.fov"')):
        explained[title] = ({"help": text} if text else {}) | dict(rows)
    return explained
