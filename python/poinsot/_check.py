# SPDX-License-Identifier: Apache-2.0
"""Notes about a loaded scene, and estimates of the memory that its pictures take."""

import math
from typing import Any

from . import _core, _places
from ._errors import Problem


def check(core: _core.Scene, file: str, places: _places.Places) -> dict[str, Any]:
    """Returns the dictionary of Scene.check().

    places: keys of the lines of the file, if the scene is given as a dictionary; otherwise empty.
    """
    found = _core.checkup(core)
    problems, notes = (
        [_places.placed(Problem(one.file, one.line, one.column, one.message), file, places) for one in remarks]
        for remarks in (found.problems, found.notes)
    )
    estimates = {
        "frames": core.frame_count,
        "film_memory_bytes": math.ceil(found.film_memory),
        "picture_memory_bytes": math.ceil(found.picture_memory),
    }
    return {"ok": not problems, "problems": problems, "notes": notes, "estimates": estimates}
