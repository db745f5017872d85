# SPDX-License-Identifier: Apache-2.0
"""Cases of same_outputs. A case is a folder of inputs and the commands that run in it, one after the other."""

import hashlib
import re
import shutil
import sys
from dataclasses import dataclass, field

SMALL = ["--size", "320x180", "--reproducible"]
PLAIN = ["--progress", "plain"]
ONE_SCENE = ("football", "heavy_top", "tennis_racket_two_views")  # scenes of free motion, of driven motion, and with several views
SUBCOMMANDS = ("new preview render still sweep gallery status assemble submit diff golden info trajectory grade check explain "
               "schema doctor help").split()


@dataclass
class Case:
    name: str
    commands: list
    copies: list = field(default_factory=list)  # (from, to): copies of sources
    files: dict = field(default_factory=dict)   # name: contents
    varying: list = field(default_factory=list) # (pattern, replacement) for this case only
    common: list = field(default_factory=list)  # (pattern, replacement) for all cases
    ignored: str = r"$^"                        # files that match are not compared

    def prepare(self, place):
        (place / "home").mkdir()
        for source, target in self.copies:
            (place / target).parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if source.is_dir() else shutil.copyfile)(source, place / target)
        for name, data in self.files.items():
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            (place / name).write_bytes(data)

    def reads(self, text):
        for pattern, name in self.common + self.varying:
            text = re.sub(pattern, name, text)
        return text

    def digest(self, path):
        data = path.read_bytes()
        if self.varying or path.suffix in (".json", ".xml", ".html", ".md", ".js", ".sh"):
            data = self.reads(data)
        return hashlib.sha256(data).hexdigest()


# Outputs that may differ between two runs, and their replacements.
TIMES = [(rb"(poinsot: \d+ of \d+ frames \(\d+ %\)[^\n]*\n)+", b"PROGRESS\n"), (rb"([(,] ?)[\d.]+ s(?=[,)])", rb"\1TIME"),
         (rb"\d{4}-\d\d-\d\d[T ]\d\d:\d\d(:\d\d)?(Z|[+-]\d\d:\d\d)?", b"DATE"), (rb"/tmp/poinsot-\w+", b"TEMPORARY"),
         (rb"(?s)\"spent\": \{.*?\n \}", b"SPENT"), (rb"\"(elapsed_s|seconds)\": ?[\d.e+-]+", b"TIME"), (rb" time=\"[\d.]+\"", b"TIME")]
NUMBERS = [(rb"[\d.]+", b"N")]


def of_scenes(root):
    """Yields a case for each scene: picture, figures, words and numbers; for scenes of the gallery, a short film, too."""
    for path in sorted(root.glob("scenes/*.toml")):
        name = path.stem
        scene = f"scenes/{path.name}"
        yield Case(f"scene {name}", [
            ["check", scene], ["info", scene], ["info", scene, "--json"], ["info", scene, "--alt"],
            ["trajectory", scene, "--at=0,0.25,7,1e3", "-o", "t.csv"], ["trajectory", scene, "--at=-3.5,0,1e3", "-o", "t.json"],
            *(["still", scene, *SMALL, "-o", f"still.{kind}"] for kind in ("png", "svg", "pdf", "tex")),
            ["render", scene, *SMALL, *PLAIN, "--frames", "3-14", "-o", "film.mp4", "--manifest", "manifest.json"],
            ["submit", scene, "-o", "film2.mp4"], ["status", "film.mp4", "--json"]],
            [(root / "scenes", "scenes")])
    for path in sorted(root.glob("tests/golden/scenes/**/*.toml")):
        scene = str(path.relative_to(root / "tests/golden"))
        yield Case(f"golden scene {path.stem}", [["check", scene], ["info", scene], ["still", scene, *SMALL, "-o", "still.png"],
                                                 ["still", scene, *SMALL, "-o", "still.svg"]],
                   [(root / "tests/golden/scenes", "scenes")])


def of_films(root):
    scenes = [(root / "scenes", "scenes")]
    for name in ONE_SCENE:
        film = ["render", f"scenes/{name}.toml", *SMALL, *PLAIN, "--frames", "0-24"]
        formats = ["f.mp4", "f.mov", "f.webm", "f.gif", "f.apng", "f_{frame:03}.png"]
        yield Case(f"formats {name}", [[*film, "-o", output] for output in formats]
                   + [[*film, "--transparent", "-o", f"clear{output[1:]}"] for output in formats]
                   + [[*film, "--bits", "16", "-o", "deep_{frame:03}.png"], [*film, "-o", "-", "--format", "png"],
                      [*film, "-o", "-", "--format", "mp4"], [*film, "--dry-run", "-o", "dry.mp4"],
                      [*film, "--view", "1", "-o", "view.mp4"]], scenes)
        yield Case(f"captions and loop {name}", [["render", f"scenes/{name}.toml", *SMALL, "--loop", "-D", "time.fps=5", "-o", "loop.mp4"],
                                                 ["render", f"scenes/{name}.toml", *SMALL, "--fps", "2", "-o", "all.mp4"]], scenes)
    film = ["render", "scenes/football.toml", *SMALL, *PLAIN, "--frames", "0-59", "--segment", "10", "-o", "f.mp4"]
    yield Case("shards", [["status", "f.mp4"], [*film, "--shard", "1/3"], ["status", "f.mp4"], ["status", "f.mp4", "--json"],
                          ["status", "f.mp4", "--shards"], ["assemble", "f.mp4"], [*film, "--shards-left", "3"],
                          [*film, "--shard", "2/3"], [*film, "--shard", "3/3"], ["assemble", "f.mp4"], ["status", "f.mp4"]], scenes)
    yield Case("resume", [[*film, "--keep"], [*film, "--resume", "--keep"], [*film, "--resume", "--keep", "-D", "show.title=Other"],
                          [*film, "--resume", "--dry-run"], [*film, "-j", "1", "--resume"], film, [*film, "--force", "-j", "2"]], scenes,
               ignored=r"\.poinsot/", varying=[(rb"\b\d+ workers?", b"WORKERS")])
    yield Case("statistics", [[*film, "--stats", "--trace", "trace.json"]], scenes, varying=NUMBERS, ignored=r"trace\.json$")
    yield Case("progress in JSON", [[*film, "--progress", "json", "-j", "1"]], scenes, varying=NUMBERS)
    yield Case("captions", [["render", "scenes/timeline.toml", *SMALL, "--fps", "4", "-o", "f.mp4"]],
               [(root / "tests/golden/scenes/timeline.toml", "scenes/timeline.toml")])
    yield Case("untrusted", [["render", "--untrusted", "scenes/football.toml", *SMALL, "--frames", "0-4", "-o", "f.mp4"],
                             ["still", "--untrusted", "scenes/football.toml", *SMALL, "-o", "f.png"],
                             ["info", "--untrusted", "scenes/football.toml"], ["check", "--untrusted", "scenes/football.toml"],
                             ["trajectory", "--untrusted", "scenes/football.toml", "--rate", "3"],
                             ["render", "--untrusted", "scenes/football.toml", "--max-memory", "1MiB", "-o", "g.mp4"]], scenes)


def of_pictures(root):
    scenes = [(root / "scenes", "scenes")]
    racket = "scenes/tennis_racket.toml"
    grid = ["-D", "motion.omega_body=[0.01..0.41:4, 4.2, 0]"]
    yield Case("sweeps", [["sweep", racket, *grid, *SMALL, "--frames", "0-9", "-o", "s.mp4"],
                          ["sweep", racket, *grid, *SMALL, "--time", "2", "-o", "s.png"],
                          ["sweep", racket, *grid, "--time", "2", "--columns", "2", "--label", "$x$", "-o", "s.svg"],
                          ["sweep", racket, "--map", *SMALL, "-o", "map.png"], ["sweep", racket, "--map", "-o", "map.pdf"],
                          ["sweep", racket, "-D", "motion.omega_body=[0.01..0.41:2, 1..4.2:3, 0]", "-o", "two.tex"],
                          ["sweep", racket, "-o", "none.png"], ["submit", racket, *grid, "-o", "s2.mp4"]], scenes)
    yield Case("gallery", [["gallery", "scenes", *SMALL, "-j", "1", "-o", "pictures"],
                           ["gallery", "scenes", "--only", "football", "f*", "--no-sheet", *SMALL, "-j", "1", "-o", "few"],
                           ["gallery", "scenes", "--only", "nothing", "-o", "none"]], scenes)
    football = "scenes/football.toml"
    yield Case("papers", [["still", football, "--width", "86mm", "-o", "f.pdf"], ["still", football, "--width", "3 in", "--dpi", "200", "-o", "f.png"],
                          ["still", football, "--width", "86mm", "-o", "f.tex"], ["still", football, "--transparent", "-o", "t.svg"],
                          *(["still", football, *SMALL, "-D", f"style.theme={theme}", "-o", f"{theme}.png"] for theme in ("dark", "light", "print"))],
               scenes)
    for engine in ("slurm", "parallel", "make"):
        yield Case(f"submit {engine}", [["submit", football, "--engine", engine, "--shards", "7", "-q", "4k", "--keep", "--retries", "2", "-o", "f.mp4"],
                                        ["submit", football, "--engine", engine, "--frame-seconds", "0.5", "-o", "f_{frame}.png"],
                                        ["submit", football, "--engine", engine, "-o", "-"]], scenes)


def of_comparisons(root):
    scenes = [(root / "scenes", "scenes")]
    still = ["still", "scenes/football.toml", *SMALL]
    film = ["render", "scenes/football.toml", *SMALL, "--frames", "0-9"]
    outputs = ["--map", "map.png", "--diff-image", "diff.png", "--report", "page.html", "--junit", "j.xml", "--markdown", "m.md"]
    yield Case("diff of pictures", [[*still, "-o", "a.png"], [*still, "-D", "show.title=Other", "-o", "b.png"], [*still, "--bits", "16", "-o", "c.png"],
                                    [*still, "--size", "160x90", "-o", "d.png"], ["diff", "a.png", "a.png"], ["diff", "a.png", "b.png", *outputs],
                                    ["diff", "a.png", "b.png", "--json"], ["diff", "a.png", "c.png"], ["diff", "a.png", "c.png", "--exact"],
                                    ["diff", "a.png", "d.png"], ["diff", "a.png", "none.png"], ["diff", "a.png", "b.png", "--rule", "other_driver"],
                                    ["diff", "a.png", "b.png", "--ignore", "0,0,320,40"], ["diff", "a.png", "b.png", "--max", "3", "--pixels", "1%"]],
               scenes, varying=RUN_FACTS)
    yield Case("diff of films", [[*film, "-o", "a.mp4"], [*film, "-D", "show.title=Other", "-o", "b.mp4"], [*film, "-o", "a.gif"],
                                 ["diff", "a.mp4", "b.mp4", *outputs, "--curve", "curve.csv"], ["diff", "a.mp4", "b.mp4", "--curve", "curve.svg", "--json"],
                                 ["diff", "a.mp4", "a.mp4"], ["diff", "a.mp4", "a.gif"]], scenes, varying=RUN_FACTS)
    few = ["--only", "football", "sphere", "separatrix"]
    yield Case("diff of folders", [["gallery", "scenes", *few, *SMALL, "--no-sheet", "-o", "a"],
                                   ["gallery", "scenes", *few, *SMALL, "--no-sheet", "-D", "style.theme=dark", "-o", "b"],
                                   ["diff", "a", "b", *outputs[4:]], ["diff", "a", "b", "--json"], ["diff", "a", "b", "--update", "sph*"],
                                   ["diff", "a", "b"]], scenes, varying=RUN_FACTS)
    suite = [(root / "tests/golden", "suite")]
    golden = ["golden", "suite/golden.toml"]
    yield Case("golden", [golden, [*golden, "--json"], [*golden, "--list"], [*golden, "--list", "--json"], [*golden, "--unused"],
                          [*golden, "--exact", "--junit", "j.xml", "--markdown", "m.md", "--report", "page.html", "--outcome", "o.js"],
                          [*golden, "--only", "body*", "--update"], [*golden, "--only", "nothing"]], suite, varying=RUN_FACTS)
    yield Case("golden with what is wrong", [golden, [*golden, "--json"], [*golden, "--update", "--json"], golden],
               [*suite, (root / "tests/golden/images/binet.png", "suite/images/components.png"),
                (root / "tests/golden/images/binet.png", "suite/images/stray.png")], varying=RUN_FACTS)


RUN_FACTS = [(rb"[0-9a-f]{7,40}", b"HASH"), (rb"\d{1,2} \w+ \d{4}(,? \d\d:\d\d)?", b"DATE")]


def of_numbers(root):
    scenes = [(root / "scenes", "scenes")]
    for name in ("football", "heavy_top", "thrown_baton"):
        scene = f"scenes/{name}.toml"
        yield Case(f"grade {name}", [["trajectory", scene, "--rate", "20", "-o", "a.csv"], ["trajectory", scene, "--rate", "20", "-o", "a.json"],
                                     ["grade", scene, "a.csv"], ["grade", scene, "a.csv", "--json"], ["grade", scene, "a.json"],
                                     ["grade", scene, "bad.csv"], ["grade", scene, "a.csv", "--max-attitude-error", "1e-9 deg"],
                                     ["grade", scene, "a.csv", "-D", "motion.tilt=1"], ["trajectory", scene, "--at", "x"],
                                     ["trajectory", scene, "--rate", "0"]],
                   scenes, {"bad.csv": b"time_s,qw,qx,qy,qz\n0,1,0,0,0\n0.5,0.9,0.1,0,0\n1,nan,0,0,0\n"})
    yield Case("info", [["info", "scenes/football.toml", "--digits", str(digits)] for digits in (1, 3, 17, 18)]
               + [["info", "scenes/football.toml", "-D", change] for change in
                  ("motion.omega_body=[0,0,3]", "body.mass='1 kg'", "body.mass=-1", "body.sheap=1", "time.duration='90 ms'")], scenes)


def of_words(root):
    """Yields cases of help, explanations, the schema, and mistakes in scenes and on the command line."""
    yield Case("help", [["--help"], ["--version"], [], ["nothing"], *([name, "--help"] for name in SUBCOMMANDS), ["help", "render"]])
    yield Case("self-describe", [["self-describe", "share"]])
    yield Case("explain", [["schema"], ["explain"], *(["explain", name] for name in
                                                     ("camera", "time.speed", "units", "golden", "golden.test.image", "motion", "show", "plot", "bdy"))])
    yield Case("new", [["new", "a"], ["new", "a"], ["new", "b", "--from", "football"], ["new", "c", "--from", "nothing"], ["check", "a.toml"]])
    yield Case("machine", [["doctor"]], varying=NUMBERS)
    football = "scenes/football.toml"
    wrong = ["--frames 9-3", "--frames x", "--fps 0", "--fps 30/0", "--size 0x9", "--size 9", "--shard 4/3", "--segment 0", "-j 0", "--limit side=x",
             "--limit sid=3", "--max-memory 3", "-o f.xyz", "-o f.png --frames 0-4", "--transparent -o f.mp4", "--bits 16 -o f.mp4", "-D body", "-D a=1",
             "-D time.fps=0", "--view 9", "-q 8k", "--backend x", "--format gif -o -", "--manifest f.mp4 -o f.mp4", "--loop --frames 0-9", "--nothing"]
    yield Case("wrong options", [["render", football, *text.split(" ")] for text in wrong], [(root / "scenes", "scenes")])
    sys.path.insert(0, str(root / "tests/fuzz"))
    import seeds  # pylint: disable=import-outside-toplevel
    files = {f"{number:03}.toml": data.split(b"\0")[0] for number, data in enumerate(seeds.scenes())}
    files |= {f"cut/{name}": data[:len(data) * 2 // 3] for name, data in files.items()}
    files |= {f"spoilt/{name}": data.replace(b" = ", b" = -", 3) for name, data in files.items() if "/" not in name}
    files |= {f"letters/{name}": data.replace(b"o", b"oo", 4) for name, data in files.items() if "/" not in name}
    yield Case("check of wrong scenes", [["check", *sorted(files)], *(["info", name] for name in sorted(files)[::5])],
               [(path, path.name) for path in sorted(root.glob("tests/scene/data/*")) if path.is_file() and path.suffix != ".toml"], files)


def cases(root):
    for made in (of_words, of_numbers, of_scenes, of_films, of_pictures, of_comparisons):
        for case in made(root):
            case.common = TIMES
            yield case
