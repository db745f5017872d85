# SPDX-License-Identifier: Apache-2.0
"""Reads ELF files with readelf, and finds the libraries that a program loads."""

import os
import re
import subprocess
from dataclasses import dataclass
from functools import cache
from pathlib import Path

# Libraries of glibc. Programs use the copy of the machine that they run on, because glibc is compatible with programs
# that were linked with an older version.
OF_GLIBC = ("ld-linux", "libc.so", "libm.so", "libmvec.so", "libpthread.so", "libdl.so", "librt.so", "libresolv.so", "libutil.so")


@dataclass(frozen=True)
class Symbol:
    """Dynamic symbol of a file. `version` is empty if the symbol has none."""
    name: str
    version: str
    defined: bool
    kind: str  # "FUNC", "OBJECT" and others
    size: int


def _readelf(*words):
    return subprocess.run(["readelf", "--wide", *words], capture_output=True, text=True, check=True).stdout


@cache
def needed(path):
    """Returns the names of the libraries that an ELF file is linked with."""
    return re.findall(r"\(NEEDED\).*\[(.*)\]", _readelf("--dynamic", path))


@cache
def symbols(path):
    """Returns the dynamic symbols of an ELF file."""
    found = []
    for line in _readelf("--dyn-syms", path).splitlines():
        cells = line.split()
        if len(cells) < 8 or not cells[0].rstrip(":").isdigit():
            continue
        name, _, version = cells[7].partition("@")
        found.append(Symbol(name, version.lstrip("@"), cells[6] != "UND", cells[3], int(cells[2], 0)))
    return found


@cache
def _of_the_loader():
    """Returns the path of each library that the dynamic loader of this machine finds, by name."""
    listed = subprocess.run(["/sbin/ldconfig", "-p"], capture_output=True, text=True, check=True).stdout
    return {line.split()[0]: line.split(" => ")[1] for line in reversed(listed.splitlines()) if " => " in line and "x86-64" in line}


def library(name):
    """Returns the file of a library, with links resolved; None if this machine does not have it."""
    found = _of_the_loader().get(name)
    return os.path.realpath(found) if found else None


def opened(program):
    """Returns the names of libraries that a program opens at run time: all names that its text contains.

    The program is linked with the rest of the libraries, whose names its text contains too.
    """
    text = Path(program).read_bytes()
    names = {name.decode() for name in re.findall(rb"(?<=\0)lib[\w+-]+\.so\.\d+(?=\0)", text)}
    return sorted(name for name in names if name not in needed(program) and library(name))


def glibc(paths):
    """Returns the newest version of glibc's interface that any of the files uses, such as (2, 36)."""
    used = {symbol.version for path in paths for symbol in symbols(path)}
    return max(tuple(map(int, version[6:].split("."))) for version in used if re.fullmatch(r"GLIBC_[\d.]+", version))
