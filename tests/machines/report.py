# SPDX-License-Identifier: Apache-2.0
"""Judges the figures of a trial, and prints them."""

GATED = ("bookworm", "trixie")  # other suites change daily and are only reported
MOST_SKIPS = 25
MOST_SECONDS = 60  # for installing the package and making a film, after the download
# README.md promises size, rate and codec; the scene lasts 14 s.
FILM = {"codec": "h264", "width": 1920, "height": 1080, "fps": "30/1", "frames": 420}
GOOD_VERDICTS = {"identical", "near"}


def problems(report):
    """Returns a sentence for each promise that a suite's figures break."""
    if "failure" in report:
        return [report["failure"]]
    commands, found = report["commands"], []
    found += [f"{name}: exit {done['status']}" for name, done in commands.items() if done["status"] != 0]
    for key, name in (("film", "render"), ("installed_film", "film")):
        if name in commands and report.get(key) != FILM:
            found.append(f"{name}: the film is {film(report.get(key))} and not {film(FILM)}")
    if "test" in commands:
        found += _test_problems(report)
    if "film" in commands and (seconds := to_film(commands)) > MOST_SECONDS:
        found.append(f"package: {seconds:.0f} s from the download to a film, more than {MOST_SECONDS}")
    if count := len(report.get("warnings", [])):
        found.append(f"warnings of {report['compiler']}: {count}, the first: {report['warnings'][0]}")
    return found


def _test_problems(report):
    if "tests" not in report:
        return ["test: CTest did not print its summary"]
    tests, found = report["tests"], [f"test: {name}: {word}" for name, word in report["tests"]["failed"].items()]
    if tests["passed"] == 0:
        found.append("test: no test passed")
    if (count := skipped(tests)) > MOST_SKIPS:
        found.append(f"test: {count} tests were skipped, more than {MOST_SKIPS}")
    pictures = report.get("pictures") or {"not compared": 0}
    found += [f"pictures: {count} {verdict}" for verdict, count in pictures.items() if verdict not in GOOD_VERDICTS]
    return found


def skipped(tests):
    return sum(map(len, tests["skipped"].values()))


def to_film(commands):
    return commands["install"]["seconds"] + commands["film"]["seconds"]


def film(facts):
    return "{codec} {width}x{height}, {fps} fps, {frames} frames".format(**facts) if facts else "absent"


def megabytes(count):
    return f"{count / 1e6:.1f} MB"


def markdown(suites):
    """Returns a table with a column for each suite, and below it the reasons of skipped tests and the problems."""
    reports = list(suites.values())
    rows = {}
    for name in dict.fromkeys(name for report in reports for name in report["versions"]):
        rows[name] = [report["versions"].get(name) for report in reports]
    for name in dict.fromkeys(name for report in reports for name in report["commands"]):
        rows[name] = [_command(report["commands"].get(name)) for report in reports]
    for name, cell in CELLS.items():
        rows[name] = [_cell(cell, report) for report in reports]
    lines = [_row("", suites), "| --- |" + " --- |" * len(suites), _row("date", [report["date"] for report in reports])]
    lines += [_row(name, cells) for name, cells in rows.items() if any(cells)]
    for suite, report in suites.items():
        lines += _list(f"{suite}, skipped", [f"{reason}: {', '.join(names)}"
                                             for reason, names in report.get("tests", {"skipped": {}})["skipped"].items()])
        lines += _list(f"{suite}, {'broken' if suite in GATED else 'broken (reported only)'}", problems(report))
    return "\n".join(lines) + "\n"


CELLS = {
    "tests passed": lambda report: str(report["tests"]["passed"]),
    "tests failed": lambda report: str(len(report["tests"]["failed"])),
    "tests skipped": lambda report: str(skipped(report["tests"])),
    "pictures compared": lambda report: ", ".join(f"{count} {verdict}" for verdict, count in report["pictures"].items()),
    "compiler warnings": lambda report: str(len(report["warnings"])),
    "film": lambda report: film(report["film"]),
    "packages": lambda report: ", ".join(f"{name.split('_')[0]} {megabytes(size)}" for name, size in report["packages"].items()),
    "downloaded": lambda report: megabytes(report["download_bytes"]),
    "installed": lambda report: megabytes(report["installed_bytes"]),
    "from the download to a film": lambda report: f"{to_film(report['commands']):.1f} s",
    "film of the package": lambda report: film(report["installed_film"]),
}


def _cell(cell, report):
    try:
        return cell(report)
    except KeyError:  # the part was not requested, or not reached
        return None


def _command(done):
    if done is None:
        return None
    apt = f" (apt {done['apt_seconds']:.0f} s)" if done.get("apt_seconds") else ""
    return f"exit {done['status']}, {done['seconds']:.1f} s{apt}"


def _row(name, cells):
    return "| " + " | ".join([name, *(cell or "" for cell in cells)]) + " |"


def _list(heading, lines):
    return ["", f"**{heading}**", "", *(f"- {line}" for line in lines)] if lines else []
