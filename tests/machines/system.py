# SPDX-License-Identifier: Apache-2.0
"""A system on which poinsot draws. Scenes and pictures are sent as tar archives, so that a chroot, a container or another
machine needs only a command that runs a shell command there."""

import io
import re
import shlex
import subprocess
import tarfile
from pathlib import Path

LONGEST_S = 3600  # limit of one command; drawing all pictures normally takes a minute or two
ERROR_LINES = 8


class Failure(Exception):
    """Nothing can be measured. The message has the reason."""


class System:
    """A poinsot program on this machine, or on the system that the command `enter` reaches."""

    def __init__(self, program):
        self.program = program
        self.enter = None  # command line
        self.name = None  # replaces the system's own name

    def probe(self):
        """Returns facts of the system, and its back ends: name, whether it works, and the renderer or the reason."""
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
        """Runs commands of the program in a folder with `files`, and stores their pictures in `folder`.

        commands: words of each, and the largest accepted exit code. files: contents by relative path.
        """
        lines = [f"{self.quoted()} {shlex.join(command)} || [ $? -le {most} ]" for command, most in commands]
        script = "\n".join(["set -eu", "folder=$(mktemp -d)", "trap 'rm -rf \"$folder\"' EXIT", 'cd "$folder"', "tar xf -",
                            "{", *lines, "} </dev/null >&2", "tar cf - stills suite"])
        unpack(self.run(script, tar_of(files)), folder)

    def quoted(self):
        return shlex.quote(self.program if self.enter else str(Path(self.program).resolve()))

    def run(self, script, given=b""):
        """Runs a shell script on the system, and returns its output. @raises Failure"""
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
    """Extracts the pictures of an archive into the folder of their set, without subfolders and difference maps."""
    with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
        for entry in tar:
            path = Path(entry.name)
            if not entry.isfile() or path.suffix != ".png" or Path(path.stem).suffix in (".flip", ".difference"):
                continue
            place = folder / path.parts[0] / path.name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(tar.extractfile(entry).read())
