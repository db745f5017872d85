# SPDX-License-Identifier: Apache-2.0
"""Tests the launcher on faulty machines. apt, sudo, the compiler and the disk are faked, and the sources are empty.

    launcher_test.py LAUNCHER
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

LAUNCHER = pathlib.Path(sys.argv.pop(1))
NOBODY = [shutil.which("setpriv"), "--reuid=65534", "--regid=65534", "--clear-groups"] if os.geteuid() == 0 else []
REAL = ("basename bash cat date df dirname echo env find flock grep head id mkdir nproc readlink rm sed sort tail touch tr true uname "
        "xargs").split()
# Scripts of the fake programs. $MACHINE is the folder with the machine's state, in files of words.
FAKES = {
    "dpkg-query": 'shift 3; for p; do grep -qx "$p" $MACHINE/missing || echo "$p installed"; done',
    "apt-cache": 'shift 2; for p; do ! grep -qx "$p" $MACHINE/offered || echo "Package: $p"; done',
    "apt-get": 'echo "$*" >>$MACHINE/asked\n'
               'case $1 in update) exit $(cat $MACHINE/update) ;; esac\n'
               '[[ $(cat $MACHINE/install) == 0 ]] || { echo "E: Failed to fetch g++.deb" >&2; exit 100; }\n'
               ': >$MACHINE/missing',
    "sudo": '[[ ! -e $MACHINE/no-sudo ]] || exit 1; shift; exec "$@"',
    "ninja": "exit 0",
    "g++": "exit 0",
    "cmake": 'if [[ $1 != --build ]]; then while [[ $1 != -B ]]; do shift; done; : >$2/CMakeCache.txt; exit; fi\n'
             '[[ -s $MACHINE/build ]] && { cat $MACHINE/build; exit 1; }\n'
             'mkdir -p $2/bin\n'
             'head -c 2000000 /dev/zero >$2/object.o || exit\n'
             "printf '#!/bin/sh\\necho ran $*\\n' >$2/bin/poinsot; exec /bin/chmod +x $2/bin/poinsot",
}


class Machine:
    """A fake computer with the launcher. Tests change its state."""

    def __init__(self, folder):
        self.folder, self.tree = pathlib.Path(folder), pathlib.Path(folder, "tree")
        self.state, self.bin = self.folder / "state", self.folder / "bin"
        for made in (self.tree / "src", self.tree / "shaders", self.tree / "cmake", self.state, self.bin):
            made.mkdir(parents=True)
        shutil.copy(LAUNCHER, self.tree / "poinsot")
        (self.tree / "packaging").mkdir()
        shutil.copy(LAUNCHER.parent / "packaging/debian.txt", self.tree / "packaging")
        (self.tree / "CMakeLists.txt").touch()
        for tool in REAL:
            (self.bin / tool).symlink_to(shutil.which(tool))
        for name, script in FAKES.items():
            self.fake(name, script)
        for name, text in {"missing": "", "offered": "", "asked": "", "update": "0", "install": "0", "build": ""}.items():
            self.has(name, text)
        for path in [self.folder, *self.folder.rglob("*")]:
            if not path.is_symlink():
                path.chmod(0o777)

    def fake(self, name, script):
        path = self.bin / name
        path.unlink(missing_ok=True)
        path.write_text(f"#!{shutil.which('bash')}\n{script}\n")
        path.chmod(0o777)

    def has(self, name, text):
        """Writes words to a file of the machine's state, one on each line."""
        (self.state / name).write_text("".join(f"{word}\n" for word in text.split()) if name != "build" else text)

    def asked(self):
        """Returns the apt-get commands since the last call, without options."""
        lines = [[word for word in line.split() if not word.startswith("-") and "=" not in word]
                 for line in (self.state / "asked").read_text().splitlines()]
        self.has("asked", "")
        return lines

    def start(self, *words, before=(), **variables):
        environment = {"PATH": str(self.bin), "MACHINE": str(self.state), "HOME": str(self.folder)} | variables
        return subprocess.run([*before, self.tree / "poinsot", *words], cwd=self.tree, env=environment, text=True,
                              capture_output=True, stdin=subprocess.DEVNULL)


class BadMachine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.machine = Machine(folder.name)

    def refused(self, run, *said):
        """Expects exit code 3, a last message with all these words, and no program."""
        self.assertEqual((run.returncode, run.stdout), (3, ""), run.stderr)
        last = run.stderr[run.stderr.rindex("poinsot: "):]
        for words in said:
            self.assertIn(words, last)
        self.assertFalse((self.machine.tree / "build/bin/poinsot").exists())
        self.assertFalse((self.machine.tree / "build/.built-poinsot").exists())

    def works(self, **variables):
        """Expects that the next run builds, and that the run after it has nothing to do."""
        run = self.machine.start("info", **variables)
        self.assertEqual((run.returncode, run.stdout), (0, "ran info\n"), run.stderr)
        self.assertEqual(self.machine.start("info", **variables).stderr, "")
        return run

    def test_reports_a_missing_compiler_although_apt_succeeded(self):
        (self.machine.bin / "g++").unlink()
        self.machine.has("missing", "g++")
        self.refused(self.machine.start("build"), "no C++ compiler was found: install one (Debian: apt-get install g++)")
        self.assertEqual(self.machine.asked(), [["update"], ["install", "g++"]])
        self.machine.fake("clang++", "exit 0")
        self.works()

    def test_reports_that_the_compiler_in_cxx_is_missing(self):
        self.refused(self.machine.start("build", CXX="g++-99"), "no C++ compiler was found with the name in the variable CXX, g++-99: install one")
        self.works(CXX="g++ -O1")

    def test_reports_that_cmake_is_missing(self):
        (self.machine.bin / "cmake").unlink()
        self.refused(self.machine.start("build"), "cmake is missing: install it (Debian: apt-get install cmake ninja-build)")

    def test_reports_a_mirror_that_does_not_answer(self):
        for name, words in {"missing": "g++", "update": "100", "install": "100"}.items():
            self.machine.has(name, words)
        run = self.machine.start("build")
        self.refused(run, "apt-get update failed before, for the reason above: check the network, or name another mirror in /etc/apt; "
                     "then start this again.")
        self.assertIn("E: Failed to fetch g++.deb", run.stderr)  # apt's own message stays visible
        self.assertFalse((self.machine.tree / "build").exists())
        self.machine.has("install", "0")  # the existing package lists suffice
        self.works()

    def test_reports_failing_apt_although_mirrors_answer(self):
        self.machine.has("missing", "g++")
        self.machine.has("install", "100")
        self.refused(self.machine.start("build"), "apt could not install all packages, for the reason above: fix it; then")
        self.machine.has("install", "0")
        self.works()

    def test_prints_the_apt_command_without_root_and_sudo(self):
        self.machine.has("missing", "g++ cmake")
        self.machine.has("offered", "libosmesa6")
        command = "sudo apt-get update && sudo apt-get install -y --no-install-recommends g++ cmake\n"
        self.machine.has("no-sudo", "")
        self.refused(self.machine.start("build", before=NOBODY), "sudo is absent or requires a password; run:\n  " + command)
        (self.machine.bin / "sudo").unlink()
        self.refused(self.machine.start("build", before=NOBODY), command)
        self.assertEqual(self.machine.asked(), [])
        self.machine.has("missing", "")
        self.works()

    def test_builds_without_optional_packages_if_not_root(self):
        self.machine.has("missing", "libosmesa6")
        self.machine.has("offered", "libosmesa6")
        self.machine.has("no-sudo", "")
        run = self.machine.start("build", before=NOBODY)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.machine.asked(), [])

    def test_installs_optional_packages_that_apt_offers(self):
        cases = {("", ""): [], ("", "libosmesa6"): [],  # libosmesa6 is installed
                 ("libosmesa6", "libosmesa6"): [["update"], ["install", "libosmesa6"]],
                 ("libosmesa6", ""): [],
                 ("g++ libosmesa6", "libosmesa6"): [["update"], ["install", "g++", "libosmesa6"]],
                 ("g++ libosmesa6", ""): [["update"], ["install", "g++"]]}
        for (missing, offered), asked in cases.items():
            with self.subTest(missing=missing, offered=offered):
                self.machine.has("missing", missing)
                self.machine.has("offered", offered)
                shutil.rmtree(self.machine.tree / "build", ignore_errors=True)
                run = self.machine.start("build")
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertEqual(self.machine.asked(), asked)

    def test_reports_a_full_disk_and_builds_once_space_is_free(self):
        build = self.machine.tree / "build"
        build.mkdir()
        inside = ["unshare", "--map-root-user", "--mount", "bash", "-c"]
        path = {"PATH": os.environ["PATH"]}
        if subprocess.run([*inside, f"mount -t tmpfs tmpfs {build}"], env=path, capture_output=True).returncode != 0:
            self.skipTest("mounting needs root or namespaces of users")
        # The fake compiler writes more than the 1 MB that is free. Then space is freed; files of the failed build stay.
        script = (f"mount -t tmpfs -o size=80m tmpfs {build}; fallocate -l 79m {build}/ballast\n"
                  f"tried() {{ env PATH={self.machine.bin} ./poinsot info; echo exit $?; }}\n"
                  f"tried; rm {build}/ballast; tried")
        run = subprocess.run([*inside, script], cwd=self.machine.tree, env=path | {"MACHINE": str(self.machine.state)},
                             capture_output=True, text=True)
        self.assertEqual(run.stdout, "exit 3\nran info\nexit 0\n", run.stderr)
        # The compiler's message is lost, because its log is on the full disk.
        self.assertIn(f"poinsot: the build failed, because the disk of {build} is full: free some space ", run.stderr)

    def test_reports_that_another_disk_is_full(self):
        self.machine.has("build", "fatal error: error writing to /tmp/cc.s: No space left on device\n")
        self.refused(self.machine.start("build"), "the build failed, because a disk is full (log: ", "free some space, then start this again")
        self.machine.has("build", "")
        self.works()

    def test_reports_a_folder_that_it_cannot_write(self):
        self.machine.tree.chmod(0o755)
        if os.geteuid() != 0:
            self.machine.tree.chmod(0o555)
        run = self.machine.start("build", before=NOBODY)
        self.refused(run, "build cannot be written, for the reason above")
        self.assertIn("Permission denied", run.stderr)
        self.machine.tree.chmod(0o777)
        self.works()

    def test_does_not_report_a_compile_error_as_a_full_disk(self):
        self.machine.has("build", "a.cpp:1: error: expected ';'\n")
        run = self.machine.start("build")
        self.refused(run, "the build failed, for the reason above (log: ")
        self.assertIn("expected ';'", run.stderr)
        self.assertNotIn("full", run.stderr)
        self.machine.has("build", "")
        self.works()

    def test_notes_an_untested_architecture_once(self):
        note = "poinsot: poinsot was tested on x86_64 only, not on riscv64: run ./poinsot test to check that it works\n"
        self.machine.fake("uname", "echo riscv64")
        self.assertIn(note, self.works().stderr)
        os.utime(self.machine.tree / "CMakeLists.txt")  # causes another build
        again = self.machine.start("build").stderr
        self.assertIn("building", again)
        self.assertNotIn(note, again)
        shutil.rmtree(self.machine.tree / "build")
        self.machine.fake("uname", "echo x86_64")
        self.assertNotIn("was tested on", self.works().stderr)


if __name__ == "__main__":
    unittest.main()
