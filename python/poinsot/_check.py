# SPDX-License-Identifier: Apache-2.0
"""Notes about a loaded scene, and estimates of the memory that its pictures take."""

import math
from typing import Any

from . import _core
from ._errors import Problem


def check(core: _core.Scene) -> dict[str, Any]:
    """Returns the dictionary of Scene.check()."""
    found = _core.checkup(core)
    problems, notes = (
        [Problem(one.file, one.line, one.column, one.message) for one in remarks]
        for remarks in (found.problems, found.notes)
    )
    estimates = {
        "frames": core.frame_count,
        "film_memory_bytes": math.ceil(found.film_memory),
        "picture_memory_bytes": math.ceil(found.picture_memory),
    }
    return {"ok": not problems, "problems": problems, "notes": notes, "estimates": estimates}
