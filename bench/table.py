# SPDX-License-Identifier: Apache-2.0
"""Markdown tables that are also readable in a terminal."""


def table(heads, rows):
    """Returns a table of texts. The first column is aligned left, the others right."""
    widths = [max(map(len, column)) for column in zip(heads, *rows)]
    rules = ['-' * widths[0]] + ['-' * (width - 1) + ':' for width in widths[1:]]
    return '\n'.join('| ' + ' | '.join([row[0].ljust(widths[0])] +
                                       [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])]) + ' |'
                     for row in [heads, rules, *rows])


def seconds(value):
    return f'{value:.2f} s'


def milliseconds(value_s):
    return f'{value_s * 1e3:.1f} ms'


def mebibytes(value):
    return f'{value:.0f} MiB'


def ratio(value):
    return f'{value:.2f}'
