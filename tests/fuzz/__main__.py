# SPDX-License-Identifier: Apache-2.0
"""Runs the fuzz programs of a build folder. Writes only into that folder."""

import argparse
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import seeds

SCENE_RUNS, OTHER_RUNS = 10_000_000, 2_000_000
# Longest input in bytes. For other targets it is 4 KiB, which is more than any scene of the gallery has.
LONGEST = {"mesh": 65536, "png": 65536}
ABSENT = 77  # exit code that CTest reports as "skipped"
INTERRUPTED = 72  # libFuzzer's exit code for Ctrl-C


def words():
    parser = argparse.ArgumentParser(prog="poinsot fuzz", description=__doc__)
    parser.add_argument("target", nargs="*", help=f"{', '.join(seeds.TARGETS)} (default: all)")
    parser.add_argument("--build", type=Path, required=True, help=argparse.SUPPRESS)
    amount = parser.add_mutually_exclusive_group()
    amount.add_argument("--runs", type=int, help=f"runs of each target (default: {SCENE_RUNS:,} of scene, {OTHER_RUNS:,} of the others)")
    amount.add_argument("--seconds", type=float, help="time for all targets together, instead of a number of runs")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="targets that run at a time (default: one per CPU)")
    parser.add_argument("--afresh", action="store_true", help="begin with the seeds only, without inputs that earlier runs found")
    parser.add_argument("--built", action="store_true", help=argparse.SUPPRESS)  # only the targets that are built
    asked = parser.parse_args()
    unknown = set(asked.target) - set(seeds.TARGETS)
    if unknown:
        parser.error(f"no such target: {', '.join(sorted(unknown))}")
    asked.target = asked.target or [target for target in seeds.TARGETS if not asked.built or program(asked, target).exists()]
    return asked


def program(asked, target):
    return asked.build / "bin" / f"fuzz_{target}"


def prepare(folder, target, afresh):
    """Makes the folders of a target: seeds, corpus for inputs that runs find useful, and found for failures."""
    if afresh:
        shutil.rmtree(folder / "corpus", ignore_errors=True)
    shutil.rmtree(folder / "seeds", ignore_errors=True)
    for name in ("seeds", "corpus", "found"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    for number, seed in enumerate(seeds.TARGETS[target]()):
        (folder / "seeds" / f"{number:03}").write_bytes(seed)
    (folder / "words.dict").write_text(seeds.dictionary(target))


def command(asked, target):
    limits = [f"-max_len={LONGEST.get(target, 4096)}", "-timeout=10", "-rss_limit_mb=1024", "-reload=0", "-print_final_stats=1"]
    if asked.seconds is not None:
        limits.append(f"-max_total_time={max(1, round(asked.seconds / len(asked.target)))}")
    else:
        limits.append(f"-runs={asked.runs or (SCENE_RUNS if target == 'scene' else OTHER_RUNS)}")
    return [program(asked, target), "corpus", "seeds", "-dict=words.dict", "-artifact_prefix=found/", "-verbosity=1", *limits]


def run(asked, target):
    """Runs a target. Returns whether it found nothing."""
    folder = asked.build / "runs" / target
    prepare(folder, target, asked.afresh)
    begin = time.monotonic()
    with open(folder / "log", "wb") as log:
        # Without stacks of allocations, which cost a tenth of the time. To see the stack of a leak, repeat the run by hand.
        environment = {**os.environ, "ASAN_OPTIONS": "quarantine_size_mb=32:malloc_context_size=0"}
        code = subprocess.call(command(asked, target), cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=log, stderr=log)
    spent = time.monotonic() - begin
    text = (folder / "log").read_text(errors="replace")
    said = re.search(r"number_of_executed_units: (\d+)", text)
    count = int(said.group(1)) if said else 0
    outcome = "nothing found" if code == 0 else "interrupted" if code == INTERRUPTED else f"FOUND: {folder / 'log'}"
    print(f"{target:17} {count:>11,} runs, {count / spent:>6,.0f}/s  {outcome}", flush=True)
    return code == 0


def main():
    asked = words()
    if not asked.target or not all(program(asked, target).exists() for target in asked.target):
        print(f"the programs do not exist in {asked.build}; ./poinsot fuzz builds them", file=sys.stderr)
        return ABSENT
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        return 0 if all(list(pool.map(lambda target: run(asked, target), asked.target))) else 1


if __name__ == "__main__":
    sys.exit(main())
