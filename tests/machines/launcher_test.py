# SPDX-License-Identifier: Apache-2.0
"""The launcher on bad machines: what apt, sudo, the compiler and the disk are is faked, with a tree of nothing to build.

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
# Each is a script; $MACHINE is the folder of the machine's state, in which a file holds words.
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
    """A computer with the launcher, whose state tests change."""

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
        """Sets the words of a file of the machine's state, one a line."""
        (self.state / name).write_text("".join(f"{word}\n" for word in text.split()) if name != "build" else text)

    def asked(self):
        """Returns what apt-get was asked for, without options, and forgets it."""
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
        """It ended with 3, and its last sentence has these words."""
        self.assertEqual((run.returncode, run.stdout), (3, ""), run.stderr)
        last = run.stderr[run.stderr.rindex("poinsot: "):]
        for words in said:
            self.assertIn(words, last)
        self.assertFalse((self.machine.tree / "build/bin/poinsot").exists())
        self.assertFalse((self.machine.tree / "build/.built-poinsot").exists())

    def works(self, **variables):
        """The next try builds, and the one after has nothing to do."""
        run = self.machine.start("info", **variables)
        self.assertEqual((run.returncode, run.stdout), (0, "ran info\n"), run.stderr)
        self.assertEqual(self.machine.start("info", **variables).stderr, "")
        return run

    def test_no_compiler_although_apt_installed_all(self):
        (self.machine.bin / "g++").unlink()
        self.machine.has("missing", "g++")
        self.refused(self.machine.start("build"), "there is no C++ compiler: install one (Debian: apt-get install g++)")
        self.assertEqual(self.machine.asked(), [["update"], ["install", "g++"]])
        self.machine.fake("clang++", "exit 0")
        self.works()

    def test_the_compiler_that_was_asked_for_is_absent(self):
        self.refused(self.machine.start("build", CXX="g++-99"), "no C++ compiler named g++-99, as the variable CXX has it")
        self.works(CXX="g++ -O1")

    def test_no_cmake(self):
        (self.machine.bin / "cmake").unlink()
        self.refused(self.machine.start("build"), "cmake is missing: install it (Debian: apt-get install cmake ninja-build)")

    def test_a_mirror_that_does_not_answer(self):
        for name, words in {"missing": "g++", "update": "100", "install": "100"}.items():
            self.machine.has(name, words)
        run = self.machine.start("build")
        self.refused(run, "apt-get update failed before, for the reason above: see to the network, or name another mirror in /etc/apt; "
                     "then start this again.")
        self.assertIn("E: Failed to fetch g++.deb", run.stderr)  # apt's own words stay visible
        self.assertFalse((self.machine.tree / "build").exists())
        self.machine.has("install", "0")  # the lists that are here were enough
        self.works()

    def test_apt_that_fails_with_all_mirrors_there(self):
        self.machine.has("missing", "g++")
        self.machine.has("install", "100")
        self.refused(self.machine.start("build"), "apt could not install all packages, for the reason above: mend that; then")
        self.machine.has("install", "0")
        self.works()

    def test_neither_root_nor_sudo(self):
        self.machine.has("missing", "g++ cmake")
        self.machine.has("offered", "libosmesa6")
        command = "sudo apt-get update && sudo apt-get install -y --no-install-recommends g++ cmake\n"
        self.machine.has("no-sudo", "")
        self.refused(self.machine.start("build", before=NOBODY), "sudo wants a password or is absent; please run:\n  " + command)
        (self.machine.bin / "sudo").unlink()
        self.refused(self.machine.start("build", before=NOBODY), command)
        self.assertEqual(self.machine.asked(), [])
        self.machine.has("missing", "")
        self.works()

    def test_without_rights_an_optional_package_is_not_missed(self):
        self.machine.has("missing", "libosmesa6")
        self.machine.has("offered", "libosmesa6")
        self.machine.has("no-sudo", "")
        run = self.machine.start("build", before=NOBODY)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.machine.asked(), [])

    def test_optional_packages_are_installed_where_they_are_offered(self):
        cases = {("", ""): [], ("", "libosmesa6"): [],  # it is present
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

    def test_a_full_disk(self):
        build = self.machine.tree / "build"
        build.mkdir()
        inside = ["unshare", "--map-root-user", "--mount", "bash", "-c"]
        path = {"PATH": os.environ["PATH"]}
        if subprocess.run([*inside, f"mount -t tmpfs tmpfs {build}"], env=path, capture_output=True).returncode != 0:
            self.skipTest("mounting needs root or namespaces of users")
        # The 1 MB that is left is less than the fake compiler writes. Then room is made, and what was written stays.
        script = (f"mount -t tmpfs -o size=80m tmpfs {build}; fallocate -l 79m {build}/ballast\n"
                  f"tried() {{ env PATH={self.machine.bin} ./poinsot info; echo exit $?; }}\n"
                  f"tried; rm {build}/ballast; tried")
        run = subprocess.run([*inside, script], cwd=self.machine.tree, env=path | {"MACHINE": str(self.machine.state)},
                             capture_output=True, text=True)
        self.assertEqual(run.stdout, "exit 3\nran info\nexit 0\n", run.stderr)
        # The words of the compiler are not to be had: they should have gone to a log on that disk.
        self.assertIn(f"poinsot: the build failed, as the disk of {build} is full: make room, ", run.stderr)

    def test_a_disk_that_is_full_elsewhere(self):
        self.machine.has("build", "fatal error: error writing to /tmp/cc.s: No space left on device\n")
        self.refused(self.machine.start("build"), "the build failed, as a disk is full (log: ", "make room, then start this again")
        self.machine.has("build", "")
        self.works()

    def test_a_folder_that_is_somebody_elses(self):
        self.machine.tree.chmod(0o755)
        if os.geteuid() != 0:
            self.machine.tree.chmod(0o555)
        run = self.machine.start("build", before=NOBODY)
        self.refused(run, "build cannot be written, for the reason above")
        self.assertIn("Permission denied", run.stderr)
        self.machine.tree.chmod(0o777)
        self.works()

    def test_a_mistake_in_the_sources_is_not_taken_for_a_full_disk(self):
        self.machine.has("build", "a.cpp:1: error: expected ';'\n")
        run = self.machine.start("build")
        self.refused(run, "the build failed, for the reason above (log: ")
        self.assertIn("expected ';'", run.stderr)
        self.assertNotIn("full", run.stderr)
        self.machine.has("build", "")
        self.works()

    def test_an_architecture_that_nobody_tried_is_noted_once(self):
        note = "poinsot: nobody has tried this on riscv64, only on x86_64: see by ./poinsot test whether all works\n"
        self.machine.fake("uname", "echo riscv64")
        self.assertIn(note, self.works().stderr)
        os.utime(self.machine.tree / "CMakeLists.txt")  # builds again
        again = self.machine.start("build").stderr
        self.assertIn("building", again)
        self.assertNotIn(note, again)
        shutil.rmtree(self.machine.tree / "build")
        self.machine.fake("uname", "echo x86_64")
        self.assertNotIn("nobody has tried", self.works().stderr)


if __name__ == "__main__":
    unittest.main()
