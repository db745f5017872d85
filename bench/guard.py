# SPDX-License-Identifier: Apache-2.0
"""`poinsot bench --guard`: instructions of the parts without GL, counted by valgrind, beside those recorded.

Unlike times they are the same on every run, on a busy machine too, so that a few per cent can be refused.
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

PARTS = ('motion', 'compose', 'convert', 'compare', 'png')  # of guard_parts.cpp
CHEAPEST = PARTS[:1]
TOLERANCE = 0.05
COUNTED = 'poinsotGuardCounted'  # the function in guard.cpp between whose start and end instructions count
# Those with instructions of their own in the counts; Debian names their files by their versions.
LIBRARIES = ('libc', 'libfmt', 'libfreetype', 'libharfbuzz', 'libisal', 'libpng16', 'libstdc++', 'libz')
# Nothing of the caller's, such as VALGRIND_OPTS. Symbols are bound at the start: it would count on their first calls.
ENVIRONMENT = {'PATH': os.defpath, 'LC_ALL': 'C', 'LD_BIND_NOW': '1'}


def checked(options):
    """What is to be printed, and whether it is as recorded; with `--record` writes the figures instead.
    @throws ValueError for a file of figures that is none; Failure where a part cannot be counted.
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
    """The part's instructions, and what the program says that they depend on."""
    with tempfile.TemporaryDirectory(prefix='poinsot-bench-') as folder:
        # In that folder, as valgrind reads options from a file in the one where it is started.
        said = output_of('valgrind', '-q', '--tool=callgrind', '--callgrind-out-file=counts',
                         f'--toggle-collect={COUNTED}', program, part, folder=folder)
        totals = re.search(r'^totals: (\d+)', pathlib.Path(folder, 'counts').read_text(), re.MULTILINE)
    if not totals or int(totals[1]) == 0:
        raise Failure(f'valgrind has not seen {COUNTED} of {program}')
    return int(totals[1]), dict(re.findall(r'^(\S+): (.+)$', said, re.MULTILINE))


def versions(program):
    """Of valgrind and of the files of the libraries that the program loads."""
    loaded = re.findall(r'=> (/\S+)', output_of('ldd', program))
    names = [pathlib.Path(path).resolve().name.partition('.so') for path in loaded]
    files = {stem: stem + so + version for stem, so, version in names if stem in LIBRARIES}
    files['libc'] = os.confstr('CS_GNU_LIBC_VERSION')  # its file is libc.so.6, whatever the version
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
    """What is to be said, and whether nothing is refused: figures made otherwise are no reason to refuse one."""
    said, held = [], True
    others = [f'{name} {counted.made_with.get(name, "none")} (recorded: {recorded.made_with.get(name, "none")})'
              for name in counted.made_with | recorded.made_with
              if counted.made_with.get(name) != recorded.made_with.get(name)]
    if others:
        said += [f'Not what the figures were recorded with, so that nothing is refused: {", ".join(others)}. '
                 'Build the commit that is to be compared with here, and record its figures with --record.']
    for part, instructions in counted.instructions.items():
        change = instructions / recorded.of(part) - 1
        if change > TOLERANCE:
            said += [f'{part}: {change:.1%} more than recorded; if that is its price, record it with --record.']
            held = held and bool(others)
        elif change < -TOLERANCE:
            said += [f'{part}: {-change:.1%} less than recorded; so that it stays so, record it with --record.']
    return said, held


def grouped(number):
    return f'{number:,}'.replace(',', ' ')
