# SPDX-License-Identifier: Apache-2.0
"""Makes a wheel of the package for Python: the same files as in Debian's python3-poinsot, and the portable program."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import elf

DEBIANS_PYTHON = "/usr/bin/python3"  # has the tool wheel; python/CMakeLists.txt builds for it
COMMAND = Path(__file__).with_name("command_of_the_wheel.py")


def tag(extension, files):
    """Returns the wheel's tag: the Python of the extension module, and the oldest glibc that has what the files use."""
    python = f"cp{re.search(r'cpython-([0-9]+)', extension.name)[1]}"
    return f"{python}-{python}-manylinux_{'_'.join(map(str, elf.glibc(files)))}_{os.uname().machine}"


def make(portable, build, version):
    """Makes the wheel in the build folder. @param portable: the unpacked folder with the program. Returns the file."""
    stage = build / "wheel"
    shutil.rmtree(stage, ignore_errors=True)
    subprocess.run(["cmake", "--install", build, "--strip", "--prefix", stage, "--component", "python"], check=True,
                   stdout=subprocess.DEVNULL)
    content = stage / "lib/python3/dist-packages"
    inside = content / "poinsot/portable"
    shutil.copytree(portable, inside, ignore=shutil.ignore_patterns("poinsot-gl"))  # a wheel cannot hold its links
    extension = next((content / "poinsot").glob("_core.*.so"))
    _check_libraries(extension, inside / "lib/poinsot")
    subprocess.run(["patchelf", "--force-rpath", "--set-rpath", "$ORIGIN/portable/lib/poinsot", extension], check=True)
    (content / f"poinsot-{version}.dist-info/WHEEL").write_text(
        "Wheel-Version: 1.0\nGenerator: packaging/portable\nRoot-Is-Purelib: false\n"
        f"Tag: {tag(extension, [extension, *(inside / 'lib/poinsot').glob('*.so*')])}\n")
    command = content / f"poinsot-{version}.data/scripts/poinsot"
    command.parent.mkdir(parents=True)
    shutil.copyfile(COMMAND, command)
    command.chmod(0o755)
    subprocess.run([DEBIANS_PYTHON, "-m", "wheel", "pack", "--dest-dir", build, content], check=True, stdout=subprocess.DEVNULL)
    return max(build.glob(f"poinsot-{version}-*.whl"), key=lambda it: it.stat().st_mtime)


def _check_libraries(extension, folder):
    """Ends with an error if the extension module needs a library that the program does not bring."""
    missing = [name for name in elf.needed(extension) if not name.startswith(elf.OF_GLIBC) and not (folder / name).exists()]
    if missing:
        raise SystemExit(f"{extension.name} needs {', '.join(missing)}, which the portable program does not contain")
