# SPDX-License-Identifier: Apache-2.0
"""Rooms are folders with a complete Debian system, made by debootstrap and entered by enter.sh. Both need root."""

import os
import re
import shutil
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
BASE_DAYS = 7  # sid may have replaced packages of an older base
DEBIAN = "http://deb.debian.org/debian"


class Failure(Exception):
    """A room cannot be made. The message has the reason."""


@dataclass
class Outcome:
    """Result of a command in a room. `since_s` has the time of each line of its output, from the start."""
    status: int
    seconds: float
    lines: list
    since_s: list

    @property
    def text(self):
        return "\n".join(self.lines)


def configured_mirror():
    """Returns the mirror from which this machine's apt gets Debian, or Debian's own mirror."""
    form = "$(ORIGIN) $(LABEL) $(REPO_URI)"
    try:
        targets = subprocess.run(["apt-get", "indextargets", "--format", form, "Created-By: Packages"],
                                 capture_output=True, text=True).stdout
    except OSError:
        return DEBIAN
    return next((line.split()[2].rstrip("/") for line in targets.splitlines() if line.startswith("Debian Debian ")), DEBIAN)


def mounts_below(folder, table="/proc/self/mounts"):
    """Returns the mount points below a folder, the innermost first, as the kernel's TABLE lists them."""
    points = [line.split()[1] for line in Path(table).read_text().splitlines()]
    points = [re.sub(r"\\([0-7]{3})", lambda match: chr(int(match[1], 8)), point) for point in points]  # a blank is \040
    return [point for point in reversed(points) if point.startswith(f"{os.path.abspath(folder)}/")]


def remove(folder):
    """Deletes a room. Tries again, because processes of an interrupted room may still write.

    It first unmounts what an interrupted debootstrap has left mounted in the room, such as /proc.
    """
    for mounted in mounts_below(folder):
        subprocess.run(["umount", "--lazy", mounted], stderr=subprocess.DEVNULL)
    for _ in range(20):
        if subprocess.run(["rm", "-rf", "--one-file-system", folder], stderr=subprocess.DEVNULL).returncode == 0:
            return
        time.sleep(0.2)
    raise Failure(f"{folder}: cannot be deleted; check which process still writes there")


def make_base(suite, mirror, folder, afresh):
    """Makes FOLDER/base, a system of Debian's required packages and apt, unless there is a recent one."""
    base, half = folder / "base", folder / "base.half"
    if base.exists() and (afresh or time.time() - base.stat().st_mtime > BASE_DAYS * 86400):
        remove(base)
    if base.exists():
        return
    if shutil.which("debootstrap") is None:
        raise Failure("debootstrap is missing: apt-get install debootstrap")
    remove(half)
    (folder / "debs").mkdir(parents=True, exist_ok=True)
    log = folder / "debootstrap.log"
    with open(log, "wb") as file:
        words = ["debootstrap", "--variant=minbase", f"--cache-dir={folder / 'debs'}", suite, half, mirror]
        if subprocess.run(words, stdin=subprocess.DEVNULL, stdout=file, stderr=file).returncode != 0:
            raise Failure(f"debootstrap could not make {suite} from {mirror}; see {log}")
    os.utime(half)
    half.rename(base)


class Room:
    """A fresh copy of a base. It must be deleted by remove()."""

    def __init__(self, folder, name, debs=True):
        self.path = folder / name
        self._debs = folder / "debs" if debs else None
        remove(self.path)
        subprocess.run(["cp", "-a", "--reflink=auto", folder / "base", self.path], check=True)
        for inside in ("home/trial", "src"):
            (self.path / inside).mkdir(parents=True, exist_ok=True)
        if self._debs:
            self._debs.mkdir(exist_ok=True)
        settings = self.path / "etc/apt/apt.conf.d"
        settings.mkdir(parents=True, exist_ok=True)
        # A mirror may be a snapshot, whose lists have expired.
        (settings / "90trial").write_text('APT::Keep-Downloaded-Packages "true";\nAcquire::Check-Valid-Until "false";\n')

    def clone(self, checkout):
        """Clones the committed tree of a checkout into the folder in which commands start."""
        subprocess.run(["git", "clone", "--quiet", "--depth=1", f"file://{checkout}", self.path / "src/poinsot"], check=True)

    def run(self, words, log):
        """Runs a command, and writes all its output to the file `log`."""
        environment = os.environ | {"POINSOT_DEBS": str(self._debs or "")}
        begin, lines, since_s = time.monotonic(), [], []
        with open(log, "w") as file, subprocess.Popen(
                [HERE / "enter.sh", self.path, *words], env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True) as process:
            try:
                for line in process.stdout:
                    file.write(line)
                    lines.append(line.rstrip("\n"))
                    since_s.append(time.monotonic() - begin)
                status = process.wait()
            finally:
                process.kill()  # also ends all processes of the room; does nothing after a normal end
        return Outcome(status, time.monotonic() - begin, lines, since_s)

    def says(self, *words):
        """Returns the standard output of a command."""
        return self.run(["sh", "-c", '"$@" 2>/dev/null', "sh", *words], os.devnull).text
