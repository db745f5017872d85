# SPDX-License-Identifier: Apache-2.0
"""Makes a site of docs/ that can be read without a network: `./poinsot docs`.

    python3 -B docs/site --program build/bin/poinsot --work build/site --out out/site
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys

import films
import links
import pages
import theme

HERE = pathlib.Path(__file__).resolve().parent


def arguments():
    parser = argparse.ArgumentParser(prog='./poinsot docs', description='make a site of docs/ that can be read without a network')
    parser.add_argument('--program', required=True, help=argparse.SUPPRESS)
    parser.add_argument('--work', type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument('--root', type=pathlib.Path, default=HERE.parents[1], help=argparse.SUPPRESS)
    parser.add_argument('-o', '--out', type=pathlib.Path, default='out/site', help='folder to write to (default: out/site)')
    parser.add_argument('--draft', action='store_true', help='use one film of three frames in place of all films of the gallery')
    return parser.parse_args()


def make_media(options, media):
    """Makes the films of the gallery and their posters. Returns the alt text of each scene, by its name."""
    print('poinsot: making the films of the gallery', file=sys.stderr)
    media.mkdir(parents=True, exist_ok=True)
    scenes = sorted(options.root.glob('scenes/*.toml'))
    for scene in scenes:
        film = media / f'{scene.stem}.mp4'
        if options.draft and scene != scenes[0]:
            shutil.copyfile(media / f'{scenes[0].stem}.mp4', film)
        else:
            films.make(options.program, scene, film, **({'count': 3} if options.draft else {}))
        shutil.copyfile(options.root / f'docs/images/gallery/{scene.stem}.png', film.with_suffix('.png'))
    return {scene.stem: films.in_words(options.program, scene) for scene in scenes}


def check_target(out):
    """Exits with an error if `out` exists and is neither empty nor a site."""
    if out.exists() and not (out / '_static/films.js').is_file() and (not out.is_dir() or any(out.iterdir())):
        sys.exit(f'poinsot: error: {out}: exists and is not a site of this program; name another folder, or remove it')


def stage(options):
    """Collects everything that Sphinx reads in one folder, and returns the folder."""
    films_folder = options.work / ('draft' if options.draft else 'films')
    words = make_media(options, films_folder)
    staged = options.work / 'pages'
    pages.Pages(options.root, staged, words).stage()
    shutil.copy(HERE / 'conf.py', staged)
    for folder in (HERE / 'static', films_folder):
        shutil.copytree(folder, staged / 'static', ignore=shutil.ignore_patterns('*.srt', '*.vtt'), dirs_exist_ok=True)
    return staged


def build(staged, work):
    """Builds the site in a folder of `work`, and returns the folder. Exits with an error if a page or link is broken."""
    built = work / 'html'
    shutil.rmtree(built, ignore_errors=True)
    told = subprocess.run([sys.executable, '-B', '-m', 'sphinx', '-q', '-W', '--keep-going', '-j', str(os.cpu_count()),
                           '-d', work / 'doctrees', '-b', 'html', staged, built])
    theme.make_whole(built)
    wrong = links.broken(built)
    print(*wrong, sep='\n', end='\n' if wrong else '', file=sys.stderr)
    if told.returncode or wrong:
        sys.exit('poinsot: error: the site has broken links or pages')
    return built


def main():
    options = arguments()
    check_target(options.out)
    built = build(stage(options), options.work)
    shutil.rmtree(options.out, ignore_errors=True)
    shutil.copytree(built, options.out)
    print(f'poinsot: {options.out}/index.html is ready\n'
          f'poinsot: to read it from another machine (ssh -L 8000:127.0.0.1:8000): '
          f'python3 -m http.server -b 127.0.0.1 -d {options.out} 8000', file=sys.stderr)


if __name__ == '__main__':
    main()
