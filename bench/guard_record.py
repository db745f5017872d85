# SPDX-License-Identifier: Apache-2.0
"""The file of recorded figures, guard.toml: how many instructions each part took, and what it was made with."""
import dataclasses
import json
import re
import tomllib

HEAD = '''# SPDX-License-Identifier: Apache-2.0
# Instructions of each part as valgrind counts them, written by `./poinsot bench --guard --record`.
'''


@dataclasses.dataclass(frozen=True)
class Record:
    made_with: dict  # name: version
    instructions: dict  # part: number

    def of(self, part):
        """@throws ValueError unless there is a figure to divide by."""
        number = self.instructions.get(part)
        if not isinstance(number, int) or number < 1:
            raise ValueError(f'{part}: no number of instructions is recorded; --record does')
        return number


def read(path):
    """@throws ValueError with the path, for a file that is no such record."""
    try:
        tables = tomllib.loads(path.read_text())
        return Record(dict(tables['made_with']), dict(tables['instructions']))
    except KeyError as error:
        raise ValueError(f'{path}: the table {error} is missing') from error
    except (TypeError, ValueError) as error:
        raise ValueError(f'{path}: {error}') from error


def write(path, record):
    path.write_text(HEAD + ''.join(_table(name, getattr(record, name)) for name in ('made_with', 'instructions')))


def _table(name, values):
    return '\n'.join([f'\n[{name}]'] + [f'{_key(key)} = {_word(value)}' for key, value in values.items()]) + '\n'


def _key(key):
    return key if re.fullmatch(r'[\w-]+', key, re.ASCII) else _word(key)  # "libstdc++" stands in quotes


def _word(value):
    return json.dumps(value, ensure_ascii=False)  # strings and numbers are written in TOML as they are in JSON
