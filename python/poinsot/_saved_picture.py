# SPDX-License-Identifier: Apache-2.0
"""Saves pictures of several packages as PNG files, without importing any of these packages."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._diff import pixels_of
from ._errors import FileError, UsageError
from ._packages import imported
from ._scene import Scene

if TYPE_CHECKING:
    from ._golden_settings import Settings

_TAKES = (
    "must be a Matplotlib figure, a PIL image, an array of uint8 or uint16, a PyVista plotter, a poinsot scene, an object "
    "with _repr_png_(), or the path of a PNG or a film"
)


def extension_of(picture: Any) -> str:
    """Returns the extension of the file of a picture: that of its path, or .png."""
    return Path(os.fsdecode(picture)).suffix.lower() or ".png" if _is_path(picture) else ".png"


def save(picture: Any, place: Path, settings: Settings) -> None:
    """Saves a picture as a file. Raises UsageError for an object of another kind, FileError if a file cannot be read or written."""
    try:
        _save(picture, place, settings)
    except OSError as error:
        if isinstance(error, FileError):
            raise
        raise FileError(f"{error.filename or place}: {error.strerror or error}", error.errno, error.filename or str(place)) from error


def _save(picture: Any, place: Path, settings: Settings) -> None:
    if _is_path(picture):
        shutil.copyfile(picture, place)
    elif hasattr(picture, "savefig"):
        _save_figure(picture, place, settings)
    elif isinstance(picture, Scene):
        _write(picture.render(settings.time, size=settings.size), place)
    elif _is_plotter(picture):
        _write(np.ascontiguousarray(picture.screenshot(None, return_img=True)), place)
    elif hasattr(picture, "getbands") or isinstance(picture, np.ndarray):
        _write(picture, place)
    elif hasattr(picture, "_repr_png_"):
        place.write_bytes(picture._repr_png_())
    else:
        shown = "None; a test with the marker golden must return a picture" if picture is None else f"<{type(picture).__name__}>"
        raise UsageError(f"golden: the picture is {shown}. It {_TAKES}")


def _is_path(it: Any) -> bool:
    return isinstance(it, (str, bytes, os.PathLike))


def _is_plotter(it: Any) -> bool:
    return hasattr(it, "screenshot") and type(it).__module__.partition(".")[0] in ("pyvista", "pyvistaqt")


def _write(picture: Any, place: Path) -> None:
    place.write_bytes(_core.png_of(pixels_of("picture", picture)))


def _save_figure(figure: Any, place: Path, settings: Settings) -> None:
    if settings.remove_text:
        imported("matplotlib.testing.decorators", "golden").remove_ticks_and_titles(figure)
    figure.savefig(place, **{"format": "png", **settings.save})


def close(picture: Any) -> None:
    """Closes a figure of Matplotlib that a test has returned, so that it does not stay in memory."""
    pyplot = sys.modules.get("matplotlib.pyplot")
    if pyplot is not None and hasattr(picture, "savefig"):
        pyplot.close(picture)
