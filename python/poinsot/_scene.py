# SPDX-License-Identifier: Apache-2.0
"""Scenes: loading, the motion as arrays, pictures and films."""

from __future__ import annotations

import json
import os
import tempfile
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import Path
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _check, _core, _grade, _places, _program, _sweep, _times, _toml
from ._core import Scene as _CoreScene
from ._errors import FarTimeWarning, SceneError
from ._film import Film
from ._times import Time, Times
from ._trajectory import Trajectory

_DISPLAY_WIDTH = 960  # width of a picture in a notebook, pixels
_OVERRIDES = '{"style.theme": "dark"}'  # an example

Path_ = str | os.PathLike[str]


@dataclass(frozen=True)
class _Source:
    """Everything from which a scene is loaded."""

    file_name: str
    overrides: tuple[str, ...]
    limits: tuple[str, ...]
    asset_roots: tuple[str, ...]
    text: str | None = None  # by default, the text of the file
    places: _places.Places = field(default=(), compare=False)  # of the lines, if the scene is a dictionary

    def scene(self) -> Scene:
        """Reads and checks the scene. Raises SceneError, LimitError, FileError."""
        try:
            return self._loaded()
        except SceneError as error:
            if not self.places:
                raise
            raise _places.in_dictionary(error, self.file_name, self.places) from None

    def _loaded(self) -> Scene:
        words = list(self.overrides), list(self.limits), [os.fsencode(root) for root in self.asset_roots]
        file = os.fsencode(self.file_name)
        if self.text is not None:
            return Scene._of(_CoreScene.of_text(self.text, file, *words), self)
        core = _CoreScene.of_file(file, *words)
        return Scene._of(core, replace(self, text=core.text))

    def elsewhere(self) -> _Source:
        """Returns a copy with absolute paths, for a process in another folder."""
        try:
            roots = tuple(os.path.abspath(root) for root in self.asset_roots)
            return replace(self, file_name=os.path.abspath(self.file_name), asset_roots=roots)
        except FileNotFoundError:  # the folder of this process was removed
            return self


def _source(
    file_name: str,
    overrides: object,
    limits: object,
    asset_roots: object,
    text: str | None = None,
    places: _places.Places = (),
) -> _Source:
    roots = _arguments.paths("asset_roots", asset_roots)
    return _Source(file_name, _words(overrides), tuple(_arguments.limits(limits)), tuple(roots), text, places)


def _words(overrides: object) -> tuple[str, ...]:
    given = _arguments.table("overrides", overrides, _OVERRIDES)
    return tuple(_toml.override(key, value) for key, value in given.items())


def load(
    path: Path_,
    overrides: Mapping[str, Any] | None = None,
    *,
    limits: Mapping[str, int | str] | None = None,
    asset_roots: Sequence[Path_] = (),
) -> Scene:
    """Loads the scene of a file.

    overrides: values that override keys of the file: {"style.theme": "dark", "motion.omega_body": [0, 5, "1 rpm"]}.
    limits: limits to raise or lower, such as {"side": 16384, "memory": "4 GiB"}.
    asset_roots: additional folders for files that the scene names.

    Raises SceneError with all mistakes and their places; FileError, which is also a FileNotFoundError or another error
    of open(); LimitError; UsageError.
    """
    return _source(_arguments.path("path", path), overrides, limits, asset_roots).scene()


def loads(
    source: str | Mapping[str, Mapping[str, Any]],
    overrides: Mapping[str, Any] | None = None,
    *,
    name: str = "scene",
    folder: Path_ = ".",
    limits: Mapping[str, int | str] | None = None,
    asset_roots: Sequence[Path_] = (),
) -> Scene:
    """Loads a scene from text in TOML, or from its tables as dictionaries:

        poinsot.loads({"body": {"principal_moments": [1, 2, 2.5]}, "motion": {"omega_body": [0.05, "20 rpm", 0]}})

    name: name of the scene, like a file name without ".toml".
    folder: folder of the files that the scene names.

    A mistake in a dictionary has a place such as scene["motion"]["omega_body"], in the text of the error and in its
    `problems`.

    Values are plain numbers and strings, times (timedelta, timedelta64), paths, and arrays and pandas Series without
    masked values. Other arguments and errors are those of load().
    """
    file_name = Path(_arguments.path("folder", folder)) / f"{_arguments.stem('name', name)}.toml"
    text = _toml.scene_text(source)
    places = () if isinstance(source, str) else _toml.places(source)
    return _source(str(file_name), overrides, limits, asset_roots, text, places).scene()


class Scene:
    """A loaded and checked scene: a body, its motion, and the way to draw both. load() and loads() return a scene. It
    never changes.

    Film time runs from 0 to `duration`. Motion time is the time of the physics, and may run slower or faster.

    Two scenes are equal if their texts, overrides, limits, asset roots and file names are equal.
    """

    __slots__ = ("__weakref__", "_core", "_place", "_source")

    _core: _CoreScene
    _source: _Source
    _place: _Source  # the source with absolute paths

    def __init__(self) -> None:
        raise TypeError("use poinsot.load() or poinsot.loads() to make a scene")

    @classmethod
    def _of(cls, core: _CoreScene, source: _Source) -> Scene:
        scene = cls.__new__(cls)
        scene._core = core
        scene._source = source
        scene._place = source.elsewhere()
        return scene

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and self._place == other._place

    def __hash__(self) -> int:
        return hash(self._place)

    def __reduce__(self) -> tuple[Any, ...]:
        return _Source.scene, (self._place,)

    def __copy__(self) -> Scene:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Scene:
        return self  # a scene never changes

    @property
    def name(self) -> str:
        """Name of the file without folder and suffix."""
        return self._core.name

    @property
    def text(self) -> str:
        """Text of the scene file at the time of loading."""
        return self._core.text

    @property
    def overrides(self) -> dict[str, Any]:
        """Keys that load(), loads() and replace() have overridden. Values are plain numbers, strings, lists and
        dictionaries, even if arrays were given. Each access returns a new dictionary.
        """
        return _toml.overridden(self._source.overrides)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of a picture, in pixels."""
        return self._core.size

    @property
    def fps(self) -> Fraction:
        """Frames per second of the film."""
        return Fraction(*self._core.fps)

    @property
    def duration(self) -> float:
        """Length of the film, s."""
        return self._core.duration

    @property
    def frame_count(self) -> int:
        """Number of frames of the film."""
        return self._core.frame_count

    def replace(self, overrides: Mapping[str, Any]) -> Scene:
        """Returns a scene with some keys overridden, as load() does. Raises the errors of load()."""
        new = {word.partition("=")[0]: word for word in _words(overrides)}
        kept = [word for word in self._source.overrides if word.partition("=")[0] not in new]
        return replace(self._source, overrides=(*kept, *new.values())).scene()

    def motion_time(self, t: Times) -> NDArray[np.float64]:
        """Converts film times to motion times, in s, in the shape of `t`. Raises UsageError outside the film."""
        return self._core.motion_times(_times.film_times("t", t, self.duration))

    def trajectory(
        self, times: Times, *, span: tuple[Time, Time] | None = None, quantities: Sequence[str] = ()
    ) -> Trajectory:
        """Returns the motion at motion times of any shape and in any order. If no torque acts, it is exact at any time.

        times: motion times in s, or as timedelta or timedelta64.
        span: first and last motion time over which a driven motion is integrated; by default, from the earliest to the
            latest of `times` and 0. The last bits depend on the span. A scene keeps its latest four spans, so more
            times of the same span cost little.
        quantities: names of quantities that plots can show, such as ["theta", "phi", "E"], or of columns of
            `poinsot trajectory`. Their arrays are in the dictionary `quantities` of the result, in SI units and rad;
            to_frame() then has exactly their columns. A value that does not exist is NaN.

        Ctrl-C stops the computation. Raises UsageError for a time that is not finite, and for an unknown quantity. Raises LimitError, which is also
        a ValueError, for a time outside the span, or so far from 0 that the motion is beyond the range of numbers.
        Raises PhysicsError. A FarTimeWarning reports times so far from 0 that the attitude is not exact to rounding.
        """
        t = _times.times("times", times)
        names = [name for name in _arguments.names("quantities", quantities, '["theta", "phi", "E"]') if name != "t"]
        rows = self._core.trajectory(t, _times.span(span), names)
        if rows.note:
            warnings.warn(rows.note, FarTimeWarning, stacklevel=2)
        return Trajectory(
            t=t,
            q_WB=rows.q_WB,
            R_WB=rows.R_WB,
            omega_B=rows.omega_B,
            omega_W=rows.omega_W,
            L_W=rows.L_W,
            T=rows.T,
            rate_B=rows.rate_B,
            rate_W=rows.rate_W,
            quantities=dict(zip(names, rows.quantities)),
            _state_columns=tuple(_core.trajectory_columns(self._core)),
        )

    def events(self, *, span: tuple[Time, Time] | None = None) -> list[dict[str, Any]]:
        """Returns the events of the motion, in order, as `poinsot trajectory --events` writes them.

        span: first and last motion time, s; by default, those of the film.

        Each event is a dictionary with these keys. event: "flip", "reversal", "separatrix", "least_tilt",
        "largest_tilt" or "highest_point". t: motion time, s. film_from and film_to: first and last film time at which
        the film shows the event, s; None if the film does not show it. They differ only if the motion stands still.

        Ctrl-C stops the computation. Raises LimitError for more than a million events; UsageError, PhysicsError.
        """
        events: list[dict[str, Any]] = json.loads(self._core.events_json(_times.span(span)))["events"]
        return events

    def info(self) -> dict[str, Any]:
        """Returns the dictionary of `poinsot info --json`: moments, energies, periods, cones, rates."""
        facts: dict[str, Any] = json.loads(self._core.info_json())
        return facts

    def check(self) -> dict[str, Any]:
        """Returns the notes that `poinsot check` prints about the scene, and how much memory a film of it takes.

        The dictionary has these keys. ok: whether pictures can be drawn. problems: the reasons why no picture can be
        drawn. notes: allowed values that may be mistakes. problems and notes are lists of Problem, with file, line,
        column and message. estimates: frames, film_memory_bytes of a worker that makes the film as an MP4, and
        picture_memory_bytes of render(), all integers. load() raises mistakes in the text itself as SceneError.
        """
        return _check.check(self._core, self._source.file_name, self._source.places)

    def grade(self, table: Any, *, max_attitude_error: float | str | None = None) -> dict[str, Any]:
        """Measures how far another engine's trajectory is off the motion of this scene, and since when.

        table: a path of a CSV file, a dictionary of arrays, a structured array, a pandas.DataFrame or a Trajectory. Its
            columns are those of `poinsot trajectory`, in any order: t (motion time in s) and at least one group of q_w,
            q_x, q_y, q_z, of omega_B_x, omega_B_y, omega_B_z (rad/s), or of omega_W_x, ... Other columns are ignored. A
            vector may also be one array: q_WB or q_WB_xyzw (..., 4), omega_B, omega_W, L_W, rate_B, rate_W (..., 3).
        max_attitude_error: largest attitude error that passes, in rad or with a unit, such as "0.1 deg".

        Returns the dictionary of `poinsot grade --json`: file (None for a table in memory), scene, rows, from_s, to_s,
        quantities, fits, notes and passes. Each quantity is None if its columns are absent, else its errors: largest,
        largest_at_s, final, rms, drift. fits is None, or another reading of the table that fits the motion. passes is
        None without a max_attitude_error. A number that is not finite is None.

        Raises UsageError for a table that cannot be graded, FileError for such a file, LimitError.
        """
        return _grade.grade(self._core, table, max_attitude_error)

    def sweep_map(self, *, shape: tuple[int, int] = (91, 181)) -> dict[str, Any]:
        """Computes the stability map that `poinsot sweep --map` draws: the time from flip to flip of this body, for
        each direction of L in the body, with the |L| of the scene.

        shape: numbers of theta and phi values.

        Returns a dictionary with these keys. P are the principal axes e1, e2, e3, in the order of moments.
        theta: (n,) angle of L from e3, 0 to pi, rad. phi: (m,) its azimuth from e1 towards e2, 0 to 2 pi, rad.
        flip_interval: (n, m) s, inf on the separatrix and about the middle axis.
        direction_P, direction_B: (n, m, 3) unit vectors along L, in P and along the body's axes.
        moments: (3,) kg m^2. R_BP: (3, 3) takes components in P to those in B. L: |L|, kg m^2/s.
        scene: theta, phi and flip_interval of the scene's own L at its start.
        separatrix_P: (2, k, 3) the two great circles of directions that never come back.
        scale: least and most, the ends of the colour scale in s, and logarithmic, whether the scale is logarithmic.
        labels: labels of theta, phi and flip_interval for plots, in matplotlib's TeX.

        Source: 2K/lambda of the closed form; see docs/physics.md. Raises PhysicsError if the body is not free, is at
        rest, or has two equal moments; UsageError for an invalid shape.
        """
        return _sweep.sweep_map(self._core, shape)

    def alt_text(self) -> str:
        """Returns a description of the picture in words, for readers who cannot see the picture."""
        return self._core.alt_text()

    @overload
    def render(
        self,
        t: Time | None = None,
        *,
        size: tuple[int, int] | None = None,
        transparent: bool = False,
        bits: Literal[8] = 8,
    ) -> NDArray[np.uint8]: ...
    @overload
    def render(
        self,
        t: Time | None = None,
        *,
        size: tuple[int, int] | None = None,
        transparent: bool = False,
        bits: Literal[16],
    ) -> NDArray[np.uint16]: ...
    @overload
    def render(
        self,
        t: Time | None = None,
        *,
        size: tuple[int, int] | None = None,
        transparent: bool = False,
        bits: int,
    ) -> NDArray[np.uint8] | NDArray[np.uint16]: ...
    def render(
        self,
        t: Time | None = None,
        *,
        size: tuple[int, int] | None = None,
        transparent: bool = False,
        bits: int = 8,
    ) -> NDArray[np.uint8] | NDArray[np.uint16]:
        """Returns the picture at film time t in s; by default, at time.still of the scene.

        size: width and height in pixels; by default, the size of the scene.
        transparent: draws no background. The picture then has four channels, with straight alpha.
        bits: bits per sample, 8 or 16.

        The array has the shape (height, width, 3 or 4) and is of uint8 or uint16, in sRGB, with rows from the top. Its
        pixels are those of `poinsot still`. A thread of this package draws the picture. The first call replaces Mesa's
        variables in the environment by those of poinsot. Ctrl-C takes effect during the wait for the thread. Raises
        UsageError, LimitError, RenderError.
        """
        return self._core.picture(
            None if t is None else _times.film_time("t", t, self.duration),
            _arguments.size(size),
            _arguments.flag("transparent", transparent),
            _arguments.bits(bits),
        )

    def save(
        self,
        path: Path_,
        t: Time | None = None,
        *,
        size: tuple[int, int] | None = None,
        width: str | None = None,
        dpi: float | None = None,
        transparent: bool = False,
        force: bool = False,
    ) -> Path:
        """Writes the picture at film time t. The suffix of the path selects .png, .pdf, .svg or .tex.

        width: width on paper, such as "86mm". Text and lines then have a size in points, and `size` only sets the
            proportion.
        dpi: pixels per inch on paper.
        force: replaces a file that poinsot did not write.

        Other arguments are those of render(). Ctrl-C stops the program, which may take half a second.

        Returns the path. Raises UsageError, LimitError, RenderError, FileError.
        """
        file = _arguments.path("path", path)
        words = []
        if t is not None:
            words += ["--time", repr(_times.film_time("t", t, self.duration))]
        if width is not None:
            words += ["--width", _arguments.text("width", width, 'must be a width on paper, such as "86mm"')]
        if dpi is not None:
            words += ["--dpi", repr(_arguments.number("dpi", dpi))]
        if _arguments.flag("transparent", transparent):
            words.append("--transparent")
        if _arguments.flag("force", force):
            words.append("--force")
        self._make("still", file, words + self._size_words(size))
        return Path(file)

    def film(
        self,
        path: Path_,
        *,
        size: tuple[int, int] | None = None,
        frames: tuple[int, int] | range | None = None,
        jobs: int | None = None,
        resume: bool = False,
        force: bool = False,
        progress: Callable[[int, int], object] | None = None,
    ) -> Film:
        """Makes the film. The suffix of the path selects .mp4, .mov, .webm, .gif or .apng. The same scene always gives
        the same bytes.

        size: width and height in pixels; by default, the size of the scene.
        frames: the first and the last frame, both included, or a range, such as range(0, 10) for frames 0 to 9; by
            default, all frames.
        jobs: number of worker processes, 1 to 1024; by default, one for each CPU.
        resume: continues an earlier call that was stopped.
        force: replaces a file that poinsot did not write.
        progress: called with the number of finished frames and the number of all frames. An exception of the function
            stops the film, as Ctrl-C does within half a second.

        Raises UsageError, LimitError, RenderError, FileError.
        """
        file = _arguments.path("path", path)
        first, last = _arguments.frames(frames, self.frame_count) or (0, self.frame_count - 1)
        words = ["--frames", f"{first}-{last}"] if frames is not None else []
        if (workers := _arguments.jobs(jobs)) is not None:
            words.append(f"--jobs={workers}")
        if _arguments.flag("resume", resume):
            words.append("--resume")
        if _arguments.flag("force", force):
            words.append("--force")
        _arguments.function("progress", progress)
        self._make("render", file, words + self._size_words(size), progress)
        count = last - first + 1
        return Film(Path(file), _arguments.size(size) or self.size, count, float(count / self.fps))

    def _size_words(self, size: object) -> list[str]:
        sides = _arguments.size(size)
        if sides is None:
            return []
        self._core.require_sides(*sides)
        return ["--size", f"{sides[0]}x{sides[1]}"]

    def _make(
        self, command: str, output: str, words: list[str], progress: Callable[[int, int], object] | None = None
    ) -> None:
        """Runs the program on the loaded text, even if the scene's file has changed since."""
        folder, name = os.path.split(self._place.file_name)
        with tempfile.TemporaryDirectory(prefix="poinsot-") as scratch:
            copy = Path(scratch) / name
            copy.write_text(self.text, encoding="utf-8")
            allowed = [f"--asset-root={root}" for root in (folder or ".", *self._place.asset_roots)]
            allowed += [f"--limit={word}" for word in self._place.limits]
            overrides = [word for override in self._place.overrides for word in ("-D", override)]
            _program.run(command, output, [*words, *allowed, *overrides, "--", str(copy)], progress)

    def _repr_png_(self) -> bytes:
        width, height = self.size
        shown = min(width, _DISPLAY_WIDTH)
        return self._core.png(None, (shown, max(16, round(height * shown / width))))

    def __repr__(self) -> str:
        width, height = self.size
        return f"<poinsot scene {self.name!r}: {self.duration:g} s, {width}x{height}>"
