# SPDX-License-Identifier: Apache-2.0
"""Golden images in pytest: comparisons with baselines, and the report of a run. poinsot_pytest.py has pytest's hooks."""

from __future__ import annotations

import fnmatch
import functools
import hashlib
import os
import re
import shlex
import shutil
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any, NoReturn, TypeVar

import pytest

from . import _core
from ._adopted import adopted
from ._diff import diff, rule_words
from ._errors import Error, UsageError
from ._golden_settings import Settings, settings_of
from ._packages import imported
from ._saved_picture import close, extension_of, save

_LONGEST = 150  # characters of a file's name
_FAILING = ("different", "new", "error")
_FIGURES = ("max_difference", "differing_pixels", "rmse", "flip", "change", "beyond", "notes")
Outcome = dict[str, Any]
_Made = TypeVar("_Made")


class Run:
    """A run of pytest: where its files are, and how new pictures are compared."""

    def __init__(
        self, *, root: Path, output: Path, folder: str, rule: str, update: str | None, origin: str, json: str | None, markdown: str | None
    ) -> None:
        self.root, self.output, self.folder, self.rule, self.update, self.origin = root, output, folder, rule, update, origin
        self.json, self.markdown = json, markdown
        self.report = output / "report.html"
        self.command = "pytest" + (f" --golden-from={origin}" if origin else "")

    def test(self, item: Any) -> Test:
        return Test(self, item)

    def shown(self, path: Path) -> str:
        """Returns a path relative to pytest's root folder, if it is inside."""
        return str(path.relative_to(self.root)) if path.is_relative_to(self.root) else str(path)

    def write_report(self, outcomes: list[Outcome]) -> None:
        """Writes the HTML page of all outcomes of a run."""
        self.output.mkdir(parents=True, exist_ok=True)
        rows = [(it["name"], it["status"], it["message"], it["place"], it["baseline"], it["new"], it["rule"], it["ignore"], it["mask"]) for it in outcomes]
        json, markdown = _core.write_golden_report(os.fsencode(self.report), self.root.name, os.fsencode(self.root), rows, len(os.sched_getaffinity(0)))
        if self.json:
            Path(self.json).write_text(json)
        if self.markdown:
            with open(self.markdown, "a") as file:
                file.write(markdown)

    def summary(self, outcomes: list[Outcome], unfinished: set[str]) -> Iterator[str]:
        """Returns the lines of the terminal's summary. unfinished: files of tests whose unused baselines are not known"""
        unused = _unused([it for it in outcomes if it["file"] not in unfinished])
        counts = Counter([*(it["status"] for it in outcomes), *("unused" for _ in unused)])
        yield ", ".join(f"{count} {status}" for status, count in sorted(counts.items()))
        for it in outcomes:
            if it["status"] in ("approved", "near", *_FAILING):
                yield f"{it['status']:<10} {it['name']}: {it['message']}"
        for path in unused:
            yield f"{'unused':<10} {self.shown(path)}: no test compares a picture with it; remove it if its test is gone"
        yield f"report: {self.shown(self.report)}"
        if any(it["status"] in _FAILING for it in outcomes):
            yield "if new pictures are right, approve them: run pytest again with --golden-update=NAME (* matches any characters)"


class Test:
    """The pictures of one test. This object is the fixture `golden`."""

    __test__ = False  # pytest must not collect it

    def __init__(self, run: Run, item: Any) -> None:
        self.run, self.item = run, item
        self.outcomes: list[Outcome] = []
        self._failures: list[str] = []
        parts = item.nodeid.split("::")
        self._id = ".".join(parts[1:]) or item.name
        self._file = Path(item.path)
        self._names: set[str] = set()

    def __call__(self, picture: Any, name: str | None = None, **settings: Any) -> None:
        """Compares a picture with its baseline. A difference fails the test when it ends, so that later pictures are compared, too.

        picture: a Matplotlib figure, a PIL image, an array of uint8 or uint16, a PyVista plotter, a poinsot scene, or the
            path of a PNG or a film.
        name: name of the picture, if the test compares several.
        settings: the arguments of the marker `golden`.
        """
        __tracebackhide__ = True
        self._compare(picture, self._settings(**settings, **({} if name is None else {"name": name})))

    def wrapped(self, function: Callable[..., Any], is_marked: bool) -> Callable[..., None]:
        """Returns a function that runs a test, compares the picture that it returns, and fails if a picture differs."""

        @functools.wraps(function)
        def compared(*arguments: Any, **named: Any) -> None:
            __tracebackhide__ = True
            settings = self._adopted()
            with ExitStack() as context:
                _draw_alike(context, settings.style if settings else "default", settings.backend if settings else "agg")
                returned = function(*arguments, **named)
                if is_marked:
                    self._compare(returned, settings or self._settings())
                    close(returned)
            if self._failures:
                _fail("\n".join(self._failures))

        return compared

    def properties(self) -> list[tuple[str, str]]:
        """Returns properties for the JUnit report."""
        found = []
        for it in self.outcomes:
            found += [("golden", f"{it['name']}: {it['status']}"), ("golden_message", it["message"])]
            found += [(f"golden_{side}", os.fsdecode(it[side])) for side in ("baseline", "new") if it[side]]
            found += [(f"golden_{key}", str(value)) for key, value in it["figures"].items() if isinstance(value, (int, float))]
        return [(key, value) for key, value in found if value]

    def _settings(self, **more: Any) -> Settings:
        """Returns the settings of the marker and of a call."""
        mark = self.item.get_closest_marker("golden")
        if mark is not None and mark.args:
            _fail(f"golden({', '.join(map(repr, mark.args))}): takes named arguments only, such as golden(rule='same')")
        return _without_traceback(lambda: settings_of({**(mark.kwargs if mark else {}), **more}, self.run.rule))

    def _adopted(self) -> Settings | None:
        return _without_traceback(lambda: adopted(self.item)) if self.run.origin else None

    def _places(self, picture: Any, settings: Settings) -> tuple[str, Path, Path]:
        """Returns the name of a picture, its baseline and the file for the new picture."""
        extension = extension_of(picture)
        own = self._id if settings.name is None else f"{self._id}-{settings.name}"
        safe = _file_name(own)
        folder = self._file.parent
        module = folder.relative_to(self.run.root) / self._file.stem if folder.is_relative_to(self.run.root) else Path(self._file.stem)
        baseline = settings.baseline or folder / self.run.folder / self._file.stem / (safe + extension)
        name = str(module / safe)
        if name in self._names:
            _fail(f"golden: {own} is the name of an earlier picture of this test; give each picture a name: golden(picture, name='after')")
        self._names.add(name)
        return name, baseline, self.run.output / module / (safe + extension)

    def _compare(self, picture: Any, settings: Settings) -> None:
        __tracebackhide__ = True
        name, baseline, new = self._places(picture, settings)
        new.parent.mkdir(parents=True, exist_ok=True)
        new.unlink(missing_ok=True)
        outcome: Outcome = {"name": name, "status": "error", "message": "", "figures": {}, "place": os.fsencode(baseline), "baseline": b"", "new": b"",
                            "file": self.item.nodeid.partition("::")[0], "is_own": settings.baseline is None, "rule": settings.words, "ignore": settings.ignore, "mask": settings.mask}
        self.outcomes.append(outcome)
        try:
            save(picture, new, settings)
            outcome["new"] = os.fsencode(new)
            self._judge(outcome, baseline, new, settings)
        except Error as error:
            outcome["message"] = str(error)
        if self._is_to_approve(outcome):
            self._approve(outcome, baseline, new)
        if outcome["status"] in _FAILING:
            self._failures.append(self._failure(outcome, baseline, new))

    def _judge(self, outcome: Outcome, baseline: Path, new: Path, settings: Settings) -> None:
        """Sets the status and the message of an outcome."""
        if not os.path.lexists(baseline):
            outcome.update(status="new", message="nothing was approved yet")
            return
        outcome["baseline"] = os.fsencode(baseline)
        try:
            found = diff(baseline, new, dict(settings.rule), ignore=settings.boxes, mask=os.fsdecode(settings.mask) or None)
        except UsageError as error:
            if "only pictures of the same size" not in str(error):
                raise
            outcome.update(status="different", message=str(error).partition(": only")[0])
            return
        outcome["figures"] = {key: found[key] for key in _FIGURES if key in found}
        if found.get("flip"):
            outcome["figures"].update(flip_mean=found["flip"]["mean"], flip_max=found["flip"]["max"])
        outcome["status"] = found["verdict"]
        said = [*found.get("beyond", ()), found.get("change") or ""]
        outcome["message"] = "; ".join(word for word in said if word)
        if settings.tolerance is not None:
            _apply_tolerance(outcome, settings.tolerance)

    def _is_to_approve(self, outcome: Outcome) -> bool:
        pattern = self.run.update
        names = (outcome["name"], Path(outcome["name"]).name, self.item.nodeid, self.item.name)
        asked = pattern is not None and any(it == pattern or fnmatch.fnmatchcase(it, _star(pattern)) for it in names)
        return asked and outcome["status"] in ("different", "new", "near")

    def _approve(self, outcome: Outcome, baseline: Path, new: Path) -> None:
        """Copies the new picture to the baseline, which is then complete or unchanged."""
        if baseline.is_symlink():
            outcome.update(status="error", message=f"{baseline}: is a link, which is not replaced; remove it first")
            return
        part = baseline.with_name(f".{baseline.name}.{os.getpid()}.part")
        try:
            baseline.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(new, part)
            os.replace(part, baseline)
        except OSError as error:
            part.unlink(missing_ok=True)
            outcome.update(status="error", message=f"{baseline}: cannot be written: {error.strerror}")
            return
        figures = outcome["figures"]
        change = "first baseline"
        if figures:
            change = (f"{figures['differing_pixels']} pixels changed, largest difference {figures['max_difference']:g}, "
                      f"FLIP mean {figures['flip_mean']:.3g}, max {figures['flip_max']:.3g}")
        elif outcome["status"] == "different":
            change = outcome["message"]
        outcome.update(status="approved", message=change, baseline=os.fsencode(baseline))

    def _failure(self, outcome: Outcome, baseline: Path, new: Path) -> str:
        lines = [f"golden: {outcome['status']}: {outcome['name']}: {outcome['message']}"]
        if outcome["baseline"]:
            lines.append(f"  baseline: {self.run.shown(baseline)}")
        if outcome["new"]:
            lines.append(f"  new:      {self.run.shown(new)}")
            if outcome["status"] != "error":
                lines.append(f"  if the new picture is right, approve it: {self.run.command} {shlex.quote(self.item.nodeid)} --golden-update")
        return "\n".join(lines)


def _unused(outcomes: list[Outcome]) -> list[Path]:
    """Returns the files beside the baselines of some tests with which none was compared. Another plugin's baselines are left out,
    because several files of tests share their folder."""
    places = {Path(os.fsdecode(it["place"])) for it in outcomes if it["is_own"]}
    kinds = {place.suffix for place in places}
    return sorted(
        file for folder in {place.parent for place in places} if folder.is_dir()
        for file in folder.iterdir() if file.suffix in kinds and not file.name.startswith(".") and file not in places
    )


def _fail(message: str) -> NoReturn:
    """Fails the test. The message says enough, so pytest shows no traceback."""
    pytest.fail(message, pytrace=False)


def _without_traceback(settings: Callable[[], _Made]) -> _Made:
    try:
        return settings()
    except UsageError as error:
        message = str(error)
    _fail(message)


def _apply_tolerance(outcome: Outcome, tolerance: float) -> None:
    """Lets a picture pass within pytest-mpl's limit for the root mean square. Says so if poinsot's rule would not."""
    rms = outcome["figures"].get("rmse")
    if rms is None:
        return
    if rms > tolerance:
        outcome.update(status="different", message=f"root mean square {rms:.3g} (tolerance {tolerance:g}); {outcome['message']}".rstrip("; "))
    elif outcome["status"] == "different":
        outcome.update(status="near", message=f"passes only by pytest-mpl's tolerance, root mean square {rms:.3g} of {tolerance:g}; {outcome['message']}")


def _draw_alike(context: ExitStack, style: Any, backend: str) -> None:
    """Gives Matplotlib its own defaults instead of the user's, if it is imported."""
    if "matplotlib" not in sys.modules:
        return
    pyplot = imported("matplotlib.pyplot", "golden")
    before = pyplot.get_backend()
    if before.lower() != backend.lower():
        pyplot.switch_backend(backend)
        context.callback(pyplot.switch_backend, before)
    context.enter_context(pyplot.style.context(style, after_reset=True))


def _star(pattern: str) -> str:
    """Returns a pattern of fnmatch in which only * is special, because names of tests contain brackets."""
    return re.sub(r"[\[?]", lambda found: f"[{found[0]}]", pattern)


def _file_name(name: str) -> str:
    """Returns a name for files. Different names stay different: a name that is changed gets a part of its digest."""
    safe = re.sub(r'[\x00-\x1f/\\:*?"<>|]', "_", name).lstrip(".")
    if safe == name and len(safe.encode()) <= _LONGEST:
        return safe
    digest = hashlib.sha256(name.encode(errors="surrogateescape")).hexdigest()[:8]
    return f"{safe.encode()[:_LONGEST].decode(errors='ignore')}~{digest}"
