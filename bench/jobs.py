# SPDX-License-Identifier: Apache-2.0
"""`poinsot bench`: the jobs that a change is measured by."""
from job import Job, run_all
from standard import HERE
from table import mebibytes, milliseconds, seconds, table

# Of the gallery the scene whose frames take longest to draw: 70 ms of CPU at 1080p, where the median is 30, the plots
# of phase_portrait take 54 to 63, the cones of cones_oblate 42 to 56, the two views of football_two_views 63.
HEAVIEST = HERE.parent / 'scenes/momentum_sphere.toml'
HEAVIEST_FROM = 60  # frame: the title stands, the first seconds are over

ROWS = 1_000_000

CHECKED = HERE.parent / 'scenes/tennis_racket.toml'
# What answers before one has noticed, for a command line is typed again and again; and what CI does of each golden.
AIMS_S = {'S': 0.020, 'S check': 0.050, 'S diff': 1.0}
STARTS = 20  # in each run: one takes milliseconds


def measured(options, program, folder):
    """Tables and results.
    @throws ValueError if `--jobs` names one that there is not.
    """
    jobs = all_jobs(program, folder, options.quick)
    if options.jobs:
        jobs = chosen(jobs, options.jobs.split(','))
    results = run_all(jobs, options.runs, warm_up=not options.quick)
    return tables(results), results


def all_jobs(program, folder, quick):
    """@param folder  of two pictures to compare
    @param quick   two frames of each, to see that they work.
    """
    def frames(usual):
        return 2 if quick else usual
    return [
        Job('J1', 'film, 1080p', frames(300), program.film()),
        Job('J2', 'PNG, 1080p', frames(60), program.pictures()),
        Job('J3', 'still, shaders cached', 1, program.still()),
        Job('J3 cold', 'still, no cache', 1, program.still(), {'XDG_CACHE_HOME': '{folder}/cache'}, warmed=False),
        Job('J4', f'film of {HEAVIEST.stem}', frames(60), program.excerpt(HEAVIEST, HEAVIEST_FROM)),
        Job('J5', 'film, 4K', frames(60), program.film('--size', '3840x2160')),
        Job('T', 'trajectory to CSV', 1000 if quick else ROWS, program.trajectory()),
        Job('S', 'poinsot --help', 1, program.help(), repeats=1 if quick else STARTS),
        Job('S check', f'poinsot check {CHECKED.name}', 1, program.check(CHECKED), repeats=1 if quick else STARTS),
        Job('S diff', 'poinsot diff, 1080p', 1, program.diff(folder), repeats=1 if quick else STARTS,
            given=program.pictures(folder)(2)),
    ]


def chosen(jobs, names):
    """Those of the names; J3 and S stand for all of their kinds.
    @throws ValueError for a name that is none's.
    """
    known = {job.name.split()[0] for job in jobs}
    for name in names:
        if name not in known:
            raise ValueError(f'there is no job {name!r}, only {", ".join(sorted(known))}')
    return [job for job in jobs if job.name.split()[0] in names]


def tables(results):
    starts = [result for result in results if result.job.name in AIMS_S]
    films = [result for result in results if result.job.name != 'T' and result not in starts]
    rows = [result for result in results if result.job.name == 'T']
    texts = []
    if films:
        texts += [costs(films), split(films)]
    if rows:
        texts += [row_costs(rows)]
    if starts:
        texts += [start_costs(starts)]
    return texts


def costs(results):
    return table(['job', 'frames', 'wall', 'frames/s', 'CPU per frame', 'peak memory'],
                 [[f'{result.job.name}: {result.job.what}', str(result.job.frames), seconds(result.wall_s),
                   f'{result.rate_hz:.1f}', milliseconds(result.cpu_per_frame_s), mebibytes(result.memory_mib)]
                  for result in results])


def split(results):
    """A worker's first frame and its start stand apart: they do not grow with the film."""
    def lines(kind, unit):
        # Every job's steps, in the order of the first that has them.
        steps = dict.fromkeys(step for result in results for step in getattr(result.split, kind))
        return [[f'{step}, per {unit}'] + [_cell(getattr(result.split, kind), step) for result in results]
                for step in steps]
    return table(['CPU in ms'] + [result.job.name for result in results],
                 lines('per_frame_ms', 'frame') + lines('per_worker_ms', 'worker'))


def row_costs(results):
    return table(['job', 'rows', 'wall', 'rows/s', 'CPU per row', 'peak memory'],
                 [[f'{result.job.name}: {result.job.what}', str(result.job.frames), seconds(result.wall_s),
                   f'{result.rate_hz:.0f}', f'{result.cpu_per_frame_s * 1e6:.2f} µs', mebibytes(result.memory_mib)]
                  for result in results])


def start_costs(results):
    return table(['job', 'in each run', 'wall', 'at most', 'CPU', 'peak memory'],
                 [[f'{result.job.name}: {result.job.what}', str(result.job.repeats), milliseconds(result.wall_s),
                   milliseconds(AIMS_S[result.job.name]), milliseconds(result.cpu_s), mebibytes(result.memory_mib)]
                  for result in results])


def _cell(steps, step):
    return f'{steps[step]:.2f}' if step in steps else ''
