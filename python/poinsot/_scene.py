# SPDX-License-Identifier: Apache-2.0
"""A scene: what it is made from, and what can be made of it."""

from __future__ import annotations

import json
import os
import tempfile
import warnings
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _check, _core, _grade, _program, _sweep, _toml
from ._film import Film
from ._trajectory import Trajectory

_DISPLAY_WIDTH = 960  # of a picture in a notebook, pixels

Path_ = str | os.PathLike[str]


def load(
    path: Path_,
    overrides: Mapping[str, Any] | None = None,
    *,
    limits: Mapping[str, int | str] | None = None,
    asset_roots: Sequence[Path_] = (),
) -> Scene:
    """The scene of a file.

    overrides: keys to set above what the file says, as {"style.theme": "dark", "motion.omega_body": [0, 5, "1 rpm"]}.
    limits: limits to raise or lower, as {"side": 16384, "memory": "4 GiB"}.
    asset_roots: more folders in which files that the scene names may lie.

    Raises SceneError with everything that is wrong and where, or that the file cannot be read; LimitError.
    """
    return Scene(_core.Scene.of_file(os.fspath(path), *_words(overrides, limits, asset_roots)), limits, asset_roots)


def loads(
    source: str | Mapping[str, Mapping[str, Any]],
    overrides: Mapping[str, Any] | None = None,
    *,
    name: str = "scene",
    folder: Path_ = ".",
    limits: Mapping[str, int | str] | None = None,
    asset_roots: Sequence[Path_] = (),
) -> Scene:
    """The scene of a text in TOML, or of its tables as dictionaries:

        poinsot.loads({"body": {"principal_moments": [1, 2, 2.5]}, "motion": {"omega_body": [0.05, "20 rpm", 0]}})

    name: of the scene, as of its file without ".toml".
    folder: where files that it names lie.
    Others, and what is raised: as load().
    """
    text = source if isinstance(source, str) else _toml.document(dict(source))
    file_name = str(Path(folder) / f"{name}.toml")
    return Scene(_core.Scene.of_text(text, file_name, *_words(overrides, limits, asset_roots)), limits, asset_roots)


class Scene:
    """A body, its motion, and how it is shown; checked, and never changed. Made by load() and loads().

    Film time runs from 0 to `duration`; motion time is the physics' own, and may run slower or faster.
    """

    def __init__(self, core: _core.Scene, limits: Mapping[str, int | str] | None, asset_roots: Sequence[Path_]):
        self._core = core
        self._limits = dict(limits or {})
        self._asset_roots = tuple(os.fspath(root) for root in asset_roots)

    @property
    def name(self) -> str:
        """The file's name without folder and ending."""
        return self._core.name

    @property
    def text(self) -> str:
        """The scene file, as it was when it was loaded."""
        return self._core.text

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of its pictures, in pixels."""
        return self._core.size

    @property
    def fps(self) -> Fraction:
        """Frames of the film per second."""
        return Fraction(*self._core.fps)

    @property
    def duration(self) -> float:
        """Of the film, in s."""
        return self._core.duration

    @property
    def frame_count(self) -> int:
        """Of the film."""
        return self._core.frame_count

    def replace(self, overrides: Mapping[str, Any]) -> Scene:
        """The scene with some keys set anew, as by load(). Raises as load()."""
        words = self._core.overrides + _overrides(overrides)
        core = _core.Scene.of_text(
            self._core.text, self._core.file_name, words, _limits(self._limits), list(self._asset_roots)
        )
        return Scene(core, self._limits, self._asset_roots)

    def motion_time(self, t: ArrayLike) -> NDArray[np.float64]:
        """Motion time at film times, in s; of the shape of `t`."""
        film = np.asarray(t, dtype=np.float64)
        return np.array(self._core.motion_times(film.ravel().tolist())).reshape(film.shape)

    def trajectory(self, times: ArrayLike) -> Trajectory:
        """The motion at motion times in s, of any shape and in any order; exact at any time where no torque acts.

        Raises UsageError for a time that is not finite, LimitError for one so far that the motion is beyond the
        range of numbers, PhysicsError. Warns of times so far that the attitude is no longer exact to rounding.
        """
        t = np.array(times, dtype=np.float64)
        rows = self._core.trajectory(t.ravel().tolist())
        if rows.note:
            warnings.warn(rows.note, stacklevel=2)
        return Trajectory(
            t=t,
            q_WB=rows.q_WB.reshape(*t.shape, 4),
            R_WB=rows.R_WB.reshape(*t.shape, 3, 3),
            omega_B=rows.omega_B.reshape(*t.shape, 3),
            omega_W=rows.omega_W.reshape(*t.shape, 3),
            L_W=rows.L_W.reshape(*t.shape, 3),
            T=rows.T.reshape(t.shape),
            rate_B=rows.rate_B.reshape(*t.shape, 3),
            rate_W=rows.rate_W.reshape(*t.shape, 3),
            columns=tuple(_core.trajectory_columns(self._core)),
        )

    def info(self) -> dict[str, Any]:
        """What one would work out by hand: moments, energies, periods, cones, rates. As `poinsot info --json`."""
        facts: dict[str, Any] = json.loads(self._core.info_json())
        return facts

    def check(self) -> dict[str, Any]:
        """What `poinsot check` says of the scene, and what a film of it takes.

        Returns a dictionary: ok; problems, why no picture can be drawn; notes, what is allowed and may be a slip (both
        lists of Problem, with file, line, column and message); estimates: frames, film_memory_bytes of a worker that
        makes the film as an MP4, picture_memory_bytes of render(). load() already raises what is wrong with the text
        itself, as SceneError.
        """
        return _check.check(self._core)

    def grade(self, table: Any, *, max_attitude_error: float | str | None = None) -> dict[str, Any]:
        """How far another engine's trajectory is off the motion of this scene, and from when on.

        table: a path of a CSV file, a dictionary of arrays, a structured array, a pandas.DataFrame or a Trajectory. Its
            columns are those of `poinsot trajectory`, in any order: t (motion time in s) and at least one of q_w, q_x,
            q_y, q_z, of omega_B_x, omega_B_y, omega_B_z (rad/s), of omega_W_x, ...; others are ignored. Vectors may be
            one array, too: q_WB or q_WB_xyzw (..., 4), omega_B, omega_W, L_W, rate_B, rate_W (..., 3).
        max_attitude_error: the largest attitude error that passes, in rad or with a unit: "0.1 deg".

        Returns the dictionary of `poinsot grade --json`: file (None for a table in memory), scene, rows, from_s, to_s,
        quantities (each None where its columns are absent, or its errors largest, largest_at_s, final, rms, drift),
        fits (None, or how else the table has to be read to fit), notes; and passes, None without a max_attitude_error.
        A number that is not finite is None.

        Raises UsageError for a table that cannot be graded, FileError for such a file, LimitError.
        """
        return _grade.grade(self._core, table, max_attitude_error)

    def sweep_map(self, *, shape: tuple[int, int] = (91, 181)) -> dict[str, Any]:
        """Computes the stability map that `poinsot sweep --map` draws: the time from flip to flip of this body, for
        each direction of L in it, with the scene's |L|.

        shape: how many values theta and phi have.

        Returns a dictionary. P are the principal axes e1, e2, e3, in the order of moments.
        theta: (n,) angle of L from e3, 0 to pi, rad. phi: (m,) its azimuth from e1 towards e2, 0 to 2 pi, rad.
        flip_interval: (n, m) s, inf on the separatrix and about the middle axis.
        direction_P, direction_B: (n, m, 3) unit vectors along L, in P and along the body's axes.
        moments: (3,) kg m^2. R_BP: (3, 3) takes components in P to those in B. L: |L|, kg m^2/s.
        scene: theta, phi and flip_interval of the scene's own L at its start.
        separatrix_P: (2, k, 3) the two great circles of directions that never come back.
        scale: least and most, s: the ends of the map's colours, logarithmic between them or not.
        labels: of theta, phi and flip_interval, for plots; TeX as matplotlib takes it.

        Source: 2K/lambda of the closed form, see docs/physics.md. Raises PhysicsError if the body is not free, is at
        rest, or has two equal moments; UsageError for another shape.
        """
        return _sweep.sweep_map(self._core, shape)

    def alt_text(self) -> str:
        """The picture in words, for readers who do not see it."""
        return self._core.alt_text()

    @overload
    def render(
        self,
        t: float | None = None,
        *,
        size: tuple[int, int] | None = None,
        transparent: bool = False,
        bits: Literal[8] = 8,
    ) -> NDArray[np.uint8]: ...
    @overload
    def render(
        self,
        t: float | None = None,
        *,
        size: tuple[int, int] | None = None,
        transparent: bool = False,
        bits: Literal[16],
    ) -> NDArray[np.uint16]: ...
    @overload
    def render(
        self,
        t: float | None = None,
        *,
        size: tuple[int, int] | None = None,
        transparent: bool = False,
        bits: int,
    ) -> NDArray[np.uint8] | NDArray[np.uint16]: ...
    def render(
        self,
        t: float | None = None,
        *,
        size: tuple[int, int] | None = None,
        transparent: bool = False,
        bits: int = 8,
    ) -> NDArray[np.uint8] | NDArray[np.uint16]:
        """The picture at film time t in s; without one, at the scene's time.still.

        size: width and height in pixels, in place of the scene's.
        transparent: without paper: four channels, alpha straight.
        bits: of a sample, 8 or 16.

        An array (height, width, 3 or 4) of uint8 or uint16, sRGB, rows from the top; the pixels of `poinsot still`.
        Drawn on a thread of this package's. The first call removes Mesa's variables from the environment and sets its
        own. Raises UsageError, LimitError, RenderError.
        """
        return self._core.picture(None if t is None else float(t), size, transparent, bits)

    def save(
        self,
        path: Path_,
        t: float | None = None,
        *,
        size: tuple[int, int] | None = None,
        width: str | None = None,
        dpi: float | None = None,
        transparent: bool = False,
    ) -> Path:
        """Writes the picture at film time t: .png, .pdf, .svg or .tex, by the name.

        width: on paper, as "86mm": then type and lines have a size in points, and `size` is only the proportion.
        dpi: pixels to the inch there. Others as render().

        Returns the path. Raises UsageError, RenderError, FileError.
        """
        words = ["-o", os.fspath(path)]
        if t is not None:
            words += ["--time", repr(float(t))]
        if width is not None:
            words += ["--width", width]
        if dpi is not None:
            words += ["--dpi", repr(float(dpi))]
        if transparent:
            words.append("--transparent")
        self._make("still", words + _size(size))
        return Path(path)

    def film(
        self,
        path: Path_,
        *,
        size: tuple[int, int] | None = None,
        frames: tuple[int, int] | None = None,
        jobs: int | None = None,
        resume: bool = False,
        progress: Callable[[int, int], object] | None = None,
    ) -> Film:
        """Makes the film: .mp4, .mov, .webm, .gif or .apng, by the name. The same scene gives the same bytes.

        size: width and height in pixels, in place of the scene's.
        frames: the first and the last of them, both included; all if not given.
        jobs: worker processes; one for each CPU if not given.
        resume: goes on with what an earlier call that was stopped left.
        progress: called with how many frames are done, and of how many. What it raises stops the film, as Ctrl-C does.

        Raises UsageError, LimitError, RenderError, FileError.
        """
        words = ["-o", os.fspath(path)]
        if frames is not None:
            words += ["--frames", f"{frames[0]}-{frames[1]}"]
        if jobs is not None:
            words += ["-j", str(jobs)]
        if resume:
            words.append("--resume")
        self._make("render", words + _size(size), progress)
        count = frames[1] - frames[0] + 1 if frames else self.frame_count
        return Film(Path(path), size or self.size, count, float(count / self.fps))

    def _make(self, command: str, words: list[str], progress: Callable[[int, int], object] | None = None) -> None:
        """Has the program make a file of the text that was loaded, whatever the scene's file says by now."""
        file = Path(self._core.file_name)
        with tempfile.TemporaryDirectory(prefix="poinsot-") as folder:
            copy = Path(folder) / file.name
            copy.write_text(self._core.text, encoding="utf-8")
            allowed = [f"--asset-root={root}" for root in (str(file.parent), *self._asset_roots)]
            allowed += [f"--limit={word}" for word in _limits(self._limits)]
            overrides = [word for override in self._core.overrides for word in ("-D", override)]
            _program.run(command, [*words, *allowed, *overrides, "--", str(copy)], progress)

    def _repr_png_(self) -> bytes:
        width, height = self.size
        shown = min(width, _DISPLAY_WIDTH)
        return self._core.png(None, (shown, max(16, round(height * shown / width))))

    def __repr__(self) -> str:
        width, height = self.size
        return f"<poinsot scene {self.name!r}: {self.duration:g} s, {width}x{height}>"


def _words(
    overrides: Mapping[str, Any] | None, limits: Mapping[str, int | str] | None, asset_roots: Sequence[Path_]
) -> tuple[list[str], list[str], list[str]]:
    return _overrides(overrides or {}), _limits(limits or {}), [os.fspath(root) for root in asset_roots]


def _overrides(overrides: Mapping[str, Any]) -> list[str]:
    return [_toml.override(key, value) for key, value in overrides.items()]


def _limits(limits: Mapping[str, int | str]) -> list[str]:
    return [f"{name}={value}" for name, value in limits.items()]


def _size(size: tuple[int, int] | None) -> list[str]:
    return [] if size is None else ["--size", f"{size[0]}x{size[1]}"]
