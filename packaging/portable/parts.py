# SPDX-License-Identifier: Apache-2.0
"""Licences and sources of the libraries in a portable poinsot, from the records of Debian's packages."""

import os
import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path


@dataclass
class Part:
    """Source package of Debian, with the files that come from it."""
    source: str
    version: str
    packages: set = field(default_factory=set)
    files: list = field(default_factory=list)

    @property
    def address(self):
        return f"https://snapshot.debian.org/package/{self.source}/{self.version}/"


def _package(path):
    """Returns the package that owns a file. Debian may list /usr/lib/X as /lib/X."""
    for name in (path, path.removeprefix("/usr")):
        found = subprocess.run(["dpkg-query", "-S", name], capture_output=True, text=True)
        if found.returncode == 0:
            return found.stdout.split(": ")[0].split(",")[0]
    raise SystemExit(f"{path}: no package of Debian contains the file, so its licence is unknown")


def parts(paths):
    """Returns the parts that the files come from, by name of their source."""
    found = {}
    for path in sorted(paths):
        package = _package(path)
        form = "${source:Package}\n${source:Version}"
        said = subprocess.run(["dpkg-query", "-W", "-f", form, package], capture_output=True, text=True, check=True).stdout
        source, version = said.split("\n")
        part = found.setdefault(source, Part(source, version))
        part.packages.add(package.split(":")[0])
        part.files.append(path)
    return dict(sorted(found.items()))


def write_licences(found, folder):
    """Copies the copyright file of each part and the texts that they refer to. Writes the list of parts."""
    shutil.copytree("/usr/share/common-licenses", folder / "common-licenses", symlinks=True)
    rows = []
    for part in found.values():
        for package in sorted(part.packages):
            shutil.copyfile(f"/usr/share/doc/{package}/copyright", folder / f"{package}.txt")
        names = ", ".join(sorted(os.path.basename(path) for path in part.files))
        rows.append(f"{part.source} {part.version}\n    files: {names}\n    licence: {', '.join(f'{name}.txt' for name in sorted(part.packages))}\n"
                    f"    sources: {part.address}\n")
    (folder / "PARTS.txt").write_text(Path(__file__).with_name("parts_head.txt").read_text() + "\n" + "\n".join(rows))
