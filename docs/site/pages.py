# SPDX-License-Identifier: Apache-2.0
"""Makes the pages of the site from the pages of the repository.

Every page has the same path in the site as in the repository, so that its links stay valid. If a page links to another
file (a scene, a source), that file becomes a page that shows it. A folder becomes a page that lists its files. The site
differs from the repository's web pages in three ways: a row of the gallery is a card with a film, a table of keys has
two columns (key_tables.py), and the file is shown below a paragraph that is only a link into examples/.
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
    """Returns HTML for a film of the gallery on a page in the folder `where`."""
    media = os.path.relpath('_static', where)
    return (f'<video class="film" muted loop playsinline controls preload="none" width="480" height="270" '
            f'poster="{media}/{name}.png" src="{media}/{name}.mp4" aria-label="film: {name}"></video>')


def raw(html):
    return f'```{{raw}} html\n{html}\n```\n'


def cards(rows, where):
    """Returns the rows of a table of the gallery as cards."""
    each = (f':::{{container}} card\n{raw(film(name, where))}\n{link}\n\n{lesson}\n:::\n' for name, link, lesson in ROW.findall(rows))
    return '::::{container} cards\n' + ''.join(each) + '::::\n'


class Pages:
    """Stages the pages of the repository `root` in `folder`."""

    def __init__(self, root, folder, words):
        self.root, self.folder = pathlib.Path(root), pathlib.Path(folder)
        self.words = words  # alt text of each scene of the gallery
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
        """Writes the start page: the beginning of README.md, then docs/site/index.md."""
        beginning = (self.root / START[0]).read_text().split('\n## ')[0]
        ways = (self.root / START[1]).read_text()
        parts = zip(START, (beginning, ways))
        lines = (line for source, text in parts for line in self.lines(text.split('\n'), source, 'index.md'))
        self.write('index.md', '---\nhide-toc: true\n---\n\n' + '\n'.join(lines))

    def page(self, place):
        """Stages a page and everything that it links to. Returns its path."""
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
        """Returns the path in the repository of a link on the page `source`."""
        return os.path.normpath(os.path.join(os.path.dirname(source), link))

    def linked(self, line, source, place):
        """Returns the line with links to the staged files."""
        def to(match):
            link, anchor = match[1], match[2] or ''
            if '://' in link:
                return match[0]
            staged = self.target(self.place_of(link, source))
            return f']({os.path.relpath(staged, os.path.dirname(place) or ".")}{anchor})'
        return LINK.sub(to, line)

    def target(self, target):
        """Stages a file or folder of the repository, if it exists. Returns its path in the site."""
        path = self.root / target
        if target.startswith('..') or not path.exists():
            return target  # Sphinx reports the missing file
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
        """Writes a page that shows a file. Returns its path."""
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
        """Writes a page that lists the files of a folder. Returns its path."""
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
