# SPDX-License-Identifier: Apache-2.0
"""The program `poinsot`, which makes the files: with workers of its own, out of reach of the interpreter's threads."""

import json
import os
import shutil
import signal
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path

from ._errors import Error, FileError, RenderError, UsageError

_EXIT = {2: UsageError, 3: RenderError, 4: FileError}  # as the program's manual page has them


def path() -> str:
    """$POINSOT_PROGRAM, or that of this package, or the first on the path."""
    named = os.environ.get("POINSOT_PROGRAM")
    own = Path(__file__).with_name("program")
    found = named or (str(own) if own.exists() else shutil.which("poinsot"))
    if not found:
        raise FileError("the program poinsot is not installed, which makes films and figures")
    return found


def run(command: str, words: Sequence[str], progress: Callable[[int, int], object] | None = None) -> None:
    """Runs one of its commands to the end. `progress` is called with (done, total) frames.

    Ctrl-C, or whatever else `progress` raises, asks the program to stop and waits for it: what was complete is kept for
    resume=True.
    """
    said: list[str] = []
    # In a process group of its own: the Ctrl-C of a terminal reaches it once, through us.
    with subprocess.Popen(
        [path(), command, "--progress=json", *words],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        errors="replace",
        process_group=0,
    ) as process:
        assert process.stderr
        try:
            for line in process.stderr:
                event = _event(line)
                if event is None:
                    said.append(line)
                elif progress is not None:
                    progress(event["done"], event["total"])
        except BaseException:
            process.send_signal(signal.SIGINT)
            process.communicate()
            raise
    if process.returncode:
        raise _EXIT.get(process.returncode, Error)("".join(said).strip() or f"poinsot ended with {process.returncode}")


def _event(line: str) -> dict[str, int] | None:
    if not line.startswith("{"):
        return None
    event = json.loads(line)
    return {"done": event["done"], "total": event["total"]} if event.get("event") == "progress" else None
