# SPDX-License-Identifier: Apache-2.0
"""Tests the site of `./poinsot docs`: it is built without warnings, all its links have targets, and films and search work in
a browser that opens the pages as files. Broken links, headings and files are reported.

    site_test.py SITE PROGRAM
"""
import html
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest

SITE, PROGRAM = (pathlib.Path(word) for word in (sys.argv.pop(1), sys.argv.pop(1)))
ROOT = SITE.parents[1]
sys.path[:0] = [str(SITE), str(ROOT / 'tests' / 'support')]
import links  # noqa: E402
from browser import browser  # noqa: E402


def build(folder, *options):
    """Builds the site in folder/site."""
    return subprocess.run([sys.executable, '-B', SITE, '--program', PROGRAM, '--work', f'{folder}/work', '-o', f'{folder}/site',
                           '--draft', *options], capture_output=True, text=True)


def until(true, most_s=60):
    begin = time.monotonic()
    while not true():
        assert time.monotonic() - begin < most_s, 'waited in vain'
        time.sleep(0.05)


class TheSite(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.built = build(cls.folder.name)
        cls.site = pathlib.Path(cls.folder.name, 'site')

    def test_is_built_without_a_warning(self):
        self.assertEqual(self.built.returncode, 0, self.built.stderr)
        self.assertRegex(self.built.stderr, r'^poinsot: making the films of the gallery\npoinsot: \S+/index.html is ready\npoinsot: to read it .*\n$')

    def test_has_a_page_for_each_of_docs(self):
        for page in (ROOT / 'docs').glob('*.md'):
            self.assertTrue((self.site / 'docs' / f'{page.stem}.html').is_file(), page.name)

    def test_shows_a_film_and_the_text_of_every_scene(self):
        gallery = (self.site / 'docs/gallery.html').read_text()
        for scene in (ROOT / 'scenes').glob('*.toml'):
            self.assertIn(f'src="../_static/{scene.stem}.mp4"', gallery)
            self.assertTrue((self.site / f'_static/{scene.stem}.mp4').stat().st_size)
            page = re.sub('<[^>]*>', '', (self.site / f'scenes/{scene.name}.html').read_text())
            self.assertTrue('\n[motion' in page and 'The film lasts' in page, scene.name)

    def test_shows_every_column_of_the_tables_of_keys(self):
        rows = [line.strip('| ').split(' | ') for line in (ROOT / 'docs/scene.md').read_text().splitlines() if line.startswith('| `')]
        keys = [row for row in rows if len(row) == 6]
        self.assertGreater(len(keys), 200)
        shown = html.unescape(re.sub('<[^>]*>', '', (self.site / 'docs/scene.html').read_text())).replace('\\', '')
        for text in {text for row in keys for text in row if text != 'none'}:
            plain = re.sub(r'\[(\w+)\]\(#\w+\)', r'\1', text)
            self.assertTrue(re.sub(r'[`\\]', '', plain) in shown, text)

    def test_shows_the_examples_in_the_page_on_the_library(self):
        shown = re.sub('<[^>]*>', '', (self.site / 'docs/library.html').read_text())
        for example in (ROOT / 'examples').glob('*.cpp'):
            self.assertIn(re.search(r'^int main\(.*$', example.read_text(), re.M)[0], shown)

    def test_works_in_a_browser_as_files(self):
        driver = browser(1400, 1000)
        try:
            driver.get((self.site / 'docs/gallery.html').as_uri())
            until(lambda: driver.execute_script('return document.querySelector("video").played.length') > 0)
            driver.get((self.site / 'search.html').as_uri() + '?q=herpolhode')
            until(lambda: 'The physics' in driver.execute_script(
                'return [...document.querySelectorAll("ul.search a")].map(a => a.innerText)'))
            self.assertEqual([entry['message'] for entry in driver.get_log('browser')], [])
        finally:
            driver.quit()


class AMistake(unittest.TestCase):
    def test_in_a_page_is_reported(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder, 'root')
            (root / 'docs/site').mkdir(parents=True)
            (root / 'README.md').write_text('# Start\n\n[a](docs/page.md)\n\n## Not of the site\n\n[b](nowhere.md)\n')
            (root / 'docs/site/index.md').write_text('[a](../page.md)\n```{toctree}\ndocs/page\n```\n')
            page = root / 'docs/page.md'
            page.write_text('# Page\n\n## Part\n\n[a](#part) [b](page.md#part) [c](page.md) [d](../README.md)\n')
            good = build(folder, '--root', root)
            self.assertEqual(good.returncode, 0, good.stderr)
            before = (pathlib.Path(folder, 'site/docs/page.html')).read_text()
            for link in ('no_such_page.md', '../src/no_such.h', '#no-such-part', 'page.md#no-such-part', '../../outside.md'):
                page.write_text(f'# Page\n\n[a]({link})\n')
                bad = build(folder, '--root', root)
                self.assertNotEqual(bad.returncode, 0, link)
                self.assertIn(re.split('[/#]', link)[-1], bad.stderr)
            self.assertEqual((pathlib.Path(folder, 'site/docs/page.html')).read_text(), before, 'the site that was there stays')

    def test_in_the_name_of_the_folder_deletes_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, 'site').mkdir()
            mine = pathlib.Path(folder, 'site/mine.txt')
            mine.write_text('mine')
            refused = build(folder)
            self.assertNotEqual(refused.returncode, 0)
            self.assertIn('is not a site of this program', refused.stderr)
            self.assertEqual(mine.read_text(), 'mine')

    def test_in_a_built_page_is_reported(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, 'a.html').write_text(
                '<h1 id="top">A</h1><a href="#top"><a href="b.html#there"><a href="https://example.org/x"><a href="a%20b.txt">'
                '<a href="#nowhere"><a href="b.html#nowhere"><a href="c.html"><video src="d.mp4" poster="e.png"></video>'
                '<script src="https://example.org/s.js"></script><img src="//example.org/i.png">')
            pathlib.Path(folder, 'b.html').write_text('<p id="there"></p>')
            pathlib.Path(folder, 'a b.txt').write_text('')
            pathlib.Path(folder, 'c.css').write_text('@import url(/root.css); p { background: url("data:x") } q { content: url("f.png") }')
            self.assertEqual(links.broken(folder), [
                'a.html: #nowhere: has no such heading',
                'a.html: //example.org/i.png: is on another machine',
                'a.html: b.html#nowhere: has no such heading',
                'a.html: c.html: is not there',
                'a.html: d.mp4: is not there',
                'a.html: e.png: is not there',
                'a.html: https://example.org/s.js: is on another machine',
                'c.css: /root.css: is not there',
                'c.css: f.png: is not there'])


if __name__ == '__main__':
    unittest.main()
