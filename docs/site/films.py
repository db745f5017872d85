# SPDX-License-Identifier: Apache-2.0
"""The films of the gallery: of each scene some seconds about the instant that it calls telling, made by the program."""
import pathlib
import re
import subprocess
import sys
import tomllib

FPS = 15
SECONDS = 8


def run(program, *words):
    """What the program prints; what it cannot do ends this one too."""
    done = subprocess.run([program, *map(str, words)], text=True, stdout=subprocess.PIPE, check=False)
    if done.returncode:
        sys.exit(done.returncode)
    return done.stdout


def in_words(program, scene):
    """What is to be seen in the scene's picture; its lines are joined."""
    return ' '.join(run(program, 'info', scene, '--alt').split())


def frames(program, scene, film, count):
    """First and last frame of the film's part that is shown: about time.still, a third of the way if there is none."""
    told = run(program, 'render', scene, '-o', film, '--force', '--fps', FPS, '--dry-run')
    number = int(re.search(r': (\d+) frames', told)[1])
    still = tomllib.loads(scene.read_text()).get('time', {}).get('still')
    middle = number // 3 if still is None else round(float(str(still).split()[0]) * FPS)
    first = max(0, min(middle - count // 2, number - count))
    return first, min(first + count, number) - 1


def make(program, scene, film, count=FPS * SECONDS):
    """Makes the film, unless it is newer than the program, the scene and what is said here."""
    made_of = max(path.stat().st_mtime for path in (pathlib.Path(program), scene, pathlib.Path(__file__)))
    if film.exists() and film.stat().st_mtime > made_of:
        return
    first, last = frames(program, scene, film, count)
    run(program, 'render', scene, '-o', film, '--force', '--quiet', '--size', '480x270', '--fps', FPS,
        '-D', 'output.crf=26', '-D', 'output.effort=slow', '--frames', f'{first}-{last}')
