# SPDX-License-Identifier: Apache-2.0
"""A job is a command that makes a number of frames; its result is the median of several runs."""
import dataclasses
import statistics
import sys
import typing

from measurement import measure
from split import Split, median_split, split_of

# Wall time from which a run is checked for other processes; the kernel counts CPU time in hundredths of a second.
COUNTED_FROM_S = 0.1


@dataclasses.dataclass(frozen=True)
class Job:
    name: str
    what: str
    frames: int  # or rows, if the job makes a table
    command: typing.Callable  # takes the number of frames, returns a list of words
    environment: dict = dataclasses.field(default_factory=dict)
    warmed: bool = True  # makes one frame before the measured runs, to fill caches of shaders and files
    repeats: int = 1  # repetitions in each run, for a command that takes milliseconds
    given: list | None = None  # command that makes the job's inputs; runs once and is not measured


@dataclasses.dataclass(frozen=True)
class Result:
    job: Job
    wall_s: float
    cpu_s: float
    memory_mib: float
    foreign_share: float  # share of one core that other processes used, in the worst run
    split: Split

    @property
    def rate_hz(self):
        return self.job.frames / self.wall_s

    @property
    def cpu_per_frame_s(self):
        return self.cpu_s / self.job.frames


def run_all(jobs, runs, warm_up=True):
    """Runs the jobs and returns their results. Each round runs every job once, so that a slow minute affects them all."""
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
