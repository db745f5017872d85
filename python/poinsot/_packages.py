# SPDX-License-Identifier: Apache-2.0
"""Optional packages, which are imported on first use."""

import importlib
from types import ModuleType

from ._errors import Error


class MissingPackageError(Error, ImportError):
    """A function needs a package that is not installed. The text names the package."""


def imported(module: str, user: str) -> ModuleType:
    """Imports a module. @param user: the function that needs it, for the message."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = module.partition(".")[0]
        raise MissingPackageError(
            f"{user} needs the package {package}: apt install python3-{package}, or pip install {package}"
        ) from error
