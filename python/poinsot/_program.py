# SPDX-License-Identifier: Apache-2.0
"""The program `poinsot`, which makes the files: with workers of its own, out of reach of the interpreter's threads."""

import errno
import glob
import json
import os
import re
import shutil
import signal
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from ._errors import Error, FileError, in_python, made, says_limit

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
    failure: dict[str, Any] = {}
    with _started([command, "--progress=json", "-o", place, *words]) as process:
        assert process.stderr
        try:
            for line in process.stderr:
                event = _event(line)
                if event is None:
                    said.append(line)
                elif event["event"] == "failed":
                    failure = event
                elif progress is not None:
                    progress(event["done"], event["total"])
        except BaseException:
            process.send_signal(signal.SIGINT)
            process.communicate()
            raise
    if process.returncode:
        raise _error(process.returncode, "".join(said), failure)
    if not _is_there(output):
        raise FileError(f"{output}: {_found()[1]} ended well and did not write it", errno.ENOENT, output)


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


def _error(status: int, said: str, failure: dict[str, Any]) -> Error:
    """The error of a program that ended so. `failure` is empty, or the event of which file made it fail."""
    text = in_python(re.sub(r"^poinsot: (error: )?", "", said, flags=re.MULTILINE)).strip()
    match status:  # as the program's manual page has them
        case 2:
            return made("limit" if says_limit(text) else "usage", text)
        case 3:
            return made("render", text)
        case 4:
            name = os.fsdecode(failure["file"].encode("latin-1")) if failure else None  # a character for each byte
            return made("file", text, number=failure.get("errno", 0), filename=name)
    return Error(text or f"the program ended with {status}")


def _event(line: str) -> dict[str, Any] | None:
    """An event that the program reports on a line of its own; None for a line of text."""
    return json.loads(line) if line.startswith("{") else None


def _is_there(output: str) -> bool:
    """Whether there is such a file, or a picture of such a sequence."""
    around = re.split(r"\{frame(?::0\d)?\}", output)
    return os.path.exists(output) if len(around) == 1 else bool(glob.glob("*".join(map(glob.escape, around))))
