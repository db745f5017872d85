# SPDX-License-Identifier: Apache-2.0
"""The program `poinsot`, which makes the files: with workers of its own, out of reach of the interpreter's threads."""

import json
import os
import re
import shutil
import signal
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path

from ._errors import Error, FileError, cannot_write, in_python, made, says_limit

_VARIABLE = "POINSOT_PROGRAM"


def _found() -> tuple[str, str]:
    """The program, and what it is called in messages."""
    named = os.environ.get(_VARIABLE)
    if named:
        return named, f"{_VARIABLE}={named}"
    own = Path(__file__).with_name("program")
    found = str(own) if own.exists() else shutil.which("poinsot")
    if not found:
        raise FileError(f"the program poinsot, which makes films and figures, is not installed; set {_VARIABLE}")
    return found, f"the program {found}"


def run(
    command: str,
    output: str,
    words: Sequence[str],
    progress: Callable[[int, int], object] | None = None,
) -> None:
    """Runs one of its commands, which makes the file `output`, to the end. Calls `progress` with (done, total) frames.

    Ctrl-C, and whatever `progress` raises, makes the program stop, and is raised when it has: what was complete is kept
    for resume=True.
    """
    # A word that begins with "-" would be an option.
    place = os.path.join(".", output) if output.startswith("-") else output
    said: list[str] = []
    with _started([command, "--progress=json", "-o", place, *words]) as process:
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
        raise _failure(process.returncode, "".join(said), output)


def _started(words: Sequence[str]) -> subprocess.Popen[str]:
    program, called = _found()
    try:
        # In a process group of its own: the Ctrl-C of a terminal reaches it once, through us.
        return subprocess.Popen(
            [program, *words],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            errors="replace",
            process_group=0,
        )
    except OSError as error:
        raise FileError(f"{called}: cannot be started: {error.strerror}", error.errno, program) from error


def _failure(status: int, said: str, output: str) -> Error:
    text = in_python(re.sub(r"^poinsot: (error: )?", "", said, flags=re.MULTILINE)).strip()
    match status:  # as the program's manual page has them
        case 2:
            return made("limit" if says_limit(text) else "usage", text)
        case 3:
            return made("render", text)
        case 4:
            return cannot_write(text, output)
    return Error(text or f"the program ended with {status}")


def _event(line: str) -> dict[str, int] | None:
    if not line.startswith("{"):
        return None
    event = json.loads(line)
    return {"done": event["done"], "total": event["total"]} if event.get("event") == "progress" else None
