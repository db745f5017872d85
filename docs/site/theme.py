# SPDX-License-Identifier: Apache-2.0
"""Debian's theme made whole: it takes a style sheet from the web server's root and a script as a module, and pages that are
files have neither."""
import pathlib
import re

IMPORTED_STYLE = re.compile(r'@import url\((/javascript/[^)]+)\);')
UNRESOLVED_STYLE = re.compile(r'@import "~[^"]+";')  # a name of the theme's build tool, which Debian's package kept
IMPORTED_SCRIPT = re.compile(r'^import (?:\* as )?\w+ from "\./([^"]+)";$', re.M)
SCRIPT_TAG = re.compile(r'<script [^>]*scripts/furo\.js[^>]*>')


def make_whole(site):
    """Puts what the theme's files import in its place."""
    styles, script = site / '_static/styles/furo.css', site / '_static/scripts/furo.js'
    if styles.exists():
        text = UNRESOLVED_STYLE.sub('', styles.read_text())
        styles.write_text(IMPORTED_STYLE.sub(lambda match: pathlib.Path('/usr/share' + match[1]).read_text(), text))
    if script.exists():
        script.write_text(IMPORTED_SCRIPT.sub(lambda match: (script.parent / match[1]).read_text(), script.read_text()))
    for page in site.rglob('*.html'):
        page.write_text(SCRIPT_TAG.sub(lambda match: match[0].replace(' type="module"', ''), page.read_text()))
