# SPDX-License-Identifier: Apache-2.0
"""`poinsot bench`: the jobs that measure the speed of the program."""
from job import Job, run_all
from standard import HERE
from table import mebibytes, milliseconds, seconds, table

# Scene of the gallery whose frames take longest to draw: 70 ms of CPU at 1080p. The median is 30 ms; phase_portrait
# takes 54 to 63 ms, cones_oblate 42 to 56 ms, football_two_views 63 ms.
HEAVIEST = HERE.parent / 'scenes/momentum_sphere.toml'
HEAVIEST_FROM = 60  # first frame, after the opening seconds; the title is shown

ROWS = 1_000_000

CHECKED = HERE.parent / 'scenes/tennis_racket.toml'
# Aims for commands that users type again and again, and for the comparison that CI runs for each golden picture.
AIMS_S = {'S': 0.020, 'S check': 0.050, 'S diff': 1.0}
STARTS = 20  # in each run, because one start takes milliseconds


def measured(options, program, folder):
    """Returns tables and results.
    @throws ValueError if `--jobs` names an unknown job.
    """
    jobs = all_jobs(program, folder, options.quick)
    if options.jobs:
        jobs = chosen(jobs, options.jobs.split(','))
    results = run_all(jobs, options.runs, warm_up=not options.quick)
    return tables(results), results


def all_jobs(program, folder, quick):
    """@param folder  folder for the two pictures that `diff` compares
    @param quick   makes two frames in each job, only to check that it works.
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
    """Returns the named jobs; J3 and S select all their variants.
    @throws ValueError for an unknown name.
    """
    known = {job.name.split()[0] for job in jobs}
    for name in names:
        if name not in known:
            raise ValueError(f'unknown job {name!r}; known jobs: {", ".join(sorted(known))}')
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
    """Returns a table of steps. A worker's start and first frame have their own rows: they do not grow with the film."""
    def lines(kind, unit):
        # Steps of all jobs, in the order of their first occurrence.
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
