# SPDX-License-Identifier: Apache-2.0
"""Errors of a scene, a value or the machine. The module _core and the program raise them through made()."""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Iterable
from functools import partial
from typing import Any, NamedTuple


class Error(Exception):
    """Base of all errors of this package."""


class UsageError(Error, ValueError):
    """A value that a function cannot take."""


class Problem(NamedTuple):
    """One thing wrong with a scene. Line and column count from 1; they are 0, and `file` is empty, for an override."""

    file: str
    line: int
    column: int
    message: str
    override: str = ""  #: its key, as "style.theme"; empty for a problem in a file


class SceneError(Error, ValueError):
    """A scene, or a file that it names, is wrong: the text shows where, `problems` lists everything."""

    def __init__(self, text: str, problems: Iterable[Problem] = ()) -> None:
        super().__init__(text)
        self.problems = tuple(problems)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.problems)


class LimitError(Error, ValueError):
    """More than a limit allows, and how to raise it; or a motion time outside the span in which the motion is known."""


class SceneLimitError(SceneError, LimitError):
    """A scene in which nothing is wrong but that it asks for more than limits allow."""


class FarTimeWarning(UserWarning):
    """Times so far from the start that the attitude is no longer exact to rounding."""


class PhysicsError(Error, ValueError):
    """A motion or a quantity that does not exist for this body."""


class RenderError(Error, RuntimeError):
    """OpenGL or an encoder failed."""


class FileError(Error, OSError):
    """A file cannot be read or written; `filename` is its name. Where the system gives the reason, it is also the
    FileNotFoundError, FileExistsError, IsADirectoryError, NotADirectoryError or PermissionError that `open()` would
    raise, with its `errno` and `strerror`.
    """

    def __new__(cls, text: str = "", number: int | None = None, filename: str | None = None) -> FileError:
        return super().__new__(_FILE_ERRORS.get(number, cls), text)  # type: ignore[call-arg]  # typeshed has none

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
    """The file, or the folder it is to be written to, does not exist."""


class FileIsThereError(FileError, FileExistsError):
    """Another file stands where the file is to be written."""


class FileIsFolderError(FileError, IsADirectoryError):
    """A folder stands where a file is wanted."""


class FolderIsFileError(FileError, NotADirectoryError):
    """A file stands where a folder is wanted."""


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
    """The error of a kind that _core names. Its text is one of in_python().

    number, filename: of an error of a file: the system's errno, 0 if no call of the system failed.
    """
    if kind == "file":
        return FileError(text, number or None, filename)
    if kind != "scene":
        return _CLASSES[kind](text)
    problems = tuple(problems)
    limited = problems and all(says_limit(problem.message) for problem in problems)
    return (SceneLimitError if limited else SceneError)(text, problems)


def says_limit(text: str) -> bool:
    """Whether a text of in_python() says how to raise a limit."""
    return 'limits={"' in text


# What users wrote is kept: quoted texts, and lines of a file, which a message shows indented.
_QUOTED = r""""[^"\n]*"|(?<!\w)'[^'\n]*'(?!\w)|`[^`\n]*`|^ .*$"""

# Options as the layers and the program name them in messages, and what stands for each here. The first that fits wins.
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
    """A message in which arguments of functions stand for options of the program."""
    for option, argument in _OPTIONS:
        text = option.sub(partial(_replaced, argument), text)
    return text


def _replaced(argument: str, found: re.Match[str]) -> str:
    return found["kept"] or found.expand(argument)
