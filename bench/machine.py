# SPDX-License-Identifier: Apache-2.0
"""Facts that figures depend on: machine, versions, commit and date."""
import datetime
import os
import pathlib
import re
import subprocess


def cores():
    """Returns the number of CPUs that this process may use."""
    return len(os.sched_getaffinity(0))


def occasion():
    """Returns the date and the commit of the sources."""
    return {
        'date': datetime.datetime.now(datetime.timezone.utc).strftime('%Y-%m-%d %H:%M UTC'),
        'commit': _first(r'(.+)', 'git', '-C', pathlib.Path(__file__).parent, 'describe', '--always', '--dirty'),
    }


def facts(program):
    """Returns names and values to print above the figures."""
    return occasion() | {
        'CPU': f'{_cpu_model()}, {cores()} cores',
        'poinsot': _first(r'poinsot (.+)', program, '--version'),
        'x264': _first(r'x264 (.+)', program, '--version'),
        'OpenGL': _first(r'ok +OpenGL \w+ +(.+)', program, 'doctor'),
    }


def peer_facts(python):
    return {
        'VTK': _first(r'(.+)', python, '-c', 'import vtk; print(vtk.vtkVersion().GetVTKVersion())'),
        'Matplotlib': _first(r'(.+)', python, '-c', 'import matplotlib; print(matplotlib.__version__)'),
        'ffmpeg': _first(r'ffmpeg version (\S+)', 'ffmpeg', '-version'),
    }


def _cpu_model():
    match = re.search(r'^model name\s*: (.+)', pathlib.Path('/proc/cpuinfo').read_text(), re.MULTILINE)
    return match[1] if match else os.uname().machine


def _first(pattern, *command):
    """Returns the first match of the pattern's group in the command's output, or "unknown"."""
    try:
        printed = subprocess.run(command, capture_output=True, text=True).stdout
    except OSError:
        return 'unknown'
    match = re.search(pattern, re.sub(r'\n {8,}', ' ', printed))  # doctor breaks long lines
    return match[1].strip() if match else 'unknown'
