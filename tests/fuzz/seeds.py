# SPDX-License-Identifier: Apache-2.0
"""Seeds of the fuzz targets: real inputs of this repository, and small inputs of every kind. TARGETS has the function of each
target that yields its seeds, as bytes."""

import itertools
import json
import re
import shlex
import struct
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def contents(pattern, longest=4096):
    return [data for data in (path.read_bytes() for path in sorted(ROOT.glob(pattern))) if len(data) <= longest]


def scenes():
    overrides = ["show.plane={opacity=0.5, grid=false}", "time.fps=30000/1001", "show.title=A racket",
                 'body.principal_moments=["1 kg m^2", 2, 2.5]', "style.theme=dark", "show.label[0].text=x", "body.shape=box"]
    small = b"[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 10, 0]\n"
    yield from contents("scenes/*.toml") + contents("tests/scene/data/*.toml") + contents("tests/golden/scenes/*.toml")
    yield from (small + b"\0" + override.encode() for override in overrides)
    yield small + b"\0" + "\0".join(overrides).encode()


def tex():
    texts = set()
    for scene in contents("scenes/*.toml") + contents("tests/golden/scenes/*.toml"):
        texts.update(re.findall(r"\"((?:[^\"\\\n]|\\.)*[$\\](?:[^\"\\\n]|\\.)*)\"|'([^'\n]*[$\\][^'\n]*)'", scene.decode()))
    yield from ((double.replace("\\\\", "\\") or single).encode() for double, single in sorted(texts))
    yield r"Poinsot's ``construction'' -- \textbf{bold} \, \; \quad\ \$ \% \& \# \_ \{ \} \degree \ldots".encode()
    yield r"$\hat{\mathbf{e}}_1 \dot\omega \ddot{x} \bar x \vec{r} \tilde N x_{1}^{2}' \frac{a}{b} \dfrac{2T}{L} \sqrt{I_1}$".encode()
    yield r"$I = \begin{bmatrix} I_1 & 0 \\ 0 & -\frac{1}{2} \\ \end{bmatrix}^2$".encode()
    yield r"$\text{if } \sin\theta \le 1, \boldsymbol{\omega} \mathrm{d} \mathit{x} \times \cdot \Omega ω = -1$".encode()


# Vertices and faces of a tetrahedron.
VERTICES = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def ply(kind):
    head = (f"ply\nformat {kind} 1.0\ncomment x\nelement vertex 4\nproperty float x\nproperty double y\nproperty int z\n"
            "element face 4\nproperty list uchar int vertex_indices\nend_header\n")
    if kind == "ascii":
        rows = [" ".join(map(str, vertex)) for vertex in VERTICES] + [" ".join(map(str, (3, *face))) for face in FACES]
        return (head + "\n".join(rows) + "\n").encode()
    order = "<" if kind == "binary_little_endian" else ">"
    return (head.encode() + b"".join(struct.pack(order + "fdi", *vertex) for vertex in VERTICES)
            + b"".join(struct.pack(order + "B3i", 3, *face) for face in FACES))


def meshes():
    yield from (b"o" + mesh for mesh in contents("tests/scene/data/*.obj"))
    yield from (b"s" + mesh for mesh in contents("tests/scene/data/*.stl", 65535))
    obj = [f"v {x} {y} {z}" for x, y, z in VERTICES] + ["f " + " ".join(f"{i + 1}//{i}" for i in face) for face in FACES]
    yield ("o# x\nmtllib a.mtl\n" + "\n".join(obj) + "\nf -1 -2 \\\n -3\n").encode()
    facets = ["facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*VERTICES[i]) for i in face)
              + "endloop\nendfacet" for face in FACES]
    yield ("ssolid a\n" + "\n".join(facets) + "\nendsolid a\n").encode()
    yield b"s" + bytes(80) + struct.pack("<I", 4) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *itertools.chain(*(VERTICES[i] for i in face)), 0) for face in FACES)
    yield from (b"p" + ply(kind) for kind in ("ascii", "binary_little_endian", "binary_big_endian"))


def png(depth, color, interlaced=False, chunks=()):
    side, samples = 5, {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[color]
    # Width and height of each Adam7 pass of a picture of 5x5.
    passes = [(1, 1), (1, 1), (2, 1), (1, 2), (3, 1), (2, 3), (5, 2)] if interlaced else [(side, side)]
    rows = b"".join((bytes([height % 5]) + bytes(range(1, (width * samples * depth + 7) // 8 + 1))) * height for width, height in passes)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    before = [(b"PLTE", bytes(i % 256 for i in range(3 << depth)))] if color == 3 else []
    header = struct.pack(">IIBBBBB", side, side, depth, color, 0, 0, interlaced)
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        chunk(kind, data) for kind, data in [(b"IHDR", header), *before, *chunks, (b"IDAT", zlib.compress(rows)), (b"IEND", b"")])


def pngs():
    texts = [(b"tEXt", b"Software\0poinsot 0.1.0"), (b"zTXt", b"Title\0\0" + zlib.compress(b"Rolling")), (b"pHYs", bytes(9)),
             (b"iTXt", "Description\0\0\0de\0x\0Drehung um Ω".encode()), (b"iTXt", b"Title\0\1\0\0\0" + zlib.compress(b"x" * 99)),
             (b"gAMA", bytes(4)), (b"sRGB", b"\0"), (b"tIME", bytes(7)), (b"sPLT", b"a\0\x08" + bytes(6)), (b"eXIf", b"MM\0*")]
    for color, depths in {0: (1, 2, 4, 8, 16), 2: (8, 16), 3: (1, 2, 4, 8), 4: (8, 16), 6: (8, 16)}.items():
        for depth, interlaced in itertools.product(depths, (False, True)):
            yield png(depth, color, interlaced)
    yield png(8, 6, chunks=texts)
    yield png(8, 3, chunks=[(b"tRNS", b"\0\x80")])
    yield png(16, 2, chunks=[(b"tRNS", bytes(6)), (b"bKGD", bytes(6))])
    yield from contents("tests/golden/images/*.png", 4096)[:3]


def torque_tables():
    yield from contents("tests/scene/data/torque.csv")
    yield b"t,Nx,Ny,Nz\n0,1,2,3\n0.5,-1e3,+2,0\r\n1,0,0,0"
    yield b"\xef\xbb\xbf0, 1, 2, 3\n 1 ,0,0,0\n"


def trajectory_tables():
    columns = ["t", "q_w", "q_x", "q_y", "q_z"] + [f"{name}_{axis}" for name in ("omega_B", "omega_W", "L_W") for axis in "xyz"] + ["T"]
    yield (",".join(columns) + "\n" + ",".join(["1.5e-3"] * 15) + "\n").encode()
    yield b"\xef\xbb\xbf# made by an engine\r\n\"t\", omega_B_x ,omega_B_y,omega_B_z,\"a,b\"\r\n\r\n 1 ,+2,\"3\",nan,\"x, y\"\r\n# end\r\n"
    yield b"t,q_w,q_x,q_y,q_z\n0,1,0,0,0\n-inf,-1e999,1e-400,0,0"


def grades():
    """Yields the byte of a motion and a table: times of every magnitude, in the columns of various engines."""
    times = ["0", "0.5", "1", "1e14", "1e154", "1e289", "1e291", "1e300", "1e308", "-1e300", "4.9e-324", "-0"]
    for kind in range(28):
        yield bytes([kind]) + ("t,q_w,q_x,q_y,q_z\n" + "".join(f"{t},1,0,0,0\n" for t in times[kind % 6:kind % 6 + 7])).encode()
        yield bytes([kind]) + ("omega_B_x omega_B_y omega_B_z t\n" + "".join(f"0.1 {0.2 + 0.01 * i} 3 {0.1 * i}\n" for i in range(20))).encode()
    for t in times:
        yield b"\x03" + f"t,q_w,q_x,q_y,q_z,omega_W_x,omega_W_y,omega_W_z\n0,1,0,0,0,1e308,0,-1e300\n{t},1e300,0,0,1e-300,0,0,0\n".encode()


def work_folders():
    job = {"job": "5f", "scene": "a0", "settings": "{}", "kind": 0, "fps": "30000/1001", "container": "mp4", "frames": [0, 89],
           "segment_frames": 30, "shards": 2, "title": "A", "description": "B", "subtitles": [[0, 1500, "L"]]}
    record = {"frames": [0, 2], "job": "5f", "renderer": "llvmpipe", "digests": ["a", "b", "c"]}
    files = {"R": ["segment-000000000-000000002.mp4"], "r": ["../f_000.png", "../f_001.png", "../f_002.png"]}
    for kind in range(4):
        yield b"J" + json.dumps({**job, "kind": kind}).encode()
        yield b"j" + json.dumps({**job, "kind": kind}).encode()
    for letter, names in files.items():
        whole = {**record, "files": [{"path": name, "bytes": 7, "sha256": "5f" * 32} for name in names]}
        yield letter.encode() + json.dumps(whole).encode()
    yield b'o{"renderer": "llvmpipe", "software": "poinsot 0.1.0", "scene": "5f"}'
    yield b'o{"renderer": "llvmpipe", "driver": "Mesa 22.3.6", "software": "poinsot 0.1.0", "scene": "5f"}'


def golden_manifests():
    yield from contents("tests/golden/golden.toml")
    yield b"".join(contents("tests/golden/golden.toml", 1 << 20))[:4000]
    pages = (ROOT / "docs" / "golden.md").read_text()
    yield from (block.encode() for block in re.findall(r"```toml\n(.*?)```", pages, re.S))


def command_lines():
    texts = [path.read_text() for path in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")), *sorted((ROOT / "src/cli").glob("*.cpp"))]]
    found = set()
    for line in re.findall(r"(?:\./| )poinsot ((?:[a-z]+|--?[a-z]+)\b[^`|\"\\\n]*)", "\n".join(texts)):
        try:
            found.add("\n".join(shlex.split(line, comments=True)))
        except ValueError:
            pass  # prose with an apostrophe, not a command
    yield from (line.encode() for line in sorted(found))
    yield from (word.encode() for word in ("--version", "--help", "help\nrender", "f_{frame:05}.png", "5-7", "2/7", "640x360", "0,90 ms", "0-3"))


TARGETS = {"scene": scenes, "tex": tex, "mesh": meshes, "png": pngs, "torque_table": torque_tables, "trajectory_table": trajectory_tables,
           "grade": grades,
           "work_folder": work_folders, "golden_manifest": golden_manifests, "command_line": command_lines}

TOML = ["[[", "]]", "= ", '"""', "'''", "1e999", "nan", "inf", "-0", "0x7f", "99999999999999999999", "{a=1}", "#", "true", "1979-05-27", "rpm", "kg^-9"]
NUMBERS = ["nan", "inf", "1e999", "-0", "1e-320", "9223372036854775807", "-9223372036854775808", "4294967295"]


def strings(pattern, kind=r"[A-Za-z_][\w./^-]{0,30}"):
    """Returns the string literals of the program's sources that match `kind`."""
    paths = sorted((ROOT / "src").glob(pattern))
    assert paths, f"src/{pattern}: there is no such file"
    text = "\n".join(path.read_text() for path in paths)
    return sorted(set(re.findall(f'"({kind})"', text, re.ASCII)))


def vocabulary(target):
    return {
        "scene": lambda: strings("scene/**/*.cpp") + strings("scene/unit*.h") + TOML,
        "tex": lambda: ["\\\\" + name for name in strings("text/commands.cpp", "[A-Za-z]{2,20}")] + ["$", "{", "}", "_", "^", "'", "``", "--", "~"],
        "mesh": lambda: strings("geometry/*.cpp") + NUMBERS + ["property list uchar int vertex_indices", "end_header", "\\\\\\x0a", "f ", "v "],
        "png": lambda: ["IHDR", "PLTE", "IDAT", "IEND", "tRNS", "tEXt", "zTXt", "iTXt", "iCCP", "sPLT", "hIST", "pCAL", "sCAL", "bKGD", "eXIf", "acTL", "cICP", "gAMA", "cHRM"],
        "torque_table": lambda: ["t,Nx,Ny,Nz", *NUMBERS],
        "trajectory_table": lambda: strings("reference/trajectory.h") + NUMBERS + ["\\x22", ",", "#"],
        "grade": lambda: strings("reference/trajectory.h") + NUMBERS + ["1e300", "-1e300", "1e308", "1e289", "4.9e-324", ",", "\\x0a"],
        "work_folder": lambda: strings("job/job_record.cpp") + strings("job/segment_record.cpp") + ["mp4", "mov", "webm", "gif", "apng", "../", *NUMBERS],
        "golden_manifest": lambda: strings("suite/manifest.cpp") + strings("suite/keys.cpp", "[a-z_]{3,12}") + TOML,
        "command_line": lambda: strings("cli/*.cpp", r"-{0,2}[a-z][a-z-]{1,20}") + NUMBERS + ["-D", "-o", "=", "--"],
    }[target]()


def dictionary(target):
    """Returns the text of libFuzzer's dictionary (-dict): words that its mutations insert."""
    escaped = (word if word.startswith("\\") else word.replace("\\", "\\\\").replace('"', '\\"') for word in vocabulary(target))
    return "".join(f'"{word}"\n' for word in dict.fromkeys(escaped))
