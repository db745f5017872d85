# SPDX-License-Identifier: Apache-2.0
"""Tests the package in the interpreter: Ctrl-C, subinterpreters, reloading, the end of the process."""

import signal
import subprocess
import sys
import textwrap
import time

import pytest

PRELUDE = """
import os, sys, threading, time, warnings
import numpy as np
import poinsot

random = np.random.default_rng(7)
BODY = {"body": {"principal_moments": [1, 2, 3]}, "motion": {"omega_body": [0.3, 2, 0.1]}}
DRIVEN = {"motion.torque.body": [0.1, 0.2, 0.3]}
FILM = {"time.duration": 100, "time.speed": 10}

warnings.filterwarnings("ignore", message=".*use of fork")  # Python 3.12 warns of every fork of threads

def ready():
    print("ready", flush=True)
"""

# Calls that would take 1 to 15 s. "motion of a thread" waits for a thread that integrates the same motion.
LONG = {
    "rows": "s = poinsot.loads(BODY); ready(); s.trajectory(np.arange(6e6))",
    "driven motion": "s = poinsot.loads(BODY, DRIVEN); ready(); s.trajectory(1000)",
    "driven motion backwards": "s = poinsot.loads(BODY, DRIVEN); ready(); s.trajectory(-1000)",
    "info": "s = poinsot.loads(BODY, DRIVEN | FILM); ready(); s.info()",
    "motion of a picture": "s = poinsot.loads(BODY, DRIVEN | FILM); ready(); s.render(0, size=(64, 64))",
    "picture": "s = poinsot.loads(BODY, limits={'memory': '8 GiB'}); ready(); s.render(0, size=(6000, 6000))",
    "motion of a thread": """
s = poinsot.loads(BODY, DRIVEN)
threading.Thread(target=s.trajectory, args=[300]).start()
time.sleep(0.05)
ready()
s.trajectory(300)
""",
    # Comparing a frame of 1600x900 that differs takes 0.4 s.
    "films": """
s = poinsot.loads(BODY, {"output.size": [1600, 900], "time.duration": 0.2})
names = [s.replace({"time.start": t}).film(f"{FOLDER}/{t}.mp4").path for t in (0, 1)]
ready()
poinsot.diff(*names)
""",
    "pictures": """
a, b = (random.integers(0, 255, (3000, 3000, 3), np.uint8) for _ in range(2))
ready()
poinsot.diff(a, b)
""",
}


def run(program, **options):
    return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, **options)


@pytest.mark.parametrize("work", LONG)
def test_ctrl_c_interrupts_within_half_a_second(work, tmp_path):
    tried = textwrap.indent(LONG[work], "    ")
    program = f"{PRELUDE}\nFOLDER = {str(tmp_path)!r}\ntry:\n{tried}\nexcept KeyboardInterrupt:\n    print('heard', flush=True)\n"
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "ready\n"
        time.sleep(0.1)
        sent = time.monotonic()
        process.send_signal(signal.SIGINT)
        assert process.stdout.readline() == "heard\n"
        assert time.monotonic() - sent < 0.5  # measured 0.05
    assert process.returncode == 0  # a picture in progress is finished first


def test_an_interrupted_motion_can_be_computed_again():
    said = run(f"""{PRELUDE}
import os, signal
s = poinsot.loads(BODY, DRIVEN)
threading.Timer(0.05, os.kill, [os.getpid(), signal.SIGINT]).start()
try:
    s.trajectory(300.0)
except KeyboardInterrupt:
    print(s.trajectory([100.0]).T == poinsot.loads(BODY, DRIVEN).trajectory([100.0]).T)
""")
    assert (said.stdout, said.stderr, said.returncode) == ("[ True]\n", "", 0)


def test_the_process_ends_while_daemon_threads_compute():
    said = run(f"""{PRELUDE}
s = poinsot.loads(BODY)
def work():
    while True:
        s.trajectory(np.arange(2e4))
for _ in range(4):
    threading.Thread(target=work, daemon=True).start()
time.sleep(0.1)
if (child := os.fork()) != 0:  # a fork has none of the threads
    assert os.waitpid(child, 0)[1] == 0
print("end")
""")
    assert (said.stdout.splitlines()[0], said.stderr, said.returncode) == ("end", "", 0)  # the process used to abort


def test_a_fork_integrates_what_a_thread_of_its_parent_was_integrating():
    said = run(f"""{PRELUDE}
s = poinsot.loads(BODY, DRIVEN)
threading.Thread(target=s.trajectory, args=[120], daemon=True).start()
time.sleep(0.1)
if (child := os.fork()) == 0:
    print(s.trajectory(100, span=(0, 120)).T == poinsot.loads(BODY, DRIVEN).trajectory(100, span=(0, 120)).T, flush=True)
    os._exit(0)
assert os.waitpid(child, 0)[1] == 0
""")
    assert (said.stdout, said.stderr, said.returncode) == ("True\n", "", 0)


def test_a_signal_handler_may_use_the_motion_that_it_interrupts():
    said = run(f"""{PRELUDE}
import signal
s, heard = poinsot.loads(BODY, DRIVEN), []
signal.signal(signal.SIGALRM, lambda *_: heard.append(s.trajectory(100, span=(0, 120)).T))
signal.setitimer(signal.ITIMER_REAL, 0.02)
own = s.trajectory(100, span=(0, 120)).T
print(heard == [own])
""")
    assert (said.stdout, said.stderr, said.returncode) == ("True\n", "", 0)


@pytest.mark.parametrize("before", ["", "import poinsot"])
def test_a_subinterpreter_gets_an_import_error(before):
    pytest.importorskip("_xxsubinterpreters")  # exists until Python 3.12
    said = run(f"""{before}
import sys, _xxsubinterpreters as interpreters
other = interpreters.create()
try:
    interpreters.run_string(other, f"import sys; sys.path[:] = {{sys.path}}; import poinsot")
except interpreters.RunFailedError as error:
    print(error)
import poinsot
print(poinsot.load("scenes/tennis_racket.toml").frame_count)
""")
    assert "ImportError" in said.stdout and "only in the main interpreter" in said.stdout, said
    assert said.stdout.endswith("\n420\n") and said.returncode == 0


def test_the_package_can_be_imported_again():
    said = run("""
import importlib, sys
import poinsot
first = poinsot.load("scenes/tennis_racket.toml")
importlib.reload(poinsot)
assert poinsot.load("scenes/tennis_racket.toml").trajectory(1).T == first.trajectory(1).T
for name in [name for name in sys.modules if name.startswith("poinsot")]:
    del sys.modules[name]
import poinsot
assert poinsot.load("scenes/tennis_racket.toml").render(1, size=(32, 32)).shape == (32, 32, 3)
try:
    poinsot.load("none.toml")
except poinsot.FileError:  # of the new modules
    print("good")
""")
    assert (said.stdout, said.stderr, said.returncode) == ("good\n", "", 0)
