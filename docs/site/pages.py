# SPDX-License-Identifier: Apache-2.0
"""The pages of the site, from those of the repository.

Every page lies in the site where it lies in the repository, so that its links stay what they are. A file that a page
links to and that is no page (a scene, a source) becomes one that shows it, a folder one that lists what is in it.
Three things are shown otherwise than in a repository's browser: a row of the gallery is a card with a film, a table of
keys has two columns (key_tables.py), and of a paragraph that is nothing but a link into examples/ the file's text is
part.
"""
import os
import pathlib
import re
import shutil

import key_tables

START = ('README.md', 'docs/site/index.md')
LINK = re.compile(r'\]\(([^()#\s]+)(#[^()\s]*)?\)')
TABLE = re.compile(r'^\| scene \| lesson \|\n\| --- \| --- \|\n((?:\|.*\n)+)', re.M)
ROW = re.compile(r'^\| !\[\]\(images/gallery/(\w+)\.png\) (\[\w+\]\(\S+\)) \| (.*) \|$', re.M)
SHOWN = re.compile(r'^\[[^\]]*\]\(([^()#\s]*\bexamples/[^()#\s]+)\)$')
PICTURES = ('.png', '.svg')
LANGUAGES = {'.h': 'cpp', '.cpp': 'cpp', '.toml': 'toml', '.py': 'python', '.cmake': 'cmake', '.txt': 'cmake', '.sh': 'bash',
             '.frag': 'glsl', '.vert': 'glsl', '.glsl': 'glsl'}


def film(name, where):
    """A film of media/, as a page in the folder `where` shows it."""
    media = os.path.relpath('_static', where)
    return (f'<video class="film" muted loop playsinline controls preload="none" width="480" height="270" '
            f'poster="{media}/{name}.png" src="{media}/{name}.mp4" aria-label="film: {name}"></video>')


def raw(html):
    return f'```{{raw}} html\n{html}\n```\n'


def cards(rows, where):
    """Rows of the gallery's tables as cards."""
    each = (f':::{{container}} card\n{raw(film(name, where))}\n{link}\n\n{lesson}\n:::\n' for name, link, lesson in ROW.findall(rows))
    return '::::{container} cards\n' + ''.join(each) + '::::\n'


class Pages:
    """Stages the pages of the repository `root` in `folder`."""

    def __init__(self, root, folder, words):
        self.root, self.folder = pathlib.Path(root), pathlib.Path(folder)
        self.words = words  # of each scene of the gallery, what is to be seen
        self.staged = set()

    def stage(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.start_page()
        for page in sorted([*self.root.glob('docs/*.md'), *self.root.glob('*.md')]):
            self.target(str(page.relative_to(self.root)))

    def write(self, place, text):
        path = self.folder / place
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def start_page(self):
        """How the README begins, and where to go on from there."""
        beginning = (self.root / START[0]).read_text().split('\n## ')[0]
        ways = (self.root / START[1]).read_text()
        parts = zip(START, (beginning, ways))
        lines = (line for source, text in parts for line in self.lines(text.split('\n'), source, 'index.md'))
        self.write('index.md', '---\nhide-toc: true\n---\n\n' + '\n'.join(lines))

    def page(self, place):
        """Stages a page, and all that it links to."""
        if place in self.staged:
            return place
        self.staged.add(place)
        text = key_tables.shown((self.root / place).read_text())
        text = TABLE.sub(lambda table: cards(table[1], os.path.dirname(place)), text)
        self.write(place, '\n'.join(self.lines(text.split('\n'), place, place)))
        return place

    def lines(self, lines, source, place):
        fenced = False
        for line in lines:
            fenced ^= line.startswith('```')
            yield line if fenced else self.linked(line, source, place)
            shown = None if fenced else SHOWN.match(line)
            if shown:
                yield '\n' + self.file_text(self.root / self.place_of(shown[1], source))

    def place_of(self, link, source):
        """Where in the repository a link leads."""
        return os.path.normpath(os.path.join(os.path.dirname(source), link))

    def linked(self, line, source, place):
        """The line with its links leading to what is staged."""
        def to(match):
            link, anchor = match[1], match[2] or ''
            if '://' in link:
                return match[0]
            staged = self.target(self.place_of(link, source))
            return f']({os.path.relpath(staged, os.path.dirname(place) or ".")}{anchor})'
        return LINK.sub(to, line)

    def target(self, target):
        """Stages what lies at that place of the repository, if anything does, and says where it is then."""
        path = self.root / target
        if target.startswith('..') or not path.exists():
            return target  # Sphinx will say that it is not there
        if target in START:
            return 'index.md'
        if path.is_dir():
            return self.listing(target)
        if path.suffix == '.md':
            return self.page(target)
        if path.suffix in PICTURES:
            (self.folder / target).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, self.folder / target)
            return target
        return self.file(target)

    def file_text(self, path):
        language = LANGUAGES.get(path.suffix, 'none')
        fence = '`' * 8
        return f'{fence}{language}\n{path.read_text().rstrip()}\n{fence}\n'

    def file(self, target):
        """A page that shows a file."""
        place = target + '.md'
        if place in self.staged:
            return place
        self.staged.add(place)
        name = pathlib.Path(target).stem
        parts = ['---\norphan: true\nnosearch: true\nhide-toc: true\n---\n', f'# {target}\n']
        if os.path.dirname(target) == 'scenes':
            parts += [raw(film(name, 'scenes')), f':::{{container}} words\n{self.words[name]}\n:::\n']
        self.write(place, '\n'.join(parts + [self.file_text(self.root / target)]))
        return place

    def listing(self, target):
        """A page that lists what is in a folder."""
        place = target + '/index.md'
        if place in self.staged:
            return place
        self.staged.add(place)
        entries = sorted(entry for entry in (self.root / target).iterdir() if not entry.name.startswith('.'))
        rows = []
        for entry in entries:
            staged = self.target(str(entry.relative_to(self.root)))
            rows.append(f'- [{entry.name}]({os.path.relpath(staged, target)})')
        self.write(place, '\n'.join(['---\norphan: true\nnosearch: true\n---\n', f'# {target}\n'] + rows + ['']))
        return place
