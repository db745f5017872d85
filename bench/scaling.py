# SPDX-License-Identifier: Apache-2.0
"""`poinsot bench --scaling`: measures the cost of more workers, more frames and more pixels."""
from job import Job, run_all
from machine import cores
from split import DRAWING
from table import mebibytes, milliseconds, ratio, seconds, table

SIZES = {'720p': (1280, 720), '1080p': (1920, 1080), '1440p': (2560, 1440), '4K': (3840, 2160)}


def measured(options, program, _):
    """Returns tables and results."""
    parts = [(by_workers, worker_jobs), (by_length, length_jobs), (by_size, size_jobs)]
    results = [run_all(jobs(program, options), options.runs, warm_up=not options.quick) for _, jobs in parts]
    return [tell(part) for (tell, _), part in zip(parts, results)], sum(results, [])


def worker_jobs(program, options):
    # At least two segments of 30 frames for each worker; with fewer, workers would wait for the last segment.
    frames = 2 if options.quick else max(300, 60 * cores())
    return [Job(f'workers {count}', str(count), frames, program.film('--jobs', count)) for count in worker_counts()]


def worker_counts():
    """Returns 1, 2, 4, ... and the number of cores."""
    powers = [1 << power for power in range(cores().bit_length())]
    return sorted({*powers, cores()})


def length_jobs(program, options):
    lengths = [1, 2] if options.quick else [100, 1000] + [10000] * options.long
    return [Job(f'frames {frames}', str(frames), frames, program.film()) for frames in lengths]


def size_jobs(program, options):
    # With one worker, the cost is that of the pixels and of a single start.
    return [Job(f'size {name}', name, 2 if options.quick else 60,
                program.film('--size', f'{width}x{height}', '--jobs', 1)) for name, (width, height) in SIZES.items()]


def by_workers(results):
    alone_hz = results[0].rate_hz
    return table(['workers', 'wall', 'frames/s', 'efficiency', 'CPU per frame', 'peak memory'],
                 [[result.job.what, seconds(result.wall_s), f'{result.rate_hz:.1f}',
                   ratio(result.rate_hz / alone_hz / int(result.job.what)), milliseconds(result.cpu_per_frame_s),
                   mebibytes(result.memory_mib)] for result in results])


def by_length(results):
    return table(['frames', 'wall', 'frames/s', 'CPU per frame', 'peak memory'],
                 [[result.job.what, seconds(result.wall_s), f'{result.rate_hz:.1f}',
                   milliseconds(result.cpu_per_frame_s), mebibytes(result.memory_mib)] for result in results])


def by_size(results):
    """Returns a table without the cost of the start, which is the same for all sizes and would favour large pictures."""
    return table(['size, one worker', 'megapixels', 'CPU per frame', 'per megapixel', 'drawing, per megapixel',
                  'peak memory'], [_size_row(result) for result in results])


def _size_row(result):
    width, height = SIZES[result.job.what]
    megapixels, steps_ms = width * height / 1e6, result.split.per_frame_ms
    frame_s, drawing_s = sum(steps_ms.values()) / 1e3, sum(steps_ms[step] for step in DRAWING) / 1e3
    return [result.job.what, ratio(megapixels), milliseconds(frame_s), milliseconds(frame_s / megapixels),
            milliseconds(drawing_s / megapixels), mebibytes(result.memory_mib)]
