# SPDX-License-Identifier: Apache-2.0
"""Reads figures from the output of other programs: CTest, GoogleTest, compilers, dpkg, ffprobe, poinsot."""

import collections
import json
import re

NO_REASON = "no reason was printed"
VERSIONS = {"GCC": "g++", "Clang": "clang", "CMake": "cmake", "Mesa": "libgl1-mesa-dri", "FFmpeg": "libavcodec-dev",
            "Eigen": "libeigen3-dev", "Python": "python3"}


def ctest_summary(text):
    """Returns CTest's summary: the number of passed tests, and the names of tests that failed or did not run, with the
    status that CTest prints. Returns None if CTest printed no summary.
    """
    total = re.search(r"^\d+% tests passed, (\d+) tests? failed out of (\d+)$", text, re.M)
    if total is None:
        return None
    absent, failed = (_named(text, heading) for heading in ("did not run", "FAILED"))
    # CTest counts skipped tests as passed, and does not count disabled tests.
    skipped = sum(word != "Disabled" for word in absent.values())
    return {"passed": int(total[2]) - int(total[1]) - skipped, "failed": failed, "not_run": absent}


def _named(text, heading):
    block = re.search(rf"^The following tests {heading}:\n((?:\s*\d+ - .*\n?)*)", text, re.M)
    # Newer versions of CTest append the labels of a test.
    return dict(re.findall(r"^\s*\d+ - (\S+) \(([^)]*)\)", block[1], re.M)) if block else {}


def test_outputs(log):
    """Returns the output of each test, by its name. @param log  text of LastTest.log"""
    parts = re.findall(r"^\d+/\d+ Test: (\S+)\n.*?^Output:\n-+\n(.*?)^<end of output>$", log, re.M | re.S)
    return dict(parts)


def skip_reason(output):
    """Returns why a test skipped itself: GoogleTest's message, else the last line of its output."""
    message = re.search(r"^\S+:\d+: Skipped\n(.*?)\n*^\[", output, re.M | re.S)
    text = message[1] if message else (output.strip().splitlines() or [""])[-1]
    return " ".join(text.split()) or NO_REASON


def skips(not_run, log):
    """Returns the names of tests that did not run, by the reason. @param log  text of LastTest.log"""
    outputs, reasons = test_outputs(log), collections.defaultdict(list)
    for name, word in not_run.items():
        reasons[skip_reason(outputs.get(name, "")) if word == "Skipped" else word.lower()].append(name)
    return dict(reasons)


def warnings(log):
    """Returns the warnings of compilers, without duplicates."""
    return list(dict.fromkeys(line.strip() for line in log.splitlines() if re.search(r"\bwarning: ", line)))


def versions(dpkg):
    """Returns the versions of the installed programs in VERSIONS. @param dpkg  lines of package, state and version"""
    rows = [line.split() for line in dpkg.splitlines()]
    there = {row[0].split(":")[0]: row[2] for row in rows if len(row) == 3 and row[1] == "installed"}
    return {name: upstream(there[package]) for name, package in VERSIONS.items() if package in there}


def upstream(version):
    """Returns a Debian version without epoch, revision, and suffixes such as +dfsg."""
    return re.sub(r"(\+(dfsg|ds|deb)|~).*", "", version.split(":")[-1].rsplit("-", 1)[0])


def film(text):
    """Returns the facts of a film. @param text  ffprobe's JSON of its first video stream, with counted packets"""
    try:
        stream = json.loads(text)["streams"][0]
        return {"codec": stream["codec_name"], "width": stream["width"], "height": stream["height"],
                "fps": stream["avg_frame_rate"], "frames": int(stream["nb_read_packets"])}
    except (ValueError, LookupError):
        return None


def verdicts(text):
    """Returns the number of pictures of a golden suite with each verdict. @param text  JSON of `poinsot golden --json`"""
    try:
        return dict(collections.Counter(picture["verdict"] for picture in json.loads(text)["pictures"]))
    except (ValueError, LookupError):
        return {}


def apt_seconds(outcome):
    """Returns the seconds from the launcher's note "installing" to its next note; 0 if it installed nothing."""
    begin = next((time for line, time in zip(outcome.lines, outcome.since_s) if line.startswith("poinsot: installing ")), None)
    if begin is None:
        return 0
    after = (time for line, time in zip(outcome.lines, outcome.since_s) if time > begin and line.startswith("poinsot: "))
    return next(after, outcome.seconds) - begin
