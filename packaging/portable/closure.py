# SPDX-License-Identifier: Apache-2.0
"""Chooses the libraries that a portable poinsot contains, and leaves out those that it never calls.

FFmpeg as Debian builds it is linked with about a hundred libraries, most of them for formats that poinsot neither writes
nor reads; LLVM is linked with a theorem prover. Together they are larger than the rest. For FFmpeg, a stand-in replaces
them: one small library, which defines the functions of them all. Each of its functions returns 0, which FFmpeg treats as
a failure of the format. For LLVM, which other programs load too, they become optional.
"""

import os
import subprocess
from pathlib import Path

import elf
import optional

# Libraries whose dependencies are replaced, if nothing else needs them.
TRIMMED = ("libavcodec.", "libavformat.", "libavutil.", "libswscale.", "libswresample.", "libLLVM")
# Dependencies of these libraries that poinsot calls.
CALLED = ("libav", "libsw", "libx264.", "libx265.", "libSvtAv1Enc.", "libvpx.", "libdav1d.", "libz.so", "libzstd.",
          "libstdc++.", "libgcc_s.")
STAND_IN = "libpoinsot_absent.so"
OPTIONAL = ("libLLVM",)  # libraries whose replaced dependencies become optional


class Closure:
    """Libraries of a portable poinsot: `kept` by name, and `replaced`, the names replaced in each file that is trimmed."""

    def __init__(self, programs, opened):
        self.kept, trimmed = {}, []
        waiting = [*opened, *(name for program in programs for name in elf.needed(program))]
        while waiting:
            name = waiting.pop()
            if name in self.kept or name.startswith(elf.OF_GLIBC):
                continue
            path = elf.library(name)
            if path is None:
                raise SystemExit(f"{name}: this machine does not have the library")
            self.kept[name] = path
            if name.startswith(TRIMMED):
                trimmed.append(name)
                waiting += [it for it in elf.needed(path) if it.startswith(CALLED)]
            else:
                waiting += elf.needed(path)
        self.replaced = {name: [it for it in elf.needed(self.kept[name]) if it not in self.kept and not it.startswith(elf.OF_GLIBC)]
                         for name in trimmed}

    def copy(self, folder):
        """Copies the libraries into a folder, and adds the stand-in."""
        folder.mkdir(parents=True, exist_ok=True)
        for name, path in self.kept.items():
            copied = folder / name
            copied.write_bytes(Path(path).read_bytes())
            copied.chmod(0o644)
            replaced = self.replaced.get(name, ())
            if name.startswith(OPTIONAL):
                optional.make_optional(copied, replaced, {symbol.name for symbol, _ in self.missing(name)})
                replaced = ()
            changes = [word for it in replaced for word in ("--replace-needed", it, STAND_IN)]
            for words in (changes, ["--force-rpath", "--set-rpath", "$ORIGIN"]):  # patchelf fails if asked for both at once
                if words:
                    subprocess.run(["patchelf", *words, copied], check=True)
        self._write_stand_in(folder / STAND_IN)

    def missing(self, *users):
        """Returns the symbols that trimmed libraries take from replaced ones, with their versions."""
        found = {}
        for user in users:
            names = self.replaced[user]
            kept = {symbol.name for name in elf.needed(self.kept[user]) if name in self.kept
                    for symbol in elf.symbols(self.kept[name]) if symbol.defined}
            wanted = {symbol.name: symbol.version for symbol in elf.symbols(self.kept[user]) if not symbol.defined}
            for name in names:
                for symbol in elf.symbols(elf.library(name)):
                    if symbol.defined and symbol.name in wanted and symbol.name not in kept:
                        found[symbol.name] = (symbol, wanted[symbol.name])
        return list(found.values())

    def _write_stand_in(self, path):
        missing, lines, versions = self.missing(*(it for it in self.replaced if not it.startswith(OPTIONAL))), [], {}
        for symbol, version in missing:
            is_data = symbol.kind in ("OBJECT", "TLS")
            lines.append(f"char {symbol.name}[{max(symbol.size, 1)}];" if is_data else f"long {symbol.name}(void) {{ return 0; }}")
            versions.setdefault(version or "POINSOT_ABSENT", []).append(symbol.name)
        script = path.with_suffix(".versions")
        script.write_text("".join(f"{version} {{ global: {'; '.join(names)}; }};\n" for version, names in versions.items()))
        subprocess.run([os.environ.get("CC", "gcc"), "-shared", "-fPIC", "-Os", "-w", "-fno-builtin", "-nostdlib", f"-Wl,-soname,{STAND_IN}",
                        f"-Wl,--version-script={script}", "-s", "-x", "c", "-", "-o", path], input="\n".join(lines), text=True, check=True)
        script.unlink()
        path.chmod(0o644)
