# SPDX-License-Identifier: Apache-2.0
"""What is raised when a scene, a value or the machine is at fault. The module _core raises these, too."""

from collections.abc import Iterable
from typing import NamedTuple


class Error(Exception):
    """Of all of this package."""


class UsageError(Error, ValueError):
    """A value that a function cannot take."""


class Problem(NamedTuple):
    """One thing wrong with a scene. Line and column count from 1; line 0 is of an override."""

    file: str
    line: int
    column: int
    message: str


class SceneError(Error, ValueError):
    """A scene, or a file that it names, is wrong: the text shows where, `problems` lists everything."""

    def __init__(self, text: str, problems: Iterable[Problem] = ()) -> None:
        super().__init__(text)
        self.problems = tuple(problems)


class LimitError(Error):
    """More than a limit allows; the text says how to raise it."""


class PhysicsError(Error, ValueError):
    """A motion or a quantity that does not exist for this body."""


class RenderError(Error, RuntimeError):
    """OpenGL or an encoder failed."""


class FileError(Error, OSError):
    """A file cannot be read or written."""
