# SPDX-License-Identifier: Apache-2.0
"""The tables of docs/scene.md have six columns, more than a page of the site is wide: there a key has what it means beside it,
and under that, smaller, what it takes."""
import re

TABLE = re.compile(r'^\| key \| type \| range \| default \| example \| meaning \|\n\|[- |]+\|\n((?:\|.*\n)+)', re.M)
CELL_END = re.compile(r'(?<!\\)\|')


def facts(kind, values, default, example):
    """What a key takes, in a line."""
    words = [', '.join(filter(None, (kind, values))), 'no default' if default == 'none' else f'default {default}', f'e.g. {example}']
    return '; '.join(words)


def row(line):
    key, kind, values, default, example, meaning = (cell.strip() for cell in CELL_END.split(line.strip())[1:-1])
    return f'| {key} | {meaning}<br><span class="facts">{facts(kind, values, default, example)}</span> |\n'


def shown(text):
    """The page with its tables of keys as the site shows them."""
    return TABLE.sub(lambda table: '| key | meaning |\n| --- | --- |\n' + ''.join(map(row, table[1].splitlines())), text)
