# SPDX-License-Identifier: Apache-2.0
"""Makes the pages under test: the program compares small pictures that differ in known ways."""
import os
import random
import subprocess

from page_driver import expect, png

RED, BLUE, GREY, WHITE, BLACK = (200, 30, 30), (30, 60, 200), (128, 128, 128), (255, 255, 255), (0, 0, 0)
HOSTILE = "it's <b onclick=alert(1)> & $(touch x) \u00e9.png"
COMMIT = '0123456789abcdef0123456789abcdef01234567'


def block(left, top, width, height, colour, ground=GREY):
    return lambda x, y: colour if left <= x < left + width and top <= y < top + height else ground


def suite(program, folder):
    """Makes the page of a golden.toml with pictures that are identical, brighter in a pixel, of another colour, without a block,
    torn, new and no longer made."""
    environment = {**os.environ, 'CI': ''}
    names = ['same', 'brighter', 'recoloured', 'lost', 'torn', 'gone']
    test = "[[test]]\nimage = '{}.png'\n".format
    (folder / 'golden.toml').write_text(''.join(map(test, names)))
    for name in names:
        png(folder / f'{name}.png', lambda x, y: RED if name == 'recoloured' else GREY)
    png(folder / 'lost.png', block(300, 200, 20, 12, BLUE), 400, 300)
    subprocess.run([program, 'golden', '--update'], cwd=folder, env=environment, check=True)
    png(folder / 'brighter.png', lambda x, y: tuple(v + 1 for v in GREY) if (x, y) == (5, 5) else GREY)
    png(folder / 'recoloured.png', lambda x, y: BLUE)
    png(folder / 'lost.png', lambda x, y: GREY, 400, 300)
    png(folder / 'fresh.png', lambda x, y: BLUE)
    (folder / 'torn.png').write_bytes((folder / 'torn.png').read_bytes()[:60])
    (folder / 'golden.toml').write_text(''.join(map(test, names[:-1] + ['fresh'])))
    made = subprocess.run([program, 'golden', '--report', 'report.html'], cwd=folder, env=environment)
    assert made.returncode == 1, made.returncode
    return folder / 'report.html'


def pairs(program, folder):
    """Makes the page of two folders, in a git work tree that this function writes by hand."""
    for name in ('old', 'new', '.git/refs/heads'):
        (folder / name).mkdir(parents=True)
    (folder / '.git/HEAD').write_text('ref: refs/heads/main\n')
    (folder / '.git/refs/heads/main').write_text(COMMIT + '\n')
    old, new = folder / 'old', folder / 'new'
    chance = random.Random(1)
    noise = [[tuple(chance.randrange(256) for _ in range(3)) for _ in range(64)] for _ in range(48)]
    png(old / 'moved.png', lambda x, y: noise[y][x])
    png(new / 'moved.png', lambda x, y: noise[y][max(x - 1, 0)])
    two = block(20, 20, 30, 10, BLUE)
    png(old / 'two.png', lambda x, y: RED if 200 <= x < 210 and 100 <= y < 105 else two(x, y), 240, 120)
    png(new / 'two.png', lambda x, y: GREY, 240, 120)
    png(old / 'size.png', lambda x, y: RED)
    png(new / 'size.png', lambda x, y: BLUE, 80, 60)
    for name in ('same.png', 'torn.png', 'gone.png', HOSTILE):
        png(old / name, lambda x, y: BLUE)
    png(new / 'same.png', lambda x, y: BLUE)
    png(new / HOSTILE, lambda x, y: RED)
    png(new / 'more.png', lambda x, y: RED)
    (new / 'torn.png').write_bytes((old / 'torn.png').read_bytes()[:60])
    made = subprocess.run([program, 'diff', 'old', 'new', '--report', 'pairs.html'], cwd=folder, capture_output=True)
    expect(made.returncode, 4, 'exit code where one cannot be read')
    return folder / 'pairs.html'


def ignored(program, folder):
    """Makes the page of a pair with an ignored box. One pixel outside the box differs."""
    png(folder / 'a.png', lambda x, y: GREY, 120, 80)
    png(folder / 'b.png', lambda x, y: WHITE if (x, y) == (100, 70) or y < 20 else GREY, 120, 80)
    made = subprocess.run([program, 'diff', 'a.png', 'b.png', '--ignore', '0,0,120,20', '--report', 'ignored.html', '--quiet'], cwd=folder)
    expect(made.returncode, 1, 'exit code of a pixel outside of the ignored box')
    return folder / 'ignored.html'


def many(program, folder):
    """Makes the page of 402 pairs. 101 differ, each a little more than the one before; k0 differs least."""
    for name in ('m_old', 'm_new'):
        (folder / name).mkdir()
    for k in range(402):
        png(folder / 'm_old' / f'k{k}.png', lambda x, y: BLACK, 4, 3)
        png(folder / 'm_new' / f'k{k}.png', lambda x, y: (k + 100,) * 3 if k < 101 else BLACK, 4, 3)
    made = subprocess.run([program, 'diff', 'm_old', 'm_new', '--report', 'many.html', '--quiet'], cwd=folder)
    expect(made.returncode, 1, 'exit code of folders that differ')
    return folder / 'many.html'


def films(program, folder):
    """Makes the page of two films of 41 frames that differ in frames 10 and 30 (counted from 0)."""
    for name, odd in (('a', []), ('b', [10, 30])):
        frames = folder / name
        frames.mkdir()
        for k in range(41):
            png(frames / f'{k:02}.png', lambda x, y: BLUE if k in odd else GREY)
        subprocess.run(['ffmpeg', '-v', 'error', '-framerate', '10', '-i', frames / '%02d.png', '-c:v', 'ffv1',
                        '-pix_fmt', 'bgr0', folder / f'{name}.mkv'], check=True)
    made = subprocess.run([program, 'diff', 'a.mkv', 'b.mkv', '--report', 'film.html'], cwd=folder)
    expect(made.returncode, 1, 'exit code of different films')
    return folder / 'film.html'
