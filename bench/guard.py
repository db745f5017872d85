# SPDX-License-Identifier: Apache-2.0
"""`poinsot bench --guard`: compares valgrind's count of instructions in the parts without OpenGL with recorded counts.

Unlike times, counts are the same in every run, even on a busy machine, so that an increase of a few per cent can fail.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import guard_record
import machine
from guard_record import Record
from measurement import Failure
from table import table

PARTS = ('motion', 'compose', 'convert', 'compare', 'png')  # as in guard_parts.cpp
CHEAPEST = PARTS[:1]
TOLERANCE = 0.05
COUNTED = 'poinsotGuardCounted'  # function in guard.cpp; instructions count from its start to its end
# Libraries whose instructions are in the counts. Debian's names of their files contain the versions.
LIBRARIES = ('libc', 'libfmt', 'libfreetype', 'libharfbuzz', 'libisal', 'libpng16', 'libstdc++', 'libz')
# Without the caller's variables, such as VALGRIND_OPTS. LD_BIND_NOW binds symbols at the start, outside the counts.
ENVIRONMENT = {'PATH': os.defpath, 'LC_ALL': 'C', 'LD_BIND_NOW': '1'}


def checked(options):
    """Returns the report, and whether no part is refused. With `--record`, writes the counts to the record.
    @throws ValueError if the record is malformed; Failure if a part cannot be counted.
    """
    recorded = None if options.record else guard_record.read(options.figures)
    counted = count_all(options.program.resolve().parent / 'poinsot_guard', CHEAPEST if options.quick else PARTS)
    facts = machine.occasion() | counted.made_with
    if options.record:
        guard_record.write(options.figures, counted)
        recorded = counted
    findings, held = judged(recorded, counted)
    lines = '\n'.join(f'- {name}: {value}' for name, value in facts.items())
    return '\n\n'.join([lines, compared(recorded, counted), *findings]), held


def count_all(program, parts):
    made_with, instructions = versions(program), {}
    for part in parts:
        instructions[part], said = count(program, part)
        made_with |= said
        print(f'poinsot bench: {part}: {grouped(instructions[part])} instructions', file=sys.stderr, flush=True)
    return Record(made_with, instructions)


def count(program, part):
    """Returns the instructions of a part, and the facts that they depend on: compiler, flags, versions of libraries."""
    with tempfile.TemporaryDirectory(prefix='poinsot-bench-') as folder:
        # Started in an empty folder, because valgrind reads options from a file in its working folder.
        said = output_of('valgrind', '-q', '--tool=callgrind', '--callgrind-out-file=counts',
                         f'--toggle-collect={COUNTED}', program, part, folder=folder)
        totals = re.search(r'^totals: (\d+)', pathlib.Path(folder, 'counts').read_text(), re.MULTILINE)
    if not totals or int(totals[1]) == 0:
        raise Failure(f'valgrind did not find {COUNTED} in {program}')
    return int(totals[1]), dict(re.findall(r'^(\S+): (.+)$', said, re.MULTILINE))


def versions(program):
    """Returns the versions of valgrind and of the libraries that the program loads."""
    loaded = re.findall(r'=> (/\S+)', output_of('ldd', program))
    names = [pathlib.Path(path).resolve().name.partition('.so') for path in loaded]
    files = {stem: stem + so + version for stem, so, version in names if stem in LIBRARIES}
    files['libc'] = os.confstr('CS_GNU_LIBC_VERSION')  # the name of its file, libc.so.6, has no version
    return {'valgrind': output_of('valgrind', '--version').strip().removeprefix('valgrind-')} | \
        {name: files.get(name, 'none') for name in LIBRARIES}


def output_of(*command, folder=None):
    command = [str(word) for word in command]
    try:
        run = subprocess.run(command, cwd=folder, env=ENVIRONMENT, stdin=subprocess.DEVNULL, capture_output=True,
                             text=True, errors='replace')
    except OSError as error:
        raise Failure(f'{command[0]}: {error.strerror}') from error
    if run.returncode != 0:
        raise Failure(f'status {run.returncode}: {" ".join(command)}\n' + '\n'.join(run.stderr.splitlines()[-10:]))
    return run.stdout


def compared(recorded, counted):
    return table(['part', 'recorded', 'counted', 'ratio'],
                 [[part, grouped(recorded.of(part)), grouped(instructions), f'{instructions / recorded.of(part):.4f}']
                  for part, instructions in counted.instructions.items()])


def judged(recorded, counted):
    """Returns messages, and whether no part is refused. If any version differs from the record, no part is refused."""
    said, held = [], True
    others = [f'{name} {counted.made_with.get(name, "none")} (recorded: {recorded.made_with.get(name, "none")})'
              for name in counted.made_with | recorded.made_with
              if counted.made_with.get(name) != recorded.made_with.get(name)]
    if others:
        said += [f'These versions differ from the recorded ones, so no part is refused: {", ".join(others)}. '
                 'Build the commit to compare with on this machine, and record its counts with --record.']
    for part, instructions in counted.instructions.items():
        change = instructions / recorded.of(part) - 1
        if change > TOLERANCE:
            said += [f'{part}: {change:.1%} more than recorded; if the increase is justified, record it with --record.']
            held = held and bool(others)
        elif change < -TOLERANCE:
            said += [f'{part}: {-change:.1%} less than recorded; to keep it so, record it with --record.']
    return said, held


def grouped(number):
    return f'{number:,}'.replace(',', ' ')
