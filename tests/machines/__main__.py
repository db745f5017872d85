# SPDX-License-Identifier: Apache-2.0
"""Tests the promises of README.md on bare Debian systems, each in its own chroot that debootstrap makes: both commands
as written, then the Debian package in another chroot. Prints a table; needs root and a network."""

import argparse
import fcntl
import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import report
import room
from trial import Trial

ROOT = Path(__file__).resolve().parents[2]
PARTS = ("render", "test", "package")


def words():
    parser = argparse.ArgumentParser(
        prog="tests/machines", description=__doc__,
        epilog=f"Exit code 0 if all promises hold on {' and '.join(report.GATED)}; 1 if one is broken there (other suites are "
               "reported only); 2 usage; 3 if the trial cannot begin; 130 interrupted.")
    parser.add_argument("suite", nargs="*", default=["bookworm", "trixie", "sid"],
                        help="bookworm, trixie, sid or another suite that debootstrap can make (default: these three)")
    parser.add_argument("--cache", type=Path, default=ROOT / "build" / "machines",
                        help="folder for bare systems, downloaded packages, logs and reports (default: build/machines)")
    parser.add_argument("--mirror", help="mirror to install Debian from (default: the mirror of this machine's apt)")
    parser.add_argument("--only", action="append", choices=PARTS, help="run only this part; may be repeated")
    parser.add_argument("--clang", action="store_true", help="build with Clang and run the tests; no other part")
    parser.add_argument("--keep", action="store_true", help="keep the chroots, and print how to enter them")
    parser.add_argument("--afresh", action="store_true", help=f"make bare systems again, even if they are less than {room.BASE_DAYS} days old")
    asked = parser.parse_args()
    for suite in asked.suite:
        if not re.fullmatch(r"[a-z]+", suite):
            parser.error(f"{suite}: not the name of a suite, such as trixie")
    if asked.clang and asked.only:
        parser.error("--clang runs a part of its own: leave out --only")
    asked.only = ["test"] if asked.clang else asked.only or list(PARTS)
    asked.cache = asked.cache.resolve()
    return asked


def say(text):
    print(text, file=sys.stderr, flush=True)


def commit():
    """Returns the commit that is tested. Reports if there are uncommitted changes, which are not tested."""
    git = ["git", "-C", ROOT]
    if subprocess.run([*git, "diff", "--quiet", "HEAD"]).returncode != 0:
        say("uncommitted changes are not tested")
    return subprocess.run([*git, "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()


def tell_of_rooms(asked):
    for suite in dict.fromkeys(asked.suite):
        for name in ("room", "installed"):
            if (asked.cache / suite / name).exists():
                say(f"to look around: {room.HERE / 'enter.sh'} {asked.cache / suite / name}")


def interrupt(*_):
    raise KeyboardInterrupt


def main():
    asked = words()
    if os.geteuid() != 0:
        say("tests/machines needs root, for chroot and mounts: start it with sudo")
        return 3
    for number in (signal.SIGINT, signal.SIGTERM):  # shells let background jobs ignore SIGINT
        signal.signal(number, interrupt)
    asked.cache.mkdir(parents=True, exist_ok=True)
    asked.mirror = asked.mirror or room.configured_mirror()
    with open(asked.cache / ".lock", "w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            say(f"{asked.cache}: another trial is running there; wait for it, or name another folder with --cache")
            return 3
        what = {"commit": commit(), "cpus": len(os.sched_getaffinity(0)), "mirror": asked.mirror}
        try:
            suites = {suite: Trial(suite, asked, ROOT, say).run() for suite in dict.fromkeys(asked.suite)}
        except KeyboardInterrupt:
            say("interrupted; nothing stays mounted")
            return 130
    kind = "clang" if asked.clang else "report"
    table = report.markdown(suites)
    broken = {suite: report.problems(figures) for suite, figures in suites.items()}
    (asked.cache / f"{kind}.md").write_text(table)
    (asked.cache / f"{kind}.json").write_text(json.dumps(what | {"suites": suites, "problems": broken}, indent=1) + "\n")
    print(table, end="")
    say(f"logs, films and packages: {asked.cache}/SUITE/logs; the figures: {asked.cache / (kind + '.json')}")
    tell_of_rooms(asked)
    return 1 if any(broken[suite] for suite in suites if suite in report.GATED) else 0


if __name__ == "__main__":
    sys.exit(main())
