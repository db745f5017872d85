# SPDX-License-Identifier: Apache-2.0
"""Makes build/poinsot-VERSION-linux-x86_64.tar.xz: the program with all libraries that it needs except glibc. Unpack it
anywhere, and run bin/poinsot. Build it on Debian 12, so that it runs on every Linux with glibc 2.36 or newer. With
--wheel, makes a wheel for this machine's Python instead."""

import argparse
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import elf
import parts
import sizes
import wheel
from closure import Closure
from for_others import MANIFEST, ForOthers

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("POINSOT_BUILD_DIR", ROOT / "build"))


def words():
    parser = argparse.ArgumentParser(prog="packaging/portable", description=__doc__)
    parser.add_argument("--folder", action="store_true", help="make only the unpacked folder, build/portable")
    parser.add_argument("--no-build", action="store_true", help="use the last build as it is")
    parser.add_argument("--wheel", action="store_true", help="make a wheel, build/poinsot-VERSION-*.whl, instead of the archive")
    parser.add_argument("--sizes", action="store_true", help="also print a table of what each part weighs")
    return parser.parse_args()


def build():
    """Builds the program and the files that belong to it, and installs the tools that this script needs."""
    script = 'source "$0"; build_for poinsot_packed "python package portable" "packaging python"; need portable'
    if subprocess.run(["bash", "-c", script, ROOT / "poinsot"], cwd=ROOT).returncode != 0:
        raise SystemExit(3)


def version():
    return re.search(r'CPACK_PACKAGE_VERSION "(.*)"', (BUILD / "CPackConfig.cmake").read_text())[1]


def assemble(folder):
    """Makes the unpacked folder. Returns its libraries, and those for other programs."""
    shutil.rmtree(folder, ignore_errors=True)
    install = ["cmake", "--install", BUILD, "--strip", "--prefix", folder, "--component"]
    for component in ("program", "licence"):
        subprocess.run([*install, component], check=True, stdout=subprocess.DEVNULL)
    program = folder / "bin/poinsot"
    closure = Closure([program], opened(program))
    closure.copy(folder / "lib/poinsot")
    if "libEGL_mesa.so.0" in closure.kept:  # libEGL of the package opens it; src/gl/egl_context.cpp says so to libEGL
        (folder / "lib/poinsot/poinsot_egl.json").write_text(MANIFEST)
    others = ForOthers(closure)
    others.copy(folder)
    if others.missing:
        print(f"without bin/poinsot-gl, because this machine does not have {', '.join(others.missing)}", file=sys.stderr)
    # An RPATH, unlike a RUNPATH, also finds the libraries that the program opens, and those of each library.
    subprocess.run(["patchelf", "--force-rpath", "--set-rpath", "$ORIGIN/../lib/poinsot", program], check=True)
    licences = folder / "share/doc/poinsot/licences"
    licences.mkdir(parents=True)
    closure.parts = parts.parts({*closure.kept.values(), *others.files.values()})
    parts.write_licences(closure.parts, licences)
    shutil.copyfile(Path(__file__).with_name("README.txt"), folder / "README.txt")
    return closure, others


def opened(program):
    """Returns the libraries to add that the program opens. OSMesa draws without drivers, so it replaces EGL if it exists."""
    names = elf.opened(program)
    if any(name.startswith("libOSMesa") for name in names):
        return [name for name in names if not name.startswith("libEGL")]
    return [*names, "libEGL_mesa.so.0"]


def pack(folder, archive):
    """Packs the folder. The same files give the same bytes: the time of each is that of the commit."""
    of_the_commit = subprocess.run(["git", "-C", ROOT, "log", "-1", "--format=%ct"], capture_output=True, text=True).stdout.strip()
    tar = ["tar", "--create", "--sort=name", f"--mtime=@{of_the_commit or int(time.time())}", "--owner=0", "--group=0", "--numeric-owner",
           f"--directory={folder.parent}", f"--transform=s,^{folder.name},{archive.name.removesuffix('.tar.xz')},", folder.name]
    part = archive.with_suffix(".part")
    with open(part, "wb") as file, subprocess.Popen(tar, stdout=subprocess.PIPE) as packed:
        xz = subprocess.run(["xz", "--format=xz", *sizes.FILTERS, "--stdout"], stdin=packed.stdout, stdout=file)
    if packed.returncode or xz.returncode:
        raise SystemExit(f"{archive}: cannot be written")
    part.rename(archive)


def main():
    asked = words()
    if not asked.no_build:
        build()
    folder = BUILD / "portable"
    closure, others = assemble(folder)
    needs = ".".join(map(str, elf.glibc([folder / "bin/poinsot", *closure.kept.values(), *others.files.values()])))
    print(f"needs glibc {needs} or newer", file=sys.stderr)
    if asked.sizes:
        print(sizes.table(folder, closure))
    if asked.wheel:
        made = wheel.make(folder, BUILD, version())
    elif asked.folder:
        made = folder
    else:
        made = BUILD / f"poinsot-{version()}-linux-x86_64.tar.xz"
        pack(folder, made)
    size = "" if made.is_dir() else f", {made.stat().st_size / 1e6:.1f} MB"
    print(f"made {made.relative_to(ROOT) if made.is_relative_to(ROOT) else made}{size}", file=sys.stderr)


if __name__ == "__main__":
    main()
