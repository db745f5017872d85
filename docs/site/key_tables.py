# SPDX-License-Identifier: Apache-2.0
"""Converts the tables of keys in docs/scene.md. Their six columns are too wide for the site, which shows two: the key, and
its meaning with type, range, default and example in small print below."""
import re

TABLE = re.compile(r'^\| key \| type \| range \| default \| example \| meaning \|\n\|[- |]+\|\n((?:\|.*\n)+)', re.M)
CELL_END = re.compile(r'(?<!\\)\|')


def facts(kind, values, default, example):
    """Returns type, range, default and example of a key on one line."""
    words = [', '.join(filter(None, (kind, values))), 'no default' if default == 'none' else f'default {default}', f'e.g. {example}']
    return '; '.join(words)


def row(line):
    key, kind, values, default, example, meaning = (cell.strip() for cell in CELL_END.split(line.strip())[1:-1])
    return f'| {key} | {meaning}<br><span class="facts">{facts(kind, values, default, example)}</span> |\n'


def shown(text):
    """Returns the page with its tables of keys converted to two columns."""
    return TABLE.sub(lambda table: '| key | meaning |\n| --- | --- |\n' + ''.join(map(row, table[1].splitlines())), text)
