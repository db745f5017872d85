# SPDX-License-Identifier: Apache-2.0
"""Measures one command: wall time, CPU time and memory of all its descendants."""
import contextlib
import ctypes
import dataclasses
import os
import pathlib
import re
import select
import signal
import subprocess
import tempfile
import time

PR_SET_CHILD_SUBREAPER = 36  # <linux/prctl.h>
SAMPLING_S = 0.5  # between two samples of memory; a sample takes milliseconds of CPU
LAST_ONES_S = 5  # longest wait for orphans, such as a terminated X server


class Failure(Exception):
    """A command failed. The text has the command and the end of its error output."""


@dataclasses.dataclass(frozen=True)
class Measurement:
    wall_s: float
    cpu_s: float  # user and system, of all descendants
    memory_mib: float  # peak sum of all descendants; peak of the largest if all end within SAMPLING_S
    foreign_s: float  # CPU time of all other processes of the machine during the run
    stderr: str


def measure(command, environment=None):
    """Runs `command` in an empty folder of its own, which is removed afterwards.
    In values of `environment`, {folder} stands for the path of that folder.
    @throws Failure unless it ends with status 0.
    """
    adopt_orphans()
    with tempfile.TemporaryDirectory(prefix='poinsot-bench-') as folder:
        changes = {name: value.format(folder=folder) for name, value in (environment or {}).items()}
        return _measured([str(word) for word in command], folder, os.environ | {'TMPDIR': folder} | changes)


def adopt_orphans():
    """Makes descendants whose parent has ended children of this process, so that their CPU time is counted."""
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1)


def _measured(command, folder, environment):
    with tempfile.TemporaryFile() as stderr:
        busy_before, started = _busy_s(), time.monotonic()
        try:
            # In a new session, one signal ends the command and all processes that it started.
            child = subprocess.Popen(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                     stdout=subprocess.DEVNULL, stderr=stderr, start_new_session=True)
        except OSError as error:
            raise Failure(f'{command[0]}: {error.strerror}') from error
        try:
            sampled_kib = _peak_until_end(child.pid)
            wall_s = time.monotonic() - started
            status, usages = _reaped(child)
        except BaseException:
            with contextlib.suppress(ProcessLookupError):  # all processes have ended
                os.killpg(child.pid, signal.SIGKILL)
            child.wait()
            raise
        busy_s = _busy_s() - busy_before
        stderr.seek(0)
        said = stderr.read().decode(errors='replace')
    if status != 0:
        raise Failure(f'status {status}: {" ".join(command)}\n' + '\n'.join(said.splitlines()[-10:]))
    cpu_s = sum(usage.ru_utime + usage.ru_stime for usage in usages)
    largest_kib = max(usage.ru_maxrss for usage in usages)
    return Measurement(wall_s, cpu_s, max(sampled_kib, largest_kib) / 1024, max(0.0, busy_s - cpu_s), said)


def _peak_until_end(pid):
    end, peak_kib = os.pidfd_open(pid), 0
    try:
        while not select.select([end], [], [], SAMPLING_S)[0]:
            peak_kib = max(peak_kib, sum(map(_memory_kib, _descendants())))
    finally:
        os.close(end)
    return peak_kib


def _reaped(child):
    """Returns the child's exit status, and the resource usage of the child and all adopted descendants."""
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode, usages = os.waitstatus_to_exitcode(status), [usage]
    deadline = time.monotonic() + LAST_ONES_S
    while True:
        try:
            pid, _, usage = os.wait4(-1, os.WNOHANG)
        except ChildProcessError:
            return child.returncode, usages
        if pid:
            usages.append(usage)
        elif time.monotonic() > deadline:
            raise Failure(f'{child.args[0]} has left processes behind')
        else:
            time.sleep(0.01)


def _descendants():
    children = {}
    for pid in filter(str.isdigit, os.listdir('/proc')):
        try:
            parent = pathlib.Path(f'/proc/{pid}/stat').read_text().rsplit(')', 1)[1].split()[1]
        except OSError:  # the process has just ended
            continue
        children.setdefault(int(parent), []).append(int(pid))
    found = list(children.get(os.getpid(), []))
    for pid in found:
        found += children.get(pid, [])
    return found


def _memory_kib(pid):
    """Returns the proportional set size, so that shared memory counts once in a sum over processes."""
    try:
        rollup = pathlib.Path(f'/proc/{pid}/smaps_rollup').read_text()
    except OSError:
        return 0
    match = re.search(r'^Pss:\s+(\d+)', rollup, re.MULTILINE)
    return int(match[1]) if match else 0


def _busy_s():
    """Returns the CPU time of the machine: user, nice, system, interrupts (proc(5)), without idle and stolen time."""
    user, nice, system, _, _, irq, softirq = map(int, pathlib.Path('/proc/stat').read_text().split()[1:8])
    return (user + nice + system + irq + softirq) / os.sysconf('SC_CLK_TCK')
