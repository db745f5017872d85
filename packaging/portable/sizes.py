# SPDX-License-Identifier: Apache-2.0
"""Measures what each part of a portable poinsot weighs, unpacked and compressed."""

import os
import subprocess
from concurrent.futures import ThreadPoolExecutor

# A filter for x86 code makes the archive 4 % smaller. With this dictionary, unpacking takes 65 MB of memory.
FILTERS = ("--x86", "--lzma2=preset=9e,dict=64MiB")
FOR_OTHERS = "lib/poinsot-gl"
LEAST_BYTES = 1_000_000  # smaller parts share a row


def _compressed(paths):
    data = b"".join(path.read_bytes() for path in paths)
    return len(subprocess.run(["xz", "--format=xz", *FILTERS, "--stdout"], input=data, stdout=subprocess.PIPE, check=True).stdout)


def _grouped(folder, closure):
    """Returns the files of the folder by the part that they come from."""
    source = {os.path.realpath(path): part.source for part in closure.parts.values() for path in part.files}
    groups = {}
    for path in sorted(it for it in folder.rglob("*") if it.is_file() and not it.is_symlink()):
        group = source.get(closure.kept.get(path.name), "other files")
        if path == folder / "bin/poinsot":
            group = "the program, with its fonts"
        elif folder / FOR_OTHERS in path.parents:
            group = "Mesa for other programs"
        groups.setdefault(group, []).append(path)
    return groups


def table(folder, closure):
    """Returns a table in Markdown, the heaviest part first. Each part is compressed alone, so the sum is a bit too large."""
    groups = {"smaller libraries": []}
    for group, paths in _grouped(folder, closure).items():
        small = sum(path.stat().st_size for path in paths) < LEAST_BYTES and group != "other files"
        groups.setdefault("smaller libraries" if small else group, []).extend(paths)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        compressed = dict(zip(groups, pool.map(_compressed, groups.values())))
    rows = ["| part | unpacked, MB | compressed, MB |", "| --- | ---: | ---: |"]
    for group in sorted(groups, key=compressed.get, reverse=True):
        rows.append(f"| {group} | {sum(path.stat().st_size for path in groups[group]) / 1e6:.1f} | {compressed[group] / 1e6:.1f} |")
    return "\n".join(rows)
