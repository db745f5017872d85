# SPDX-License-Identifier: Apache-2.0
"""Repairs Debian's theme for pages that are opened as files. The theme imports a style sheet from a web server's root, and
a script as a module; neither works without a web server."""
import pathlib
import re

IMPORTED_STYLE = re.compile(r'@import url\((/javascript/[^)]+)\);')
UNRESOLVED_STYLE = re.compile(r'@import "~[^"]+";')  # name for the theme's build tool, left in Debian's package
IMPORTED_SCRIPT = re.compile(r'^import (?:\* as )?\w+ from "\./([^"]+)";$', re.M)
SCRIPT_TAG = re.compile(r'<script [^>]*scripts/furo\.js[^>]*>')


def make_whole(site):
    """Replaces the imports in the theme's files by the imported texts."""
    styles, script = site / '_static/styles/furo.css', site / '_static/scripts/furo.js'
    if styles.exists():
        text = UNRESOLVED_STYLE.sub('', styles.read_text())
        styles.write_text(IMPORTED_STYLE.sub(lambda match: pathlib.Path('/usr/share' + match[1]).read_text(), text))
    if script.exists():
        script.write_text(IMPORTED_SCRIPT.sub(lambda match: (script.parent / match[1]).read_text(), script.read_text()))
    for page in site.rglob('*.html'):
        page.write_text(SCRIPT_TAG.sub(lambda match: match[0].replace(' type="module"', ''), page.read_text()))
