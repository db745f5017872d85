# SPDX-License-Identifier: Apache-2.0
"""Error classes of this package. The module _core and the program raise errors through made()."""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Iterable
from functools import partial
from typing import Any, NamedTuple


class Error(Exception):
    """Base class of all errors of this package."""


class UsageError(Error, ValueError):
    """A value that a function does not accept."""


class Problem(NamedTuple):
    """One mistake in a scene. Line and column count from 1. For an override, and for a scene that is given as a
    dictionary, both are 0 and `file` is empty.
    """

    file: str
    line: int
    column: int
    message: str
    override: str = ""  #: key of the override, such as "style.theme"; empty for a problem in a file
    place: str = ""  #: place in the dictionary of the scene, such as scene["motion"]["omega_body"]; empty for a text


class SceneError(Error, ValueError):
    """A mistake in a scene or in a file that it names. The text shows each place, and `problems` lists all mistakes."""

    def __init__(self, text: str, problems: Iterable[Problem] = ()) -> None:
        super().__init__(text)
        self.problems = tuple(problems)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.problems)


class LimitError(Error, ValueError):
    """More than a limit allows, with the way to raise it; or a motion time outside the span of a motion."""


class SceneLimitError(SceneError, LimitError):
    """A scene whose only mistakes are values beyond a limit."""


class FarTimeWarning(UserWarning):
    """Times so far from the start that the attitude is no longer exact to rounding."""


class PhysicsError(Error, ValueError):
    """A motion or a quantity that does not exist for this body."""


class RenderError(Error, RuntimeError):
    """OpenGL or an encoder failed."""


class FileError(Error, OSError):
    """A file cannot be read or written; `filename` is the name of the file.

    If the system gives the reason, the error is also the FileNotFoundError, FileExistsError, IsADirectoryError,
    NotADirectoryError or PermissionError that `open()` would raise, with `errno` and `strerror`.
    """

    def __new__(cls, text: str = "", number: int | None = None, filename: str | None = None) -> FileError:
        return super().__new__(_FILE_ERRORS.get(number, cls), text)  # type: ignore[call-arg]  # not in typeshed

    def __init__(self, text: str = "", number: int | None = None, filename: str | None = None) -> None:
        super().__init__(text)
        if number is not None:
            self.errno = number
            self.strerror = os.strerror(number)
        self.filename = filename

    def __str__(self) -> str:
        return str(self.args[0])

    def __reduce__(self) -> tuple[Any, ...]:
        return FileError, (str(self), self.errno, self.filename)


class FileMissingError(FileError, FileNotFoundError):
    """The file, or the folder of a file to write, does not exist."""


class FileIsThereError(FileError, FileExistsError):
    """A file of this name already exists."""


class FileIsFolderError(FileError, IsADirectoryError):
    """The name is that of a folder, not of a file."""


class FolderIsFileError(FileError, NotADirectoryError):
    """A part of the path is a file, not a folder."""


class FileDeniedError(FileError, PermissionError):
    """The system denies access to the file."""


_FILE_ERRORS: dict[int | None, type[FileError]] = {
    errno.ENOENT: FileMissingError,
    errno.EEXIST: FileIsThereError,
    errno.EISDIR: FileIsFolderError,
    errno.ENOTDIR: FolderIsFileError,
    errno.EACCES: FileDeniedError,
    errno.EPERM: FileDeniedError,
}


_CLASSES: dict[str, type[Error]] = {
    "usage": UsageError,
    "limit": LimitError,
    "physics": PhysicsError,
    "render": RenderError,
}


def made(
    kind: str, text: str, problems: Iterable[Problem] = (), number: int = 0, filename: str | None = None
) -> Error:
    """Returns the error of a kind that _core names. Its text is a result of in_python().

    number: for an error of a file, the system's errno; 0 if no system call failed.
    filename: for an error of a file, the name of the file.
    """
    if kind == "file":
        return FileError(text, number or None, filename)
    if kind != "scene":
        return _CLASSES[kind](text)
    problems = tuple(problems)
    limited = problems and all(says_limit(problem.message) for problem in problems)
    return (SceneLimitError if limited else SceneError)(text, problems)


def says_limit(text: str) -> bool:
    """Returns whether a text of in_python() contains the way to raise a limit."""
    return 'limits={"' in text


# Text of the user that must not change: quoted text, and lines of a file, which a message shows indented.
_QUOTED = r""""[^"\n]*"|(?<!\w)'[^'\n]*'(?!\w)|`[^`\n]*`|^ .*$"""

# Options in messages of the layers and of the program, and the Python argument for each. The first match wins.
_OPTIONS = [
    (re.compile(rf"(?<![\w-]){option}|(?P<kept>{_QUOTED})", re.MULTILINE), argument)
    for option, argument in (
        (r"--limit (\w+)=N", r'limits={"\1": N}'),
        (r"--max-memory SIZE", r'limits={"memory": SIZE}'),
        (r"--max-seconds", r'limits={"seconds": N}'),
        (r"the same command with --resume", r"the same call with resume=True"),
        (r"--(force|resume|transparent)\b", r"\1=True"),
        (r"--(dpi|jobs): Value (\S+) not in range (\d+)(?:\.0*)? to (\d+)(?:\.0*)?", r"\1=\2: must be from \3 to \4"),
        (r"--size (\d+)x(\d+)", r"size=(\1, \2)"),
        (r"--frames (\d+)(?![\d-])", r"frames=(\1, \1)"),
        (r"--(dpi|width) ('[^']*'|\d+)", r"\1=\2"),
        (r"--(dpi|width|size|frames|jobs)\b", r"\1="),
        (r"--asset-root\b", r"asset_roots="),
        (r"--output\b", r"path"),
    )
]


def in_python(text: str) -> str:
    """Replaces options of the program in a message by the arguments of Python functions."""
    for option, argument in _OPTIONS:
        text = option.sub(partial(_replaced, argument), text)
    return text


def _replaced(argument: str, found: re.Match[str]) -> str:
    return found["kept"] or found.expand(argument)
