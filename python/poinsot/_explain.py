# SPDX-License-Identifier: Apache-2.0
"""What the names of a scene file mean."""

from . import _arguments, _core


def explain(name: str = "") -> dict[str, dict[str, str]]:
    """Explains a name of a scene file, as `poinsot explain` does.

    name: a key ("camera.fov", or "fov" for all keys of that name), a table ("camera"), a shape, a body of the
        catalogue, a quantity or a unit; "units" for all units; without one, all tables.

    Returns a dictionary from each title to its rows: of a key help, takes, units, default and example; of a table its
    keys. Raises UsageError for any other word, with the nearest one.
    """
    explained = {}
    for title, text, rows in _core.explain(_arguments.text("name", name, 'a name, as "camera.fov"')):
        explained[title] = ({"help": text} if text else {}) | dict(rows)
    return explained
