# SPDX-License-Identifier: Apache-2.0
"""A job is a command that makes a number of frames; its result is the median of several runs."""
import dataclasses
import statistics
import sys
import typing

from measurement import measure
from split import Split, median_split, split_of

# The kernel counts CPU time in hundredths of a second: what others took of a shorter run is not known.
COUNTED_FROM_S = 0.1


@dataclasses.dataclass(frozen=True)
class Job:
    name: str
    what: str
    frames: int  # or rows, of a table
    command: typing.Callable  # of the number of frames: a list of words
    environment: dict = dataclasses.field(default_factory=dict)
    warmed: bool = True  # one frame is made beforehand, not counted: shaders and files are then cached
    repeats: int = 1  # in a row, in each run: of a command that ends at once
    given: list | None = None  # a command that makes what the job works on; run once, not counted


@dataclasses.dataclass(frozen=True)
class Result:
    job: Job
    wall_s: float
    cpu_s: float
    memory_mib: float
    foreign_share: float  # of one core, used by others meanwhile, in the worst run
    split: Split

    @property
    def rate_hz(self):
        return self.job.frames / self.wall_s

    @property
    def cpu_per_frame_s(self):
        return self.cpu_s / self.job.frames


def run_all(jobs, runs, warm_up=True):
    """The jobs' results. All jobs run once, then all again, so that a slow minute does not fall on one of them."""
    for job in jobs:
        if job.given:
            measure(job.given)
        if warm_up and job.warmed:
            _say(f'warming up {job.name}')
            measure(job.command(1), job.environment)
    measured = [[] for _ in jobs]
    for run in range(runs):
        for job, measurements in zip(jobs, measured):
            measurements += [measure(job.command(job.frames), job.environment) for _ in range(job.repeats)]
            _say(f'{job.name}, run {run + 1} of {runs}: {measurements[-1].wall_s:.2f} s')
    return [_result(job, measurements) for job, measurements in zip(jobs, measured)]


def _result(job, measurements):
    def median(name):
        return statistics.median(getattr(measurement, name) for measurement in measurements)
    return Result(job, median('wall_s'), median('cpu_s'), median('memory_mib'),
                  max((measurement.foreign_s / measurement.wall_s for measurement in measurements
                       if measurement.wall_s >= COUNTED_FROM_S), default=0),
                  median_split([split_of(measurement.stderr) for measurement in measurements]))


def _say(text):
    print(f'poinsot bench: {text}', file=sys.stderr, flush=True)
