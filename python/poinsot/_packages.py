# SPDX-License-Identifier: Apache-2.0
"""Packages that some functions need and the rest does without: imported when they are used."""

import importlib
from types import ModuleType

from ._errors import Error


class MissingPackageError(Error, ImportError):
    """A function needs a package that is not installed; the text names it."""


def imported(module: str, user: str) -> ModuleType:
    """Imports a module. @param user: the function that needs it, for the message."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = module.partition(".")[0]
        raise MissingPackageError(
            f"{user} needs the package {package}: apt install python3-{package}, or pip install {package}"
        ) from error
