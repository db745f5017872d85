# SPDX-License-Identifier: Apache-2.0
"""Adds bin/poinsot-gl to a portable poinsot, and the libraries with which it makes other programs draw.

The folder lib/poinsot-gl has Mesa's libraries, which replace those of the system. Each of them looks for its own Mesa and
LLVM first, then for the system's libraries, and then for the copies in the package. A process has only one libstdc++, and
the program that draws may need a newer one than the package has, so the system's libstdc++ goes first.
"""

import os
import shutil
import subprocess
from pathlib import Path

import elf

# Libraries that a program opens through libglvnd, by itself, or through these libraries.
OF_MESA = ("libGLX_mesa.so.0", "libEGL_mesa.so.0", "libgbm.so.1", "libglapi.so.0", "libOSMesa.so.8")
DRIVER = "swrast_dri.so"
SYSTEM = "/usr/lib/x86_64-linux-gnu:/lib/x86_64-linux-gnu:/usr/lib64:/lib64:/usr/lib"
MANIFEST = '{"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_mesa.so.0"}}\n'


class ForOthers:
    """Files of lib/poinsot-gl: `files` has the source of each, by its path in that folder. `missing` has what Debian lacks."""

    def __init__(self, closure):
        self.files, self.closure = {}, closure
        mesas = {name: elf.library(name) for name in OF_MESA}
        driver = Path(mesas["libGLX_mesa.so.0"] or "/").parent / "dri" / DRIVER
        self.missing = [name for name, path in mesas.items() if path is None] + ([] if driver.exists() else [DRIVER])
        if self.missing:
            return
        self.files = {name: path for name, path in mesas.items() if name not in closure.kept}
        self.files[f"dri/{DRIVER}"] = os.path.realpath(driver)
        waiting = [name for path in self.files.values() for name in elf.needed(path)]
        while waiting:
            name = waiting.pop()
            if name in closure.kept or name in mesas or f"others/{name}" in self.files or name.startswith(elf.OF_GLIBC):
                continue
            self.files[f"others/{name}"] = elf.library(name)
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
            up = "/.." * name.count("/")
            _find_in(copied, *(f"$ORIGIN{up}{it}" for it in ("", "/llvm")), SYSTEM, *(f"$ORIGIN{up}{it}" for it in ("/others", "/../poinsot")))
        for name in self.closure.kept:
            # Mesa's libraries find LLVM in a folder of its own, so that no other program finds it.
            if name in OF_MESA or name.startswith("libLLVM"):
                link = folder / ("" if name in OF_MESA else "llvm") / name
                link.parent.mkdir(exist_ok=True)
                link.symlink_to(os.path.relpath(root / "lib/poinsot" / name, link.parent))
            if name in OF_MESA:  # The loader takes $ORIGIN from the link, so the library needs both places.
                _find_in(root / "lib/poinsot" / name, "$ORIGIN", "$ORIGIN/llvm", SYSTEM, "$ORIGIN/others", "$ORIGIN/../poinsot")
        (folder / "egl.json").write_text(MANIFEST)
        script = root / "bin/poinsot-gl"
        shutil.copyfile(Path(__file__).with_name("poinsot-gl"), script)
        script.chmod(0o755)


def _find_in(library, *folders):
    """Sets the folders in which a library looks for other libraries."""
    subprocess.run(["patchelf", "--force-rpath", "--set-rpath", ":".join(folders), library], check=True)
