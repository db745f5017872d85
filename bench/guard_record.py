# SPDX-License-Identifier: Apache-2.0
"""Reads and writes guard.toml: recorded instructions of each part, and the versions of compiler and libraries."""
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
    instructions: dict  # part: count

    def of(self, part):
        """Returns the count of a part. @throws ValueError unless a positive count is recorded."""
        number = self.instructions.get(part)
        if not isinstance(number, int) or number < 1:
            raise ValueError(f'{part}: no count of instructions is recorded; record one with --record')
        return number


def read(path):
    """Reads a record. @throws ValueError, which names the path, if the file is not a record."""
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
    return key if re.fullmatch(r'[\w-]+', key, re.ASCII) else _word(key)  # TOML requires quotes around "libstdc++"


def _word(value):
    return json.dumps(value, ensure_ascii=False)  # TOML and JSON have the same strings and numbers
