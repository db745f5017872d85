#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests the portable package in a system that contains nothing but glibc, as an ordinary user without a network.

Usage: portable_test.py SOURCES BUILD
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCES, BUILD = Path(sys.argv[1]), Path(sys.argv[2])
sys.path.insert(0, str(SOURCES / "packaging/portable"))
import elf  # noqa: E402
import wheel  # noqa: E402
from closure import STAND_IN, Closure  # noqa: E402

GLIBC = ("libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1", "libmvec.so.1")
VERSION = re.search(r'CPACK_PACKAGE_VERSION "(.*)"', (BUILD / "CPackConfig.cmake").read_text())[1]
SCENES = "/opt/poinsot/share/poinsot/scenes"


def isolation():
    """Returns the words that start a command in a chroot, without a network; None if this user may not."""
    for words in (["unshare", "--user", "--map-root-user", "--net"], ["unshare", "--net"] if os.geteuid() == 0 else None):
        if words and subprocess.run([*words, "chroot", "/", "true"], capture_output=True).returncode == 0:
            return words
    return None


def blocks_of(page, heading):
    """Returns the blocks of code below a heading of a page, by language."""
    text = (SOURCES / "docs" / page).read_text().split(f"{heading}\n", 1)[1]
    text = re.split(r"^#{1,3} ", text, maxsplit=1, flags=re.MULTILINE)[0]
    return dict(re.findall(r"^```(\w+)\n(.*?)^```", text, re.MULTILINE | re.DOTALL))


class Portable(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.enter = isolation()
        if cls.enter is None:
            raise unittest.SkipTest("this user may not make a namespace with its own root folder")
        cls.room = Path(tempfile.mkdtemp(prefix="poinsot-portable."))
        cls.addClassCleanup(shutil.rmtree, cls.room)
        made = subprocess.run([sys.executable, "-B", SOURCES / "packaging/portable", "--no-build", "--folder"],
                              env={**os.environ, "POINSOT_BUILD_DIR": str(BUILD)}, capture_output=True, text=True)
        if made.returncode != 0:
            raise AssertionError(made.stderr)
        cls.said = made.stderr
        cls.wheel = wheel.make(BUILD / "portable", BUILD, VERSION)
        cls.addClassCleanup(cls.wheel.unlink)
        (cls.room / "opt").mkdir()
        shutil.copytree(BUILD / "portable", cls.room / "opt/poinsot", symlinks=True)
        for folder in ("lib64", "lib/x86_64-linux-gnu", "tmp", "dev", "proc"):
            (cls.room / folder).mkdir(parents=True)
        (cls.room / "dev/null").touch()
        # The loader reads this link to find libraries beside the program. Mounting the real /proc needs more rights.
        (cls.room / "proc/self").mkdir()
        (cls.room / "proc/self/exe").symlink_to("/opt/poinsot/bin/poinsot")
        for open_to_all in ("tmp", "dev/null"):
            (cls.room / open_to_all).chmod(0o777)
        cls.room.chmod(0o755)
        shutil.copy("/lib64/ld-linux-x86-64.so.2", cls.room / "lib64")
        for name in GLIBC:
            shutil.copy(f"/lib/x86_64-linux-gnu/{name}", cls.room / "lib/x86_64-linux-gnu")

    def folder(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        return Path(made.name)

    def run_in_room(self, *words, program="poinsot", **settings):
        user = ["--userspec=65534:65534"] if os.geteuid() == 0 and "--user" not in self.enter else []
        return subprocess.run([*self.enter, "chroot", *user, self.room, f"/opt/poinsot/bin/{program}", *words],
                              env={"HOME": "/tmp", "PATH": "/usr/sbin:/usr/bin:/sbin:/bin", **settings}, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL)

    def expect_done(self, *words):
        done = self.run_in_room(*words)
        self.assertEqual(done.returncode, 0, f"{' '.join(words)}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def test_draws_and_encodes_every_kind_of_film(self):
        said = self.expect_done("doctor")
        # Oracle: the same program on this machine, with Debian's own libraries.
        here = subprocess.run([BUILD / "bin/poinsot", "doctor"], capture_output=True, text=True).stdout
        kinds = [line for line in here.splitlines() if line.startswith("ok      film")]
        self.assertGreater(len(kinds), 5)
        for line in kinds:
            self.assertIn(line, said)

    def test_makes_the_film_of_the_installed_program(self):
        words = ["--frames", "0-5", "--size", "320x180", "-j", "1", "--quiet", "--reproducible"]
        self.expect_done("render", f"{SCENES}/tennis_racket.toml", "-o", "/tmp/portable.mp4", *words)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([BUILD / "bin/poinsot", "render", SOURCES / "scenes/tennis_racket.toml", "-o", f"{folder}/here.mp4", *words], check=True)
            self.assertEqual((self.room / "tmp/portable.mp4").read_bytes(), Path(f"{folder}/here.mp4").read_bytes())

    def test_reads_its_own_libraries_in_the_sandbox(self):
        self.expect_done("render", f"{SCENES}/football.toml", "-o", "/tmp/sandboxed.mp4", "--frames", "0-2", "--size", "96x54", "--untrusted")
        self.assertGreater((self.room / "tmp/sandboxed.mp4").stat().st_size, 1000)

    def test_runs_a_golden_suite(self):
        suite = self.room / "tmp/golden.toml"
        suite.write_text(f'size = [96, 54]\n[[test]]\nscene = "{SCENES}/football.toml"\n')
        words = ["golden", "/tmp/golden.toml", "-o", "/tmp/new", "--asset-root", SCENES]
        self.expect_done(*words, "--update")
        self.assertIn("1 identical", self.expect_done(*words, "--report", "/tmp/report.html"))
        (self.room / "tmp/golden/football.png").write_bytes((self.room / "tmp/golden/football.png").read_bytes()[:100])
        self.assertEqual(self.run_in_room(*words).returncode, 1)

    def test_names_the_licence_and_the_sources_of_each_library(self):
        folder = self.room / "opt/poinsot/share/doc/poinsot/licences"
        listed = (folder / "PARTS.txt").read_text()
        libraries = [path for path in (self.room / "opt/poinsot/lib").rglob("*.so*") if path.name != STAND_IN]
        self.assertIn("swrast_dri.so", {library.name for library in libraries})
        for library in libraries:
            self.assertRegex(listed, rf"files:.*\b{library.name.split('.so')[0]}\b.*\n    licence: .*\n    sources: https://")
        for name in set(part for line in listed.splitlines() if "licence:" in line for part in line.split("licence: ")[1].split(", ")):
            self.assertGreater((folder / name).stat().st_size, 100, name)

    def run_with_wheel(self, folder, script, code=0):
        """Runs a script in a folder that has the wheel, the unpacked archive and the program on the path."""
        name = f"poinsot-{VERSION}-linux-x86_64"
        if not (folder / name).exists():
            (folder / name).symlink_to(BUILD / "portable")
            (folder / self.wheel.name).symlink_to(self.wheel)
        environment = {"PATH": f"{folder / name}/bin:/usr/bin:/bin", "HOME": str(folder), "POINSOT_CACHE": str(BUILD / "cache")}
        done = subprocess.run(["bash", "-euc", script], cwd=folder, capture_output=True, text=True, env=environment)
        self.assertEqual(done.returncode, code, f"{script}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def test_installs_as_a_wheel_with_command_package_and_plugin(self):
        self.assertRegex(self.wheel.name, r"^poinsot-[0-9.]+-cp3\d+-cp3\d+-manylinux_2_\d+_x86_64\.whl$")
        folder = self.folder()
        run = lambda script: self.run_with_wheel(folder, script)
        recipe = blocks_of("ci.md", "### pytest")["sh"]
        (folder / "test_it.py").write_text("import numpy as np\ndef test_it(golden):\n    golden(np.zeros((9, 9), np.uint8))\n")
        self.assertIn("nothing was approved yet", self.run_with_wheel(folder, recipe, code=1))
        run("venv/bin/python -m pytest --golden-update")
        self.assertIn("1 identical", run(recipe))
        self.assertIn("test_it", (folder / "out/junit.xml").read_text())
        self.assertIn("poinsot ", run("venv/bin/poinsot --version"))
        (folder / "try.py").write_text(
            "import poinsot\n"
            f"scene = poinsot.load('{SOURCES}/scenes/football.toml')\n"
            "assert '/venv/' in poinsot.__file__, poinsot.__file__\n"
            "assert scene.render(size=(64, 36)).shape == (36, 64, 3)\n"
            "scene.film('wheel.mp4', size=(64, 36), frames=(0, 2), jobs=1)\n"
            "print([line.split()[-1] for line in open('/proc/self/maps') if 'LLVM' in line][0])\n"
        )
        self.assertIn("/venv/lib/python3", run("venv/bin/python try.py"))  # its own LLVM, not the system's

    def test_follows_the_recipe_for_a_folder_of_pictures(self):
        folder, recipe = self.folder(), blocks_of("ci.md", "### A folder of pictures")["sh"]
        first, second = sorted((SOURCES / "docs/images/gallery").glob("*.png"))[:2]
        for place in ("approved", "new"):
            (folder / place).mkdir()
            shutil.copy(first, folder / place / "a.png")
        (folder / "out").mkdir()
        self.assertIn("identical", self.run_with_wheel(folder, recipe))
        shutil.copy(second, folder / "new/a.png")
        self.run_with_wheel(folder, recipe, code=1)
        self.assertIn("<failure", (folder / "out/junit.xml").read_text())
        self.assertIn("a.png", (folder / "out/report.html").read_text())

    def test_follows_the_recipe_for_cmake(self):
        folder, blocks = self.folder(), blocks_of("ci.md", "### CMake")
        (folder / "CMakeLists.txt").write_text(blocks["cmake"])
        (folder / "golden.toml").write_text('size = [96, 54]\n[[test]]\nscene = "spin.toml"\n')
        shutil.copy(SOURCES / "scenes/football.toml", folder / "spin.toml")
        self.run_with_wheel(folder, "poinsot golden --update")
        self.run_with_wheel(folder, blocks["sh"])
        (folder / "spin.toml").write_text((folder / "spin.toml").read_text() + '\n[style]\ntheme = "dark"\n')
        self.assertIn("different  spin", self.run_with_wheel(folder, blocks["sh"], code=8))

    def run_other_program(self, *words, **settings):
        """Runs bin/poinsot-gl in the room, after adding a shell, a program that draws, and libglvnd without a Mesa."""
        if not (self.room / "bin").exists():
            (self.room / "bin").mkdir()
            shutil.copy("/bin/dash", self.room / "bin/sh")
            for name in ("libEGL.so.1", "libGLdispatch.so.0", "libexpat.so.1"):
                shutil.copy(elf.library(name), self.room / "lib/x86_64-linux-gnu" / name)
            source = SOURCES / "tests/package/other_program.c"
            subprocess.run([os.environ.get("CC", "gcc"), "-O1", "-o", self.room / "bin/other", source], check=True)
        return self.run_in_room(*words, program="poinsot-gl", **settings)

    def draw_with_other_program(self, *words, **settings):
        """Runs tests/package/other_program.c with the OpenGL of the package. Returns what it printed, by key."""
        done = self.run_other_program("other", *words, **settings)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        found = {}
        for line in done.stdout.splitlines():
            found.setdefault(line.partition(": ")[0], []).append(line.partition(": ")[2])
        return found

    def test_draws_for_another_program(self):
        osmesa = self.draw_with_other_program("osmesa")
        egl = self.draw_with_other_program("egl")
        # Oracle: the OpenGL that the program in the package reports.
        said = self.expect_done("doctor")
        for found in (osmesa, egl):
            self.assertIn(re.search(r"Mesa [0-9.]+", found["version"][0])[0], said)
            self.assertIn(re.search(r"LLVM [0-9.]+", found["renderer"][0])[0], said)
            self.assertIn("128 bits", found["renderer"][0])
            self.assertNotIn(STAND_IN, "".join(found["library"]))  # would hide functions of the real libraries
        self.assertEqual(osmesa["pixels"], egl["pixels"])
        by_name = {Path(path).name: path for path in egl["library"]}
        self.assertEqual(by_name["libexpat.so.1"], "/lib/x86_64-linux-gnu/libexpat.so.1")  # the system's goes first
        llvm = next(name for name in by_name if name.startswith("libLLVM"))
        for name in ("libGLX_mesa.so.0", "libEGL_mesa.so.0", "libgbm.so.1", llvm, "libstdc++.so.6"):
            self.assertTrue(by_name[name].startswith("/opt/poinsot/lib/"), by_name[name])

    def test_draws_for_another_program_despite_inherited_settings(self):
        plain = self.draw_with_other_program("egl")
        pinned = self.draw_with_other_program("egl", GALLIUM_DRIVER="softpipe", LP_NATIVE_VECTOR_WIDTH="256", LP_NO_RAST="1",
                                              __EGL_VENDOR_LIBRARY_FILENAMES="/nowhere", LIBGL_DRIVERS_PATH="/nowhere", MESA_GL_VERSION_OVERRIDE="2.1")
        self.assertEqual(pinned, plain)

    def test_rejects_other_programs_that_cannot_run(self):
        for words, code, reason in (((), 2, "no program to run"), (("--fast",), 2, "--fast: not an option"),
                                    (("/nowhere",), 127, "/nowhere: no such program"), (("nowhere",), 127, "nowhere: no such program"),
                                    (("/tmp",), 126, "/tmp: a folder"), (("/opt/poinsot/README.txt",), 126, "/opt/poinsot/README.txt: not an exec")):
            done = self.run_other_program(*words)
            self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
            self.assertIn(f"poinsot-gl: {reason}", done.stderr)

    def test_draws_with_the_driver_that_a_list_beside_libegl_names(self):
        folder = self.folder()
        shutil.copy(elf.library("libEGL.so.1"), folder / "libEGL.so.1")

        def doctor():
            done = subprocess.run([BUILD / "bin/poinsot", "doctor"], capture_output=True, text=True,
                                  env={"HOME": str(folder), "LD_LIBRARY_PATH": str(folder)})
            return next(line for line in done.stdout.splitlines() if line[8:].startswith("OpenGL egl"))
        self.assertRegex(doctor(), "^ok ")
        (folder / "poinsot_egl.json").write_text('{"file_format_version": "1.0.0", "ICD": {"library_path": "libmissing.so.0"}}')
        self.assertNotRegex(doctor(), "^ok ")

    def test_states_the_glibc_that_it_needs(self):
        self.assertRegex(self.said, r"needs glibc 2\.\d+ or newer")

    def test_replaces_only_libraries_that_nothing_else_needs(self):
        program = BUILD / "bin/poinsot"
        closure = Closure([program], elf.opened(program))
        replaced = {name for names in closure.replaced.values() for name in names}
        self.assertIn("libz3.so.4", replaced)
        for name, path in closure.kept.items():
            if name not in closure.replaced:
                self.assertEqual(replaced & set(elf.needed(path)), set(), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
