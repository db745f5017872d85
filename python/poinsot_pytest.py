# SPDX-License-Identifier: Apache-2.0
"""Plugin of pytest for golden images: the fixture and the marker `golden`. See docs/pytest.md.

It is a module of its own, so that pytest starts without importing poinsot where no test needs it.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from poinsot._golden import Run

_FROM = ("pytest-mpl",)


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("golden", "golden images (poinsot)")
    group.addoption(
        "--golden-update",
        nargs="?",
        const="*",
        metavar="PATTERN",
        help="approve the new pictures whose names match PATTERN (* matches any characters; default: all), and print "
        "how far each is from its baseline; not in CI. Write --golden-update=PATTERN if a path follows",
    )
    group.addoption(
        "--golden-output", metavar="FOLDER", help="folder of new pictures and of report.html (default: golden_output, or out/golden)"
    )
    group.addoption("--golden-json", metavar="FILE", help="write the outcome as a JSON object, as poinsot golden --json")
    group.addoption("--golden-markdown", metavar="FILE", help="add a table in Markdown to FILE, such as $GITHUB_STEP_SUMMARY")
    group.addoption("--golden-from", choices=_FROM, help="compare with the baselines, marks and tolerances of another plugin")
    parser.addini("golden_folder", "folder of the baselines, beside each file of tests", default="golden")
    parser.addini("golden_output", "folder of new pictures and of report.html", default="out/golden")
    parser.addini("golden_rule", "named rule of tests without a rule: same, near or other_driver", default="near")
    parser.addini("golden_from", "plugin whose baselines, marks and tolerances are used, such as pytest-mpl", default="")


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line(
        "markers",
        "golden(rule, name, ignore, mask, level, max, pixels, flip_mean, flip_max, reason, save): compares the picture "
        "that the test returns with its baseline",
    )
    if _origin(config):
        config.addinivalue_line("markers", "mpl_image_compare: compares the figure that the test returns, as pytest-mpl does")
    if config.option.golden_update is not None and os.environ.get("CI"):
        raise pytest.UsageError(
            "--golden-update: the environment variable CI is set, and nobody sees the pictures there; look at them on "
            "your own machine, and approve them there"
        )
    config.pluginmanager.register(_Session(config), "poinsot-golden-session")


def _origin(config: pytest.Config) -> str:
    origin = config.option.golden_from or config.getini("golden_from")
    if origin and origin not in _FROM:
        raise pytest.UsageError(f"golden_from = {origin}: must be one of {', '.join(_FROM)}")
    return str(origin)


def _selects(config: pytest.Config) -> bool:
    """Reports whether pytest runs some tests of a file only."""
    options = ("keyword", "markexpr", "deselect", "lf", "stepwise")
    return any(getattr(config.option, name, None) for name in options) or any("::" in word for word in config.args)


class _Session:
    """Hooks that need the state of a run. With pytest-xdist, each worker has one, and the controller has one."""

    def __init__(self, config: pytest.Config) -> None:
        self.config = config
        self.outcomes: list[dict[str, Any]] = []  # all outcomes of the run, in the process that reports
        self.unfinished: set[str] = set()  # files of tests of which a test did not compare all its pictures
        self._run: Run | None = None

    @property
    def run(self) -> Run:
        if self._run is None:
            from poinsot._golden import Run

            option = self.config.option
            self._run = Run(
                root=self.config.rootpath,
                output=self.config.rootpath / (option.golden_output or self.config.getini("golden_output")),
                folder=self.config.getini("golden_folder"),
                rule=self.config.getini("golden_rule"),
                update=option.golden_update,
                origin=_origin(self.config),
                json=option.golden_json,
                markdown=option.golden_markdown,
            )
        return self._run

    @pytest.fixture
    def golden(self, request: pytest.FixtureRequest) -> Any:
        """Compares pictures with their baselines: golden(picture, name=None, **limits)."""
        return self._test(request.node)

    def _test(self, item: Any) -> Any:
        if not hasattr(item, "poinsot_golden"):
            item.poinsot_golden = self.run.test(item)
        return item.poinsot_golden

    def _is_marked(self, item: pytest.Item) -> bool:
        marks = ("golden", "mpl_image_compare") if _origin(self.config) else ("golden",)
        return any(item.get_closest_marker(mark) for mark in marks)

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtest_setup(self, item: Any) -> None:
        if self._is_marked(item) or "golden" in getattr(item, "fixturenames", ()):
            item.obj = self._test(item).wrapped(item.obj, self._is_marked(item))

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_makereport(self, item: Any, call: pytest.CallInfo[None]) -> Any:
        outcome = yield
        test = getattr(item, "poinsot_golden", None)
        if call.when == "call" and test is not None:
            report = outcome.get_result()
            # pytest-xdist sends plain attributes of a report to the controller.
            report.poinsot_golden = test.outcomes
            item.user_properties += test.properties()  # pytest writes them into its JUnit report

    def pytest_runtest_logreport(self, report: Any) -> None:
        outcomes = getattr(report, "poinsot_golden", ())
        self.outcomes += outcomes
        if report.outcome != "passed" and not any(it["status"] in ("different", "new") for it in outcomes):
            self.unfinished.add(report.nodeid.partition("::")[0])

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        if session.shouldstop or session.shouldfail or _selects(self.config):
            self.unfinished |= {it["file"] for it in self.outcomes}
        if self.outcomes and not hasattr(self.config, "workerinput"):
            self.run.write_report(self.outcomes)

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        if self.outcomes:
            terminalreporter.section("golden images")
            for line in self.run.summary(self.outcomes, self.unfinished):
                terminalreporter.write_line(line)
