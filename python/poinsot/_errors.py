# SPDX-License-Identifier: Apache-2.0
"""Errors of a scene, a value or the machine. The module _core and the program raise them through made()."""

from __future__ import annotations

import errno
import os
import re
import stat
from collections.abc import Iterable
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


class LimitError(Error):
    """More than a limit allows; the text says how to raise it."""


class SceneLimitError(SceneError, LimitError):
    """A scene in which nothing is wrong but that it asks for more than limits allow."""


class PhysicsError(Error, ValueError):
    """A motion or a quantity that does not exist for this body."""


class RenderError(Error, RuntimeError):
    """OpenGL or an encoder failed."""


class FileError(Error, OSError):
    """A file cannot be read or written. Where the system gives the reason, it is also the FileNotFoundError,
    IsADirectoryError, NotADirectoryError or PermissionError that `open()` would raise, with its `errno`.
    """

    def __new__(cls, text: str = "", number: int | None = None, filename: str | None = None) -> FileError:
        return super().__new__(_FILE_ERRORS.get(number, cls), text)  # type: ignore[call-arg]  # typeshed has none

    def __init__(self, text: str = "", number: int | None = None, filename: str | None = None) -> None:
        super().__init__(text)
        if number is not None:
            self.errno = number
        self.filename = filename

    def __str__(self) -> str:
        return str(self.args[0])

    def __reduce__(self) -> tuple[Any, ...]:
        return FileError, (str(self), self.errno, self.filename)


class FileMissingError(FileError, FileNotFoundError):
    """The file, or the folder it is to be written to, does not exist."""


class FileIsFolderError(FileError, IsADirectoryError):
    """A folder stands where a file is wanted."""


class FolderIsFileError(FileError, NotADirectoryError):
    """A file stands where a folder is wanted."""


class FileDeniedError(FileError, PermissionError):
    """The system denies access to the file."""


_FILE_ERRORS: dict[int | None, type[FileError]] = {
    errno.ENOENT: FileMissingError,
    errno.EISDIR: FileIsFolderError,
    errno.ENOTDIR: FolderIsFileError,
    errno.EACCES: FileDeniedError,
    errno.EPERM: FileDeniedError,
}


def cannot_read(text: str, path: str) -> FileError:
    """The error of a file that was not read, with the system's reason."""
    return FileError(text, _failure(path, stat.S_IFREG, os.R_OK), path)


def cannot_write(text: str, path: str) -> FileError:
    """The error of a file that was not written, with the system's reason if it lies in the folder."""
    return FileError(text, _failure(os.path.dirname(path) or ".", stat.S_IFDIR, os.W_OK), path)


def _failure(path: str, kind: int, access: int) -> int | None:
    try:
        mode = os.stat(path).st_mode
    except OSError as error:
        return error.errno
    if stat.S_IFMT(mode) != kind and kind == stat.S_IFDIR:
        return errno.ENOTDIR
    if stat.S_ISDIR(mode) and kind == stat.S_IFREG:
        return errno.EISDIR
    return None if os.access(path, access) else errno.EACCES


_CLASSES: dict[str, type[Error]] = {
    "usage": UsageError,
    "limit": LimitError,
    "physics": PhysicsError,
    "render": RenderError,
    "file": FileError,
}


def made(kind: str, text: str, problems: Iterable[Problem] = ()) -> Error:
    """The error of a kind that _core names. Its text is one of in_python()."""
    if kind != "scene":
        return _CLASSES[kind](text)
    problems = tuple(problems)
    limited = problems and all(says_limit(problem.message) for problem in problems)
    return (SceneLimitError if limited else SceneError)(text, problems)


def says_limit(text: str) -> bool:
    """Whether a text of in_python() says how to raise a limit."""
    return 'limits={"' in text


# Options as the layers and the program name them in messages, and what stands for each here. The first that fits wins.
_OPTIONS = [
    (re.compile(rf"(?<![\w-]){option}"), argument)
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
        text = option.sub(argument, text)
    return text
