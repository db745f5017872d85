# SPDX-License-Identifier: Apache-2.0
"""A system with a poinsot that draws. Scenes go in and pictures come out as tar, so that a chroot, a container and
another machine are all one: a command that runs a shell command there."""

import io
import re
import shlex
import subprocess
import tarfile
from pathlib import Path

LONGEST_S = 3600  # of one command; a sound drawing of all pictures takes a minute or two
ERROR_LINES = 8


class Failure(Exception):
    """Why nothing can be measured."""


class System:
    """A program on this machine, or behind `enter`."""

    def __init__(self, program):
        self.program = program
        self.enter = None  # command line
        self.name = None  # in place of what the system calls itself

    def probe(self):
        """Its facts, and its back ends: name, whether it works, and the renderer or why not."""
        program = self.quoted()
        text = self.run(f"set -e; . /etc/os-release; echo $PRETTY_NAME; {program} --version; {program} doctor || true").decode()
        system, version = text.splitlines()[:2]
        findings = re.sub(r"\n {8,}", " ", text)  # a finding may take several lines
        backends = [(name, state == "ok", detail)
                    for state, name, detail in re.findall(r"^(ok|absent|BAD) +OpenGL (\w+) +(.*)$", findings, re.MULTILINE)]
        working = "\n".join(detail for _, works, detail in backends if works)
        if not working:
            raise Failure(f"{self.name or system}: no back end works:\n{text}")
        drivers = {fact: match.group(1) if (match := re.search(pattern, working)) else None
                   for fact, pattern in (("mesa", r"Mesa (\d[\w.+~-]*)"), ("llvm", r"LLVM ([\d.]+)"))}
        facts = {"system": self.name or system, "program": version, **drivers}
        return facts, backends

    def draw(self, commands, files, folder):
        """Runs commands of the program beside files, and keeps the pictures that they make.

        commands: words of each, and the largest exit code that is none of a fault. files: bytes by relative path.
        """
        lines = [f"{self.quoted()} {shlex.join(command)} || [ $? -le {most} ]" for command, most in commands]
        script = "\n".join(["set -eu", "folder=$(mktemp -d)", "trap 'rm -rf \"$folder\"' EXIT", 'cd "$folder"', "tar xf -",
                            "{", *lines, "} </dev/null >&2", "tar cf - stills suite"])
        unpack(self.run(script, tar_of(files)), folder)

    def quoted(self):
        return shlex.quote(self.program if self.enter else str(Path(self.program).resolve()))

    def run(self, script, given=b""):
        """What a shell script writes there. @raises Failure"""
        command = [*shlex.split(self.enter or "sh -c"), script]
        try:
            done = subprocess.run(command, input=given, capture_output=True, timeout=LONGEST_S)
        except subprocess.TimeoutExpired:
            raise Failure(f"{self.program}: did not end within {LONGEST_S} s") from None
        if done.returncode:
            last = done.stderr.decode(errors="replace").splitlines()[-ERROR_LINES:]
            raise Failure("\n".join([f"{self.program}: exit code {done.returncode}", *last]))
        return done.stdout


def tar_of(files):
    archive = io.BytesIO()
    with tarfile.open(fileobj=archive, mode="w") as tar:
        for path, content in files.items():
            entry = tarfile.TarInfo(str(path))
            entry.size = len(content)
            tar.addfile(entry, io.BytesIO(content))
    return archive.getvalue()


def unpack(archive, folder):
    """Keeps the pictures of an archive, each directly below its set's folder; maps of a difference are none."""
    with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
        for entry in tar:
            path = Path(entry.name)
            if not entry.isfile() or path.suffix != ".png" or Path(path.stem).suffix in (".flip", ".difference"):
                continue
            place = folder / path.parts[0] / path.name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(tar.extractfile(entry).read())
