# SPDX-License-Identifier: Apache-2.0
"""Makes libraries optional that an ELF file is linked with: the file loads without them, if it never calls them.

A stand-in would be simpler, but its functions would hide those of the real libraries in a program that loads them later.
"""

import struct
from pathlib import Path

DYNAMIC, SYMBOLS, VERSIONS_NEEDED = 6, 11, 0x6FFFFFFE  # types of sections
NEEDED = 1  # tag of an entry of the dynamic section
WEAK_SYMBOL, WEAK_VERSION = 2, 2


class _File:
    """Bytes of a 64-bit ELF file, with its sections by type."""

    def __init__(self, content):
        self.content = bytearray(content)
        start, = self.get("Q", 0x28)
        size, count = self.get("HH", 0x3A)
        headers = [self.get("IIQQQQIIQQ", start + size * index) for index in range(count)]
        self.strings = [header[4] for header in headers]  # offsets, by index of the section
        self.sections = {header[1]: (header[4], header[5], header[6]) for header in headers}

    def get(self, form, at):
        return struct.unpack_from("<" + form, self.content, at)

    def put(self, form, at, *values):
        struct.pack_into("<" + form, self.content, at, *values)

    def text(self, link, index):
        at = self.strings[link] + index
        return self.content[at:self.content.index(b"\0", at)].decode()


def make_optional(path, libraries, symbols):
    """Changes a file in place. @param libraries: names of those to remove. @param symbols: names of what they define."""
    file = _File(Path(path).read_bytes())
    _remove_needed(file, libraries)
    _weaken_symbols(file, symbols)
    _weaken_versions(file, libraries)
    Path(path).write_bytes(file.content)


def _remove_needed(file, libraries):
    at, size, link = file.sections[DYNAMIC]
    entries = [file.get("QQ", at + step) for step in range(0, size, 16)]
    kept = [(tag, value) for tag, value in entries if tag != NEEDED or file.text(link, value) not in libraries]
    for index, entry in enumerate(kept + [(0, 0)] * (len(entries) - len(kept))):
        file.put("QQ", at + 16 * index, *entry)


def _weaken_symbols(file, symbols):
    """Makes undefined symbols weak: the loader then resolves a missing one to 0 instead of failing."""
    at, size, link = file.sections[SYMBOLS]
    for place in range(at, at + size, 24):
        name, info, _, section = file.get("IBBH", place)
        if section == 0 and file.text(link, name) in symbols:
            file.put("B", place + 4, WEAK_SYMBOL << 4 | info & 15)


def _weaken_versions(file, libraries):
    """Attributes versions of the libraries to glibc as weak ones, because the loader looks for them in a library."""
    if VERSIONS_NEEDED not in file.sections:
        return
    at, _, link = file.sections[VERSIONS_NEEDED]
    places, step = [], 1
    while step:
        places.append(at)
        step, = file.get("I", at + 12)
        at += step
    files = {at: file.get("I", at + 4)[0] for at in places}
    glibc = next(name for name in files.values() if file.text(link, name) == "libc.so.6")
    for at, name in files.items():
        if file.text(link, name) not in libraries:
            continue
        file.put("I", at + 4, glibc)
        aux, step = at + file.get("I", at + 8)[0], 1
        while step:
            file.put("H", aux + 4, file.get("H", aux + 4)[0] | WEAK_VERSION)
            step, = file.get("I", aux + 12)
            aux += step
