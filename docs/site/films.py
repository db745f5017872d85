# SPDX-License-Identifier: Apache-2.0
"""Makes the films of the gallery: a few seconds of each scene around its time.still."""
import pathlib
import re
import subprocess
import sys
import tomllib

FPS = 15
SECONDS = 8


def run(program, *words):
    """Runs the program and returns its output. Exits with the program's exit code if it fails."""
    done = subprocess.run([program, *map(str, words)], text=True, stdout=subprocess.PIPE, check=False)
    if done.returncode:
        sys.exit(done.returncode)
    return done.stdout


def in_words(program, scene):
    """Returns the alt text of the scene's picture on one line."""
    return ' '.join(run(program, 'info', scene, '--alt').split())


def frames(program, scene, film, count):
    """Returns first and last frame of the excerpt, around time.still, or around a third of the film by default."""
    told = run(program, 'render', scene, '-o', film, '--force', '--fps', FPS, '--dry-run')
    number = int(re.search(r': (\d+) frames', told)[1])
    still = tomllib.loads(scene.read_text()).get('time', {}).get('still')
    middle = number // 3 if still is None else round(float(str(still).split()[0]) * FPS)
    first = max(0, min(middle - count // 2, number - count))
    return first, min(first + count, number) - 1


def make(program, scene, film, count=FPS * SECONDS):
    """Makes the film, unless it is newer than the program, the scene and this script."""
    made_of = max(path.stat().st_mtime for path in (pathlib.Path(program), scene, pathlib.Path(__file__)))
    if film.exists() and film.stat().st_mtime > made_of:
        return
    first, last = frames(program, scene, film, count)
    run(program, 'render', scene, '-o', film, '--force', '--quiet', '--size', '480x270', '--fps', FPS,
        '-D', 'output.crf=26', '-D', 'output.effort=slow', '--frames', f'{first}-{last}')
