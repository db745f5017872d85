# SPDX-License-Identifier: Apache-2.0
"""Measures how far pictures move from one Mesa to another. Draws the gallery at its stills and the golden suite with
each program on each back end that works there, and compares: stills with those of the first program on its first back
end, the suite with the approved pictures. Prints a table in Markdown."""

import argparse
import datetime
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from pixel_table import markdown
from system import Failure, System

ROOT = Path(__file__).resolve().parents[2]
SUITE = "tests/golden/golden.toml"
REFERENCES = ROOT / "tests/golden/images"
SCENES = ("scenes/*.toml", SUITE, "tests/golden/scenes/**/*.toml")  # files that each system receives
EXAMPLES = """exit code: 0 if all pictures are identical or near, 1 if one is different, 2 usage, 3 if nothing could be measured

examples:
  pixels.py --program build/bin/poinsot
  pixels.py --program build/bin/poinsot --program /src/build/bin/poinsot --enter 'chroot /srv/trixie sh -c'
"""


class OfLastProgram(argparse.Action):
    """Applies an option to the --program before it."""

    def __call__(self, parser, asked, value, option=None):
        if not asked.systems:
            parser.error(f"{option}: must follow the --program that it applies to")
        setattr(asked.systems[-1], self.dest, value)


def words():
    parser = argparse.ArgumentParser(prog="pixels.py", description=__doc__, epilog=EXAMPLES,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", dest="systems", metavar="PATH", type=System, action="append", required=True,
                        help="poinsot program that draws; may be repeated; the others are compared with the first")
    parser.add_argument("--enter", metavar="COMMAND", action=OfLastProgram,
                        help="command that runs a shell command in the last program's system: it receives one more argument, and its "
                        "standard input and output are passed on. PATH must then be absolute, in that system")
    parser.add_argument("--name", metavar="NAME", action=OfLastProgram,
                        help="name of the last program's system in the table (default: the system's own name)")
    parser.add_argument("--diff-by", metavar="PATH", type=Path, default=ROOT / "build/bin/poinsot",
                        help="poinsot program on this machine that compares (default: %(default)s)")
    parser.add_argument("--size", metavar="WxH", default="1920x1080", help="size of the stills (default: %(default)s)")
    parser.add_argument("--stills", nargs="+", metavar="SCENE", default=[], help="only the stills of these scenes")
    parser.add_argument("--suite", nargs="+", metavar="TEST", default=[], help="only these tests of the golden suite")
    parser.add_argument("--json", metavar="FILE", type=Path, help="write all figures to a file")
    parser.add_argument("--keep", metavar="FOLDER", type=Path, help="keep the pictures in this folder, which must not exist")
    asked = parser.parse_args()
    for system in asked.systems:
        if system.enter and not Path(system.program).is_absolute():
            parser.error(f"--program {system.program}: must be absolute, because --enter runs it in another system")
    if asked.keep and asked.keep.exists():
        parser.error(f"--keep {asked.keep}: exists; name a new folder")
    return asked


def draw(asked, system, backend, folder):
    """Lets a system draw all pictures into the folders stills and suite."""
    files = [file for pattern in SCENES for file in ROOT.glob(pattern)]
    drawing = ["--backend", backend, "--quiet"]
    stills = ["gallery", "scenes", "--reproducible", "--size", asked.size, "--no-sheet", "-o", "stills", *drawing]
    suite = ["golden", SUITE, "-o", "suite", *drawing]  # golden is reproducible by default
    system.draw([(stills + only(asked.stills), 0), (suite + only(asked.suite), 1)],  # exit code 1: there are no references
                {file.relative_to(ROOT): file.read_bytes() for file in files}, folder)


def only(names):
    return ["--only", *names] if names else []


def approved(asked, folder):
    """Links the approved pictures of the selected tests of the suite in a folder, and returns the folder."""
    listed = subprocess.run([asked.diff_by.resolve(), "golden", SUITE, "--list", *only(asked.suite)], cwd=ROOT, capture_output=True,
                            text=True)
    if listed.returncode:
        raise Failure(listed.stderr)
    folder.mkdir()
    for name in listed.stdout.split():
        (folder / f"{name}.png").symlink_to(REFERENCES / f"{name}.png")
    return folder


def compare(asked, reference, drawn):
    """Returns the figures of a row, from `diff` with its default rule."""
    run = subprocess.run([asked.diff_by.resolve(), "diff", reference, drawn, "--json"], capture_output=True, text=True)
    if run.returncode not in (0, 1):
        raise Failure(run.stderr)
    outcome = json.loads(run.stdout)
    if missing := outcome["only_in_reference"] + outcome["only_in_test"]:
        raise Failure(f"{drawn}: no counterpart of {', '.join(missing)}")
    pictures = outcome["pictures"]
    moved = [{key: picture[key] for key in ("name", "verdict", "differing_pixels", "max_difference")}
             for picture in pictures if picture["verdict"] != "identical"]
    return {"pictures": len(pictures), "equal": len(pictures) - len(moved), "verdict": outcome["verdict"],
            "differing_pixels": sum(each["differing_pixels"] or 0 for each in moved),
            "max_difference": max((each["max_difference"] or 0 for each in moved), default=0), "moved": moved}


def measure(asked, folder):
    """Returns a row for each system, back end and set of pictures, and the absent back ends."""
    references = {"suite": approved(asked, folder / "approved")}
    rows, absent = [], []
    for number, system in enumerate(asked.systems):
        facts, backends = system.probe()
        absent += [{**facts, "backend": name, "reason": text} for name, works, text in backends if not works]
        for backend in (name for name, works, _ in backends if works):
            place = folder / f"{number}-{backend}"
            print(f"drawing on {facts['system']}, {backend}", file=sys.stderr, flush=True)
            draw(asked, system, backend, place)
            for pictures in ("stills", "suite"):
                reference = references.setdefault(pictures, place / pictures)
                rows.append({**facts, "backend": backend, "set": pictures, "is_reference": reference == place / pictures,
                             **compare(asked, reference, place / pictures)})
    return rows, absent


def main():
    asked = words()
    try:
        with tempfile.TemporaryDirectory(prefix="poinsot-pixels-") as scratch:
            folder = asked.keep or Path(scratch)
            folder.mkdir(exist_ok=True, parents=True)
            rows, absent = measure(asked, folder)
        report = {"date": datetime.date.today().isoformat(), "size": asked.size, "rows": rows, "absent": absent}
        if asked.json:
            asked.json.write_text(json.dumps(report, indent=1) + "\n")
    except (Failure, OSError) as failure:
        print(f"pixels.py: {failure}".rstrip(), file=sys.stderr)
        return 3
    print(markdown(report), end="")
    return int(any(row["verdict"] == "different" for row in rows))


if __name__ == "__main__":
    sys.exit(main())
