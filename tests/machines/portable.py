#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tries the portable archive on bare Debian systems, as an ordinary user without a network: it makes a film, and runs a
golden suite. With --wheel, it also makes a wheel on each system, and tries it on another bare system with Python, pip
and NumPy. Needs root; needs a network only to make the systems."""

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

import room as rooms
from room import Failure, Room

ROOT = Path(__file__).resolve().parents[2]
NOBODY = 65534
# Words that start a command as an ordinary user without a network.
AS_USER = ["unshare", "--net", "setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups", "sh", "-euc"]
FILM_AND_SUITE = """
cd; poinsot --version
! command -v gcc >/dev/null && ! ls -d /usr/lib/*/libGL* /usr/lib/*/dri 2>/dev/null  # nothing of the system helps
poinsot doctor | grep '^ok'
poinsot render "$SCENES/tennis_racket.toml" -o racket.mp4
printf 'size = [320, 180]\\n[[test]]\\nscene = "%s/football.toml"\\n[[test]]\\nscene = "%s/heavy_top.toml"\\n' "$SCENES" "$SCENES" >golden.toml
poinsot golden --asset-root "$SCENES" --update
poinsot golden --asset-root "$SCENES" --report report.html
printf damaged >golden/football.png
poinsot golden --asset-root "$SCENES" && exit 1 || [ $? = 1 ]
"""
ARCHIVE = """
export PATH="$(echo /opt/poinsot-*)/bin:$PATH" SCENES="$(echo /opt/poinsot-*/share/poinsot/scenes)"
""" + FILM_AND_SUITE
WHEEL = """
cd; python3 -m venv --system-site-packages venv  # for Debian's NumPy, because pip has no network
venv/bin/pip install --no-index --quiet /opt/poinsot-*.whl
export PATH="$PWD/venv/bin:$PATH" SCENES="$(venv/bin/python -c 'import pathlib, poinsot; print(next(pathlib.Path(poinsot.__file__).parent.rglob("scenes")))')"
venv/bin/python - <<'END'
import numpy as np, poinsot
scene = poinsot.loads('[body]\\nprincipal_moments = [1, 2, 3]\\n[motion]\\nomega_body = [0.1, 2, 0]\\n')
picture = scene.render(0.5, size=(320, 180))
assert picture.shape == (180, 320, 3) and picture.std() > 1, picture.shape
assert poinsot.diff(picture, picture)["verdict"] == "identical"
END
""" + FILM_AND_SUITE


def words():
    parser = argparse.ArgumentParser(prog="tests/machines/portable.py", description=__doc__)
    parser.add_argument("archive", type=Path, help="the archive that packaging/portable makes")
    parser.add_argument("suite", nargs="*", default=["bookworm", "trixie", "sid"])
    parser.add_argument("--wheel", action="store_true", help="also make and try a wheel on each system")
    parser.add_argument("--cache", type=Path, default=ROOT / "build" / "machines", help="folder of the bare systems (default: build/machines)")
    return parser.parse_args()


class Trial:
    def __init__(self, suite, asked, mirror):
        self.suite, self.asked, self.mirror = suite, asked, mirror
        self.folder = asked.cache.resolve() / suite
        self.failed = []

    def run(self):
        rooms.make_base(self.suite, self.mirror, self.folder, afresh=False)
        self._try("archive", self._with_archive(), ARCHIVE)
        if self.asked.wheel:
            self._try("wheel", self._with_wheel(self._made_wheel()), WHEEL)
        return not self.failed

    def _with_archive(self):
        room = Room(self.folder, "portable")
        subprocess.run(["tar", "--no-same-owner", "-xJf", self.asked.archive, "-C", room.path / "opt"], check=True)
        return room

    def _made_wheel(self):
        room = Room(self.folder, "wheelwright")
        room.clone(ROOT)
        self._prepare(room, "python3")
        made = room.run(["sh", "-c", "python3 packaging/portable --wheel"], self.folder / "wheel_made.log")
        wheels = sorted((room.path / "src/poinsot/build").glob("*.whl"))
        if made.status != 0 or not wheels:
            raise Failure(f"{self.suite}: no wheel; see {self.folder / 'wheel_made.log'}")
        kept = shutil.copy(wheels[-1], self.folder)
        rooms.remove(room.path)
        print(f"{self.suite}: {Path(kept).name}, {Path(kept).stat().st_size / 1e6:.1f} MB", flush=True)
        return Path(kept)

    def _with_wheel(self, wheel):
        room = Room(self.folder, "portable")
        self._prepare(room, "python3-venv", "python3-numpy")
        shutil.copy(wheel, room.path / "opt")
        return room

    def _prepare(self, room, *packages):
        for command in (["update", "-qq"], ["install", "-y", "-qq", "--no-install-recommends", *packages]):
            if room.run(["env", "DEBIAN_FRONTEND=noninteractive", "apt-get", *command], self.folder / "prepare.log").status != 0:
                raise Failure(f"{self.suite}: apt could not install {' '.join(packages)}; see {self.folder / 'prepare.log'}")

    def _try(self, what, room, script):
        os.chown(room.path / "home/trial", NOBODY, NOBODY)
        log = self.folder / f"{what}.log"
        outcome = room.run([*AS_USER, script], log)
        if outcome.status == 0:
            for name in ("racket.mp4", "report.html"):
                shutil.copy(room.path / "home/trial" / name, self.folder / f"{what}_{name}")
            rooms.remove(room.path)
        else:
            self.failed.append(what)
        print(f"{self.suite}: {what}: {'film and suite in %.0f s' % outcome.seconds if outcome.status == 0 else 'failed; see %s' % log}", flush=True)


def main():
    asked = words()
    if os.geteuid() != 0:
        raise SystemExit("tests/machines/portable.py needs root, for chroot and mounts: start it with sudo")
    mirror = rooms.configured_mirror()
    try:
        return 0 if all([Trial(suite, asked, mirror).run() for suite in asked.suite]) else 1
    except Failure as failure:
        raise SystemExit(str(failure)) from None


if __name__ == "__main__":
    sys.exit(main())
