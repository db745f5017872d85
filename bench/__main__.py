# SPDX-License-Identifier: Apache-2.0
"""`./poinsot bench`: measures the program. README.md of this folder explains how."""
import argparse
import os
import pathlib
import signal
import sys
import tempfile

import guard
import jobs
import machine
import peers
import scaling
from measurement import Failure
from standard import HERE, Program

# Share of a core that other processes may use during a reliable run. The kernel's writing to disk takes up to 0.06.
DISTURBED = 0.1


def main():
    options = parsed()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))  # removes temporary files
    try:
        text, held = guard.checked(options) if options.guard else (report(options), True)
        if options.markdown:
            options.markdown.write_text(text + '\n')
    except ValueError as error:
        fail(error, 2)
    except Failure as error:
        fail(error, 3)
    except OSError as error:
        fail(error, 4)
    print(text)
    sys.exit(0 if held else 1)


def parsed():
    parser = argparse.ArgumentParser(prog='poinsot bench', allow_abbrev=False, description='measure the program',
                                     epilog='poinsot bench --micro [options] runs the small benchmarks instead.')
    parser.add_argument('--program', type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    modes = parser.add_mutually_exclusive_group()
    modes.add_argument('--jobs', metavar='J1,J2,...', help='only these jobs, of J1 to J5, T and S (default: all)')
    modes.add_argument('--peers', dest='mode', action='store_const', const=peers.measured, default=jobs.measured,
                       help='instead of the jobs: VTK, Matplotlib and the encoder alone, in turn with this program')
    modes.add_argument('--scaling', dest='mode', action='store_const', const=scaling.measured,
                       help='instead of the jobs: cost by number of workers, frames and pixels')
    modes.add_argument('--guard', action='store_true', help='instead of the jobs: count the instructions of the parts '
                       f'without OpenGL; exit status 1 if a part takes {guard.TOLERANCE:.0%}% more than recorded')
    parser.add_argument('--record', action='store_true', help='with --guard: record the counts')
    parser.add_argument('--figures', type=pathlib.Path, metavar='FILE', help='with --guard: file of the recorded '
                        'counts (default: bench/guard.toml)')
    parser.add_argument('--long', action='store_true', help='with --scaling: add a film of 10 000 frames')
    parser.add_argument('--runs', type=int, metavar='N', help='runs of each job; medians are reported (default: 3)')
    parser.add_argument('--quick', action='store_true', help='two frames, one run, no warming up (--guard: one part), '
                        'to check that it works')
    parser.add_argument('--markdown', type=pathlib.Path, metavar='FILE', help='also write the tables to a file')
    options = parser.parse_args()
    if options.guard:
        return for_guard(parser, options)
    if options.record or options.figures:
        parser.error('--record and --figures need --guard')
    if options.runs is None:
        options.runs = 1 if options.quick else 3
    if options.runs < 1:
        parser.error('--runs must be at least 1')
    if options.long and options.mode is not scaling.measured:
        parser.error('--long needs --scaling')
    return options


def for_guard(parser, options):
    if options.runs is not None or options.long:
        parser.error('--guard takes no --runs or --long: every run counts the same')
    if options.record and options.quick:
        parser.error('--quick counts one part, --record needs all parts')
    options.figures = options.figures or HERE / 'guard.toml'
    return options


def report(options):
    with tempfile.TemporaryDirectory(prefix='poinsot-bench-') as folder:
        if not options.quick:  # an empty cache, so that figures do not depend on earlier runs
            os.environ['XDG_CACHE_HOME'] = f'{folder}/cache'
        facts = machine.facts(options.program) | {'runs': f'{options.runs}; medians'}
        if options.mode is peers.measured:
            facts |= machine.peer_facts(peers.PYTHON)
        tables, results = options.mode(options, Program(options.program.resolve()), pathlib.Path(folder))
    return '\n\n'.join(['\n'.join(f'- {name}: {value}' for name, value in facts.items()), *tables,
                        *disturbance(results)])


def disturbance(results):
    worst = max(result.foreign_share for result in results)
    if worst < DISTURBED:
        return []
    return [f'Other processes took up to {worst:.0%} of a core during the runs: measure again on a quiet machine.']


def fail(error, status):
    print(f'poinsot bench: error: {error}', file=sys.stderr)
    sys.exit(status)


if __name__ == '__main__':
    main()
