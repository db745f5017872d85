# SPDX-License-Identifier: Apache-2.0
"""Adds bin/poinsot-gl to a portable poinsot, and the libraries with which it makes other programs draw.

The folder lib/poinsot-gl has Mesa's libraries, which replace those of the system. Each of them looks for other parts of
Mesa and LLVM in the folder `own` first, then for the system's libraries, and then for copies in `others` and lib/poinsot.
A process has only one libstdc++, and the program that draws may need a newer one than the package has. The system's
libstdc++ therefore goes first.
"""

import os
import shutil
import subprocess
from pathlib import Path

import elf

# Libraries of Mesa that programs open, some of them through libglvnd.
OPENED = ("libGLX_mesa.so.0", "libEGL_mesa.so.0", "libOSMesa.so.8")
# Libraries that only Mesa's own libraries must find. A program that is linked with libgbm may need a newer one.
OWN = ("libgbm.so.1", "libglapi.so.0", "libLLVM")
DRIVER = "swrast_dri.so"
SYSTEM = "/usr/lib/x86_64-linux-gnu:/lib/x86_64-linux-gnu:/usr/lib64:/lib64:/usr/lib"
MANIFEST = '{"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_mesa.so.0"}}\n'


class ForOthers:
    """Files of lib/poinsot-gl: `files` has the source of each, by its path in that folder. `missing` has what Debian lacks."""

    def __init__(self, closure):
        self.files, self.closure = {}, closure
        driver = Path(elf.library("libGLX_mesa.so.0") or "/").parent / "dri" / DRIVER
        self.missing = [name for name in OPENED if elf.library(name) is None] + ([] if driver.exists() else [DRIVER])
        if self.missing:
            return
        self.files[f"dri/{DRIVER}"] = os.path.realpath(driver)
        waiting = [*OPENED, *elf.needed(self.files[f"dri/{DRIVER}"])]
        while waiting:
            name = waiting.pop()
            if name in closure.kept or _place(name) in self.files or name.startswith(elf.OF_GLIBC):
                continue
            self.files[_place(name)] = elf.library(name)
            waiting += elf.needed(elf.library(name))

    def copy(self, root):
        """Copies the files and the script. @param root: the unpacked folder, with lib/poinsot."""
        if not self.files:
            return
        folder = root / "lib/poinsot-gl"
        for name, path in self.files.items():
            copied = folder / name
            copied.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, copied)
            copied.chmod(0o644)
            up = "$ORIGIN" + "/.." * name.count("/")
            _find_in(copied, up, f"{up}/own", SYSTEM, f"{up}/others", f"{up}/../poinsot")
        for name in self.closure.kept:
            if name.startswith(OPENED + OWN):
                link = folder / _place(name)
                link.parent.mkdir(exist_ok=True)
                link.symlink_to(os.path.relpath(root / "lib/poinsot" / name, link.parent))
            if name in OPENED:  # The loader takes $ORIGIN from the link, so the library needs both places.
                _find_in(root / "lib/poinsot" / name, "$ORIGIN", "$ORIGIN/own", SYSTEM, "$ORIGIN/others", "$ORIGIN/../poinsot")
        (folder / "egl.json").write_text(MANIFEST)
        script = root / "bin/poinsot-gl"
        shutil.copyfile(Path(__file__).with_name("poinsot-gl"), script)
        script.chmod(0o755)


def _place(name):
    """Returns the path of a library in lib/poinsot-gl."""
    return name if name in OPENED else f"own/{name}" if name.startswith(OWN) else f"others/{name}"


def _find_in(library, *folders):
    """Sets the folders in which a library looks for other libraries."""
    subprocess.run(["patchelf", "--force-rpath", "--set-rpath", ":".join(folders), library], check=True)
