# SPDX-License-Identifier: Apache-2.0
"""CPU time of each step of a render, read from the output of `--stats`."""
import dataclasses
import re
import statistics

LINE = re.compile(r'^ +(?P<step>\S.*?) +(?P<ms>[\d.]+) ms CPU per (?P<unit>frame|worker)', re.MULTILINE)
SUM = 'in all'
DRAWING = ('draw', 'resolve')


@dataclasses.dataclass(frozen=True)
class Split:
    per_frame_ms: dict  # step: CPU time of a frame, without each worker's first frame
    per_worker_ms: dict  # step: CPU time of a worker's start and first frame


def split_of(stderr):
    steps = {'frame': {}, 'worker': {}}
    for line in LINE.finditer(stderr):
        if line['step'] != SUM:
            steps[line['unit']][line['step']] = float(line['ms'])
    return Split(steps['frame'], steps['worker'])


def median_split(splits):
    def medians(tables):
        return {step: statistics.median(table[step] for table in tables) for step in tables[0]}
    return Split(medians([split.per_frame_ms for split in splits]), medians([split.per_worker_ms for split in splits]))
