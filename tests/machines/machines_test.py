# SPDX-License-Identifier: Apache-2.0
"""Tests how the trial reads other programs' output, how it judges figures, and that a room leaves nothing behind.

    machines_test.py TESTS_MACHINES
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

MACHINES = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(MACHINES))
import readings  # noqa: E402
import report  # noqa: E402
import room  # noqa: E402

# Summary as CTest 3.25 prints it. CTest 4.3 appends labels, as in the second line of the failed tests.
SUMMARY = """\
2/8 Test #2: B.Fails ..........................***Failed    0.01 sec
43% tests passed, 4 tests failed out of 7

Total Test time (real) =   1.03 sec

The following tests did not run:
\t  3 - BackEnds/C.Skips/OsMesa (Skipped)
\t  4 - D.Code (Skipped)
\t  6 - F.Disabled (Disabled)

The following tests FAILED:
\t  2 - B.Fails (Failed)
\t  5 - E.NotThere (Not Run)                 gl slow
\t  7 - G.Crash (SEGFAULT)
\t  8 - H.Slow (Timeout)
"""
LOG = """\
Start testing: Nov 26 12:05 UTC
----------------------------------------------------------
3/8 Testing: BackEnds/C.Skips/OsMesa
3/8 Test: BackEnds/C.Skips/OsMesa
Command: "/x/gl_test" "--gtest_filter=BackEnds/C.Skips/OsMesa"
Directory: /x
"BackEnds/C.Skips/OsMesa" start time: Nov 26 12:05 UTC
Output:
----------------------------------------------------------
[ RUN      ] BackEnds/C.Skips/OsMesa
/x/y.cpp:87: Skipped
this Mesa
has no OSMesa

[  SKIPPED ] BackEnds/C.Skips/OsMesa (0 ms)
<end of output>
Test time =   0.01 sec
----------------------------------------------------------
Test Pass Reason:
Skip regular expression found in output. Regex=[\\[  SKIPPED \\]]
----------------------------------------------------------

4/8 Testing: D.Code
4/8 Test: D.Code
Command: "/usr/bin/sh"
Directory: /x
"D.Code" start time: Nov 26 12:05 UTC
Output:
----------------------------------------------------------
a warning of before
the programs are not there: ./poinsot fuzz builds them
<end of output>
Test time =   0.00 sec
"""


def good():
    """Returns figures that break no promise."""
    commands = {name: {"status": 0, "seconds": 20.0} for name in ("render", "test", "package", "update", "download", "install", "film")}
    commands["render"]["apt_seconds"] = 7.0
    return {"date": "2026-11-26", "compiler": "gcc", "versions": {"GCC": "14.2.0"}, "commands": commands, "warnings": [],
            "tests": {"passed": 2105, "failed": {}, "skipped": {"no LaTeX": ["A.B"], "no mounts": ["C.D", "E.F"]}},
            "pictures": {"identical": 70, "near": 2}, "film": dict(report.FILM), "installed_film": dict(report.FILM),
            "packages": {"poinsot_0.1.0_amd64.deb": 1500000}, "download_bytes": 98765432, "installed_bytes": 400000000}


class Readings(unittest.TestCase):
    def test_counts_tests_as_passed_only_if_they_ran(self):
        summary = readings.ctest_summary(SUMMARY)
        self.assertEqual(summary["passed"], 1)  # 7 tests, of which 4 failed and 2 were skipped
        self.assertEqual(summary["failed"],
                         {"B.Fails": "Failed", "E.NotThere": "Not Run", "G.Crash": "SEGFAULT", "H.Slow": "Timeout"})
        self.assertEqual(list(summary["not_run"]), ["BackEnds/C.Skips/OsMesa", "D.Code", "F.Disabled"])
        self.assertIsNone(readings.ctest_summary("poinsot: the build failed"))
        self.assertEqual(readings.ctest_summary("100% tests passed, 0 tests failed out of 12\n"),
                         {"passed": 12, "failed": {}, "not_run": {}})

    def test_finds_the_reason_of_each_skip(self):
        not_run = readings.ctest_summary(SUMMARY)["not_run"] | {"Gone.FromTheLog": "Skipped"}
        self.assertEqual(readings.skips(not_run, LOG), {
            "this Mesa has no OSMesa": ["BackEnds/C.Skips/OsMesa"],
            "the programs are not there: ./poinsot fuzz builds them": ["D.Code"],
            "disabled": ["F.Disabled"],
            readings.NO_REASON: ["Gone.FromTheLog"]})

    def test_reads_the_output_of_this_machines_ctest(self):
        with tempfile.TemporaryDirectory() as folder:
            skip = 'printf "[ RUN      ] A.B\\\\n/x/y.cpp:3: Skipped\\\\nno disk\\\\n\\\\n[  SKIPPED ] A.B (0 ms)\\\\n"'
            pathlib.Path(folder, "CTestTestfile.cmake").write_text(
                f'add_test(A.B sh -c [==[{skip}]==])\n'
                'set_tests_properties(A.B PROPERTIES SKIP_REGULAR_EXPRESSION [==[\\[  SKIPPED \\]]==])\n'
                'add_test(C.D false)\nset_tests_properties(C.D PROPERTIES LABELS "gl;slow")\nadd_test(E.F true)\n')
            run = subprocess.run(["ctest"], cwd=folder, capture_output=True, text=True)
            summary = readings.ctest_summary(run.stdout)
            self.assertEqual(summary, {"passed": 1, "failed": {"C.D": "Failed"}, "not_run": {"A.B": "Skipped"}})
            log = pathlib.Path(folder, "Testing/Temporary/LastTest.log").read_text()
            self.assertEqual(readings.skips(summary["not_run"], log), {"no disk": ["A.B"]})

    def test_counts_a_warning_once(self):
        log = "/x/a.h:3:5: warning: unused [-Wunused]\n[2/9] Building warning.cpp.o\n/x/a.h:3:5: warning: unused [-Wunused]\n"
        self.assertEqual(readings.warnings(log + "cc1plus: warning: x.gch: not used\n"),
                         ["/x/a.h:3:5: warning: unused [-Wunused]", "cc1plus: warning: x.gch: not used"])

    def test_takes_upstream_versions_of_installed_packages(self):
        dpkg = ("g++ installed 4:14.2.0-1\nlibavcodec-dev:amd64 installed 7:5.1.6-0+deb12u1\nclang installed 1:14.0-55.7~deb12u1\n"
                "python3 installed 3.11.2-1+b1\nlibeigen3-dev installed 3.4.0+dfsg-1\ncmake config-files 3.25.1-1\n")
        self.assertEqual(readings.versions(dpkg),
                         {"GCC": "14.2.0", "Clang": "14.0", "FFmpeg": "5.1.6", "Eigen": "3.4.0", "Python": "3.11.2"})

    def test_takes_a_films_facts_from_ffprobe(self):
        stream = {"codec_name": "h264", "width": 1920, "height": 1080, "avg_frame_rate": "30/1", "nb_read_packets": "420", "profile": "High"}
        self.assertEqual(readings.film(json.dumps({"streams": [stream]})), report.FILM)
        for text in ("", "{}", '{"streams": []}'):
            self.assertIsNone(readings.film(text))

    def test_counts_verdicts(self):
        pictures = [{"verdict": "identical"}, {"verdict": "near"}, {"verdict": "identical"}]
        self.assertEqual(readings.verdicts(json.dumps({"pictures": pictures})), {"identical": 2, "near": 1})
        self.assertEqual(readings.verdicts("no suite"), {})

    def test_takes_the_time_of_apt_from_the_launchers_notes(self):
        lines = ["Get:1 x", "poinsot: installing g++", "Setting up g++", "poinsot: building (log: build/compile.log)", "done"]
        outcome = room.Outcome(0, 100.0, lines, [1.0, 5.0, 30.0, 45.5, 99.0])
        self.assertEqual(readings.apt_seconds(outcome), 40.5)
        self.assertEqual(readings.apt_seconds(room.Outcome(0, 9.0, lines[:1], [1.0])), 0)
        self.assertEqual(readings.apt_seconds(room.Outcome(3, 60.0, lines[:3], [1.0, 5.0, 30.0])), 55.0)  # ended during apt


class Report(unittest.TestCase):
    def test_good_figures_have_no_problems(self):
        self.assertEqual(report.problems(good()), [])
        only = {"commands": {"render": {"status": 0, "seconds": 9.0}}, "film": dict(report.FILM)}
        self.assertEqual(report.problems(only), [])  # a part that was not requested is not a problem

    def test_each_broken_promise_has_a_sentence(self):
        def change(figures, path, value):
            for key in path[:-1]:
                figures = figures[key]
            figures[path[-1]] = value

        cases = {
            ("commands", "render", "status"): (3, "render: exit 3"),
            ("film",): (None, "render: the film is absent and not h264 1920x1080, 30/1 fps, 420 frames"),
            ("installed_film", "frames"): (419, "film: the film is h264 1920x1080, 30/1 fps, 419 frames and not "
                                                "h264 1920x1080, 30/1 fps, 420 frames"),
            ("tests", "failed"): ({"A.B": "Timeout"}, "test: A.B: Timeout"),
            ("tests", "passed"): (0, "test: no test passed"),
            ("tests", "skipped"): ({"x": ["A"] * 20, "y": ["B"] * 6}, "test: 26 tests were skipped, more than 25"),
            ("pictures",): ({"identical": 71, "different": 1}, "pictures: 1 different"),
            ("commands", "film", "seconds"): (41.0, "package: 61 s from the download to a film, more than 60"),
            ("warnings",): (["a.h:1: warning: x"], "warnings of gcc: 1, the first: a.h:1: warning: x"),
            ("failure",): ("debootstrap could not make trixie", "debootstrap could not make trixie"),
        }
        for path, (value, sentence) in cases.items():
            with self.subTest(path=path):
                figures = good()
                change(figures, path, value)
                self.assertEqual(report.problems(figures), [sentence])
        for key, sentence in {"tests": "test: CTest did not print its summary", "pictures": "pictures: 0 not compared"}.items():
            figures = good()
            del figures[key]
            self.assertEqual(report.problems(figures), [sentence])

    def test_twenty_five_skips_are_not_too_many(self):
        figures = good()
        figures["tests"]["skipped"] = {"x": ["A"] * 25}
        self.assertEqual(report.problems(figures), [])

    def test_the_table_has_a_column_for_each_suite(self):
        failed = {"date": "2026-11-27", "compiler": "gcc", "versions": {}, "commands": {}, "failure": "no mirror"}
        lines = report.markdown({"trixie": good(), "sid": failed}).splitlines()
        for row in ("|  | trixie | sid |", "| --- | --- | --- |", "| date | 2026-11-26 | 2026-11-27 |", "| GCC | 14.2.0 |  |",
                    "| render | exit 0, 20.0 s (apt 7 s) |  |", "| tests passed | 2105 |  |", "| tests skipped | 3 |  |",
                    "| pictures compared | 70 identical, 2 near |  |", "| downloaded | 98.8 MB |  |",
                    "| from the download to a film | 40.0 s |  |", "- no mounts: C.D, E.F", "**sid, broken (reported only)**", "- no mirror"):
            self.assertIn(row, lines)
        self.assertNotIn("**trixie, broken**", lines)


class Command(unittest.TestCase):
    def run_(self, *words, before=()):
        return subprocess.run([*before, sys.executable, "-B", MACHINES, *words], capture_output=True, text=True)

    def test_rejects_invalid_arguments(self):
        for words in (["../etc"], ["Trixie"], ["--only", "dance"], ["--clang", "--only", "test"]):
            self.assertEqual(self.run_(*words).returncode, 2, words)

    def test_reports_that_it_needs_root(self):
        before = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"] if os.geteuid() == 0 else []
        if subprocess.run([*before, "test", "-r", MACHINES / "room.py"]).returncode != 0:
            self.skipTest("nobody may read the sources where they are")
        run = self.run_("trixie", before=before)
        self.assertEqual((run.returncode, run.stderr),
                         (3, "tests/machines needs root, for chroot and mounts: start it with sudo\n"))


class MountsBelow(unittest.TestCase):
    def test_lists_the_innermost_first(self):
        rows = ["proc /proc proc rw 0 0", r"proc /a\040b/room/proc proc rw 0 0", r"none /a\040b/room/proc/sys x rw 0 0",
                r"proc /a\040b/room2/proc proc rw 0 0"]
        with tempfile.NamedTemporaryFile("w") as table:
            table.write("\n".join(rows) + "\n")
            table.flush()
            self.assertEqual(room.mounts_below("/a b/room", table.name), ["/a b/room/proc/sys", "/a b/room/proc"])


class Rooms(unittest.TestCase):
    """Tests a room that shows this machine's own system through links in an empty folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "base").mkdir()
        for name in ("proc", "sys", "dev", "etc", "home", "usr"):
            (self.folder / "base" / name).mkdir()
        for name in ("bin", "lib", "lib64", "sbin"):
            (self.folder / "base" / name).symlink_to(f"usr/{name}")
        if subprocess.run(["unshare", "--mount", "--pid", "--fork", "mount", "-t", "tmpfs", "tmpfs", self.folder / "base/proc"],
                          capture_output=True).returncode != 0:
            self.skipTest("mounting needs root and a kernel that lets it")
        self.room = room.Room(self.folder, "room", debs=False)
        # enter.sh mounts in its own namespace. Another namespace around it adds /usr to the room.
        script = f'mount --make-rprivate /; mount --bind /usr {self.room.path}/usr; exec "$@"'
        self.start = ["setpriv", "--pdeathsig", "KILL", "unshare", "--mount", "bash", "-c", script, "bash", MACHINES / "enter.sh", self.room.path]

    def mounted(self):
        return str(self.folder) in pathlib.Path("/proc/mounts").read_text()

    def test_a_command_gets_an_empty_home_and_a_clean_environment(self):
        run = subprocess.run([*self.start, "sh", "-c", 'ls -A $HOME; pwd; env | cut -d= -f1 | sort | xargs; echo $$; exit 7'],
                             capture_output=True, text=True, env=os.environ | {"POINSOT_SECRET": "x"})
        self.assertEqual(run.returncode, 7, run.stderr)
        home, names, number = run.stdout.splitlines()
        self.assertEqual((home, names.replace("OLDPWD ", "")), ("/home/trial", "HOME LANG PATH PWD TERM"))
        self.assertLess(int(number), 20)  # a room has its own process numbers
        self.assertFalse(self.mounted())

    def test_no_process_and_no_mount_stays_after_a_kill(self):
        mark = f"{time.time_ns()}"
        process = subprocess.Popen([*self.start, "sh", "-c", f"echo begun; sleep 600.{mark} & exec sleep 601.{mark}"],
                                   stdout=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "begun\n")
        process.kill()
        process.communicate()  # returns when no process holds the pipe open
        running = [path for path in pathlib.Path("/proc").glob("[0-9]*/cmdline") if mark in words_of(path)]
        self.assertEqual(running, [])
        self.assertFalse(self.mounted())
        room.remove(self.room.path)
        self.assertFalse(self.room.path.exists())
        self.assertTrue(pathlib.Path("/usr/bin/env").exists())


def words_of(path):
    try:
        return path.read_text()
    except OSError:  # the process has ended
        return ""


if __name__ == "__main__":
    unittest.main()
