# SPDX-License-Identifier: Apache-2.0
"""Checks links of built pages: all targets must exist, also headings, and nothing may be loaded from another machine.

Debian's linkchecker is not used, because it reads the pages as another user when root starts it.
"""
import html.parser
import pathlib
import re
import urllib.parse

STYLE_URL = re.compile(r'''url\(\s*["']?((?!data:|#)[^"')\s]+)''')
LOADED = {'script': 'src', 'img': 'src', 'video': 'src', 'source': 'src', 'iframe': 'src', 'link': 'href'}


class Styles:
    """Files that a style sheet loads, in the form of a Page."""

    def __init__(self, path):
        self.names, self.links = set(), set()
        self.loaded = set(STYLE_URL.findall(path.read_text()))


class Page(html.parser.HTMLParser):
    """Content of an HTML page: anchors, links, and files that a browser loads to show the page."""

    def __init__(self, path):
        super().__init__()
        self.names, self.links, self.loaded = set(), set(), set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        of = dict(attributes)
        self.names.update(of[key] for key in ('id', 'name') if of.get(key))
        if tag == 'a' and of.get('href'):
            self.links.add(of['href'])
        if of.get('poster'):
            self.loaded.add(of['poster'])
        if of.get(LOADED.get(tag)) and of.get('rel') != 'canonical':
            self.loaded.add(of[LOADED[tag]])

    handle_startendtag = handle_starttag


def elsewhere(link):
    return bool(urllib.parse.urlsplit(link).netloc)


def problem_of(link, place, pages):
    """Returns the problem of a link on the page at `place`, or an empty text."""
    parts = urllib.parse.urlsplit(link)
    target = (place.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else place
    if not target.is_file():
        return 'is not there'
    name = urllib.parse.unquote(parts.fragment)
    if name and target in pages and name not in pages[target].names:
        return 'has no such heading'
    return ''


def broken(site):
    """Returns a line for each link without a target, and for each file that is loaded from another machine."""
    site = pathlib.Path(site).resolve()
    pages = {path: Page(path) for path in sorted(site.rglob('*.html'))} | {path: Styles(path) for path in site.rglob('*.css')}
    wrong = []
    for place, page in pages.items():
        for link in sorted(page.links | page.loaded):
            if elsewhere(link):
                problem = 'is on another machine' if link in page.loaded else ''
            else:
                problem = problem_of(link, place, pages)
            if problem:
                wrong.append(f'{place.relative_to(site)}: {link}: {problem}')
    return wrong
