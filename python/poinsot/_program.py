# SPDX-License-Identifier: Apache-2.0
"""Runs the program `poinsot`, which writes the files with its own worker processes, independent of Python's threads."""

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
    """Returns the program, and its name in messages."""
    named = os.environ.get(_VARIABLE)
    if named:
        return named, f"{_VARIABLE}={named}"
    own = (Path(__file__).with_name("program"), Path(__file__).parent / "portable/bin/poinsot")  # in a build; in a wheel
    found = next((str(program) for program in own if program.exists()), None) or shutil.which("poinsot")
    if not found:
        raise FileError(f"the program poinsot, which makes films and figures, is not installed; set {_VARIABLE}")
    return found, f"the program {found}"


def run(
    command: str,
    output: str,
    words: Sequence[str],
    progress: Callable[[int, int], object] | None = None,
) -> None:
    """Runs a command of the program, which writes the file `output`. Calls `progress` with (done, total) frames.

    Ctrl-C and exceptions of `progress` stop the program and are raised after it has ended. Complete segments are kept
    for resume=True.
    """
    # The program would read a name that begins with "-" as an option.
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
        raise FileError(f"{output}: {_found()[1]} exited with 0 but did not write the file", errno.ENOENT, output)


def _started(words: Sequence[str]) -> subprocess.Popen[str]:
    program, called = _found()
    try:
        # In its own process group, so that Ctrl-C in a terminal reaches the program only once, through this process.
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
    """Returns the error for a program's exit status. `failure` is the event with the file that failed, or empty."""
    text = in_python(re.sub(r"^poinsot: (error: )?", "", said, flags=re.MULTILINE)).strip()
    match status:  # exit codes of the program's manual page
        case 2:
            return made("limit" if says_limit(text) else "usage", text)
        case 3:
            return made("render", text)
        case 4:
            name = os.fsdecode(failure["file"].encode("latin-1")) if failure else None  # one character per byte
            return made("file", text, number=failure.get("errno", 0), filename=name)
    return Error(text or f"the program exited with status {status}")


def _event(line: str) -> dict[str, Any] | None:
    """Returns the event in a line of the program; None for a line of text."""
    return json.loads(line) if line.startswith("{") else None


def _is_there(output: str) -> bool:
    """Returns whether the file exists, or any picture of the sequence."""
    around = re.split(r"\{frame(?::0\d)?\}", output)
    return os.path.exists(output) if len(around) == 1 else bool(glob.glob("*".join(map(glob.escape, around))))
