#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the steps of packaging/action/action.yml as GitHub's runner would: with its variables and files, but without
GitHub. The steps that use another action are not run; their inputs are checked.

Usage: action_test.py SOURCES BUILD
"""

import html
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import yaml

SOURCES, BUILD = Path(sys.argv[1]), Path(sys.argv[2])
ACTION = SOURCES / "packaging/action"
CONSUMER = SOURCES / "tests/consumer/pytest"
SCENE = "[body]\nprincipal_moments = [1, 2, 2.5]\n[motion]\nomega_body = [0.05, \"{} rpm\", 0]\n"


class Runner:
    """Runs a composite action. After run(), it has the exit code, the outputs and the summary."""

    def __init__(self, folder):
        self.folder, self.place = folder, folder / "work"
        self.place.mkdir()
        self.action = yaml.safe_load((ACTION / "action.yml").read_text())

    def git(self, *words, cwd=None):
        environment = {**os.environ, "GIT_CONFIG_GLOBAL": "/dev/null", "GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@b", "GIT_COMMITTER_NAME": "a", "GIT_COMMITTER_EMAIL": "a@b"}
        return subprocess.run(["git", *words], cwd=cwd or self.place, env=environment, check=True, capture_output=True, text=True).stdout

    def commit(self):
        self.git("init", "-q", ".")
        self.git("add", ".")
        self.git("commit", "-qm", "baselines")

    def run(self, **inputs):
        known = self.action["inputs"]
        assert inputs.keys() <= known.keys(), inputs
        self.inputs = {key: value["default"] for key, value in known.items()} | inputs
        self.files = {name: self.folder / name for name in ("GITHUB_OUTPUT", "GITHUB_STEP_SUMMARY", "GITHUB_PATH")}
        for file in self.files.values():
            file.write_text("")
        self.outputs, self.used, self.said, self.status, path = {}, [], "", 0, f"{BUILD}/bin:/usr/bin:/bin"
        for step in self.action["runs"]["steps"]:
            if not self._condition(step.get("if", "success()")):
                continue
            if "uses" in step:
                self.used.append({key: self._filled(value) for key, value in step["with"].items()})
                continue
            variables = {key: self._filled(value) for key, value in step.get("env", {}).items()}
            done = subprocess.run(
                ["bash", "--noprofile", "--norc", "-e", "-o", "pipefail", "-c", step["run"]], cwd=self.place, capture_output=True, text=True,
                env={"PATH": path, "HOME": str(self.folder), "CI": "true", "GITHUB_ACTIONS": "true", "GITHUB_ACTION_PATH": str(ACTION), "RUNNER_TEMP": str(self.folder / "temp"),
                     "PYTHONPATH": str(BUILD / "python"), "PYTHONDONTWRITEBYTECODE": "1", "POINSOT_CACHE": str(BUILD / "cache"), **{key: str(value) for key, value in self.files.items()}, **variables})
            self.said += done.stdout + done.stderr
            self.status = self.status or done.returncode
            path = ":".join([*self.files["GITHUB_PATH"].read_text().split(), path])
            self.outputs = dict(line.split("=", 1) for line in self.files["GITHUB_OUTPUT"].read_text().splitlines())
        self.summary = self.files["GITHUB_STEP_SUMMARY"].read_text()

    def _value(self, word):
        if word.startswith("inputs."):
            return self.inputs[word.removeprefix("inputs.")]
        assert word.startswith("steps.compare.outputs."), word
        return self.outputs.get(word.removeprefix("steps.compare.outputs."), "")

    def _filled(self, text):
        return re.sub(r"\$\{\{ (\S+) \}\}", lambda found: self._value(found[1]), text)

    def _condition(self, text):
        parts = text.split(" && ")
        if "always()" not in parts and self.status:
            return False
        return all(self._value(part.split()[0]) != "" for part in parts if "!=" in part)


class Action(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.runner = Runner(Path(folder.name))
        self.place = self.runner.place

    def make_suite(self):
        """Makes a repository with a suite of two scenes that are approved."""
        (self.place / "golden.toml").write_text('size = [96, 54]\n[[test]]\nscene = "slow.toml"\n[[test]]\nscene = "fast.toml"\n')
        for name, speed in (("slow", 10), ("fast", 20)):
            (self.place / f"{name}.toml").write_text(SCENE.format(speed))
        (self.place / ".gitignore").write_text("out/\n")
        subprocess.run([BUILD / "bin/poinsot", "golden", "--update"], cwd=self.place, check=True, capture_output=True, env={**os.environ, "CI": ""})
        self.runner.commit()

    def check_patch(self, *pictures):
        """Checks that git applies the patch in a clean clone, and that it holds exactly these pictures."""
        clone = self.runner.folder / "clone"
        self.runner.git("clone", "-q", self.place, clone)
        self.runner.git("apply", str(self.place / self.runner.outputs["patch"]), cwd=clone)
        changed = self.runner.git("diff", "--name-only", cwd=clone).split() + self.runner.git("ls-files", "--others", cwd=clone).split()
        self.assertEqual(sorted(name for name in changed if name.endswith(".png")), sorted(pictures))
        return clone

    def test_passes_with_the_same_pictures(self):
        self.make_suite()
        self.runner.run(suite="golden.toml")
        self.assertEqual(self.runner.status, 0, self.runner.said)
        self.assertEqual(self.runner.outputs, {"identical": "2", "near": "0", "different": "0", "missing": "0", "new": "0", "unused": "0", "error": "0",
                                               "failed": "0", "report": "out/golden/report.html", "patch": ""})
        self.assertIn("passed", self.runner.summary)
        self.assertEqual(self.runner.used, [{"name": "golden", "path": "out/golden"}])

    def test_fails_with_a_page_a_table_and_a_patch(self):
        self.make_suite()
        (self.place / "fast.toml").write_text(SCENE.format(21))
        self.runner.run(suite="golden.toml")
        self.assertEqual(self.runner.status, 1, self.runner.said)
        self.assertEqual((self.runner.outputs["identical"], self.runner.outputs["different"], self.runner.outputs["failed"]), ("1", "1", "1"))
        self.assertRegex(self.runner.summary, r"(?s)failed.*fast")
        self.assertIn("<html", (self.place / "out/golden/report.html").read_text())
        self.assertEqual(self.runner.git("status", "--porcelain"), " M fast.toml\n", "the job changes no reference")
        clone = self.check_patch("golden/fast.png")
        self.assertEqual((clone / "golden/fast.png").read_bytes(), (self.place / "out/golden/fast.png").read_bytes())

    def test_compares_two_folders(self):
        for folder in ("old", "new"):
            (self.place / folder).mkdir()
        first, second = sorted((SOURCES / "docs/images/gallery").glob("*.png"))[:2]
        for copy, original in (("old/a", first), ("old/b", first), ("new/a", first), ("new/b", second)):
            shutil.copy(original, self.place / f"{copy}.png")
        self.runner.commit()
        self.runner.run(reference="old", new="new", artifact="")
        self.assertEqual(self.runner.status, 1, self.runner.said)
        self.assertEqual((self.runner.outputs["identical"], self.runner.outputs["different"]), ("1", "1"))
        self.assertEqual(self.runner.used, [])
        self.check_patch("old/b.png")

    def test_runs_pytest(self):
        shutil.copytree(CONSUMER, self.place, dirs_exist_ok=True)
        (self.place / ".gitignore").write_text("out/\n__pycache__/\n")
        approve = ["/usr/bin/python3", "-m", "pytest", "-q", "-p", "no:cacheprovider", "tests", "--golden-update"]
        environment = {**os.environ, "CI": "", "PYTHONPATH": str(BUILD / "python"), "PYTHONDONTWRITEBYTECODE": "1"}
        subprocess.run(approve, cwd=self.place, check=True, capture_output=True, env=environment)
        self.runner.commit()
        self.runner.run(pytest="tests -p no:cacheprovider")
        self.assertEqual(self.runner.status, 0, self.runner.said)
        self.assertEqual(self.runner.outputs["identical"], "6")
        text = (self.place / "tests/test_plots.py").read_text()
        (self.place / "tests/test_plots.py").write_text(text.replace('"tab:blue"', '"tab:green"'))
        self.runner.run(pytest="tests -p no:cacheprovider")
        self.assertEqual(self.runner.status, 1, self.runner.said)
        self.assertEqual((self.runner.outputs["identical"], self.runner.outputs["different"]), ("5", "1"))
        summary = html.unescape(self.runner.summary)
        self.assertIn("| different | tests/test_plots/test_wave |", summary)
        self.assertNotIn("| identical |", summary)
        self.check_patch("tests/golden/test_plots/test_wave.png")

    def test_reports_an_error_of_the_suite(self):
        self.make_suite()
        (self.place / "golden.toml").write_text("[[tests]]\n")
        self.runner.run(suite="golden.toml")
        self.assertEqual(self.runner.status, 2, self.runner.said)
        self.assertIn("did you mean", self.runner.said)
        self.assertEqual(self.runner.used, [], "there is no page to keep")

    def test_refuses_contradictory_inputs(self):
        for inputs, text in (({}, "exactly one of the inputs"), ({"suite": "a", "pytest": "b"}, "exactly one of the inputs"), ({"reference": "a"}, "new: give the folder")):
            self.runner.run(**inputs)
            self.assertEqual(self.runner.status, 2)
            self.assertIn(f"::error::poinsot: ", self.runner.said)
            self.assertIn(text, self.runner.said)

    def test_runs_no_input_as_a_command(self):
        self.make_suite()
        hostile = "$(touch hacked) `touch hacked` && touch hacked; touch hacked"
        for inputs in ({"suite": hostile}, {"pytest": hostile}, {"reference": hostile, "new": hostile}, {"suite": "golden.toml", "options": hostile}):
            self.runner.run(**inputs)
            self.assertNotEqual(self.runner.status, 0)
        self.assertFalse((self.place / "hacked").exists())

    def test_runs_the_script_of_the_template_for_gitlab(self):
        self.make_suite()
        made = self.archive()
        digest = subprocess.run(["sha256sum", made], capture_output=True, text=True, check=True).stdout.split()[0]
        job = yaml.safe_load((ACTION / "gitlab.yml").read_text())[".poinsot-golden"]
        variables = {**job["variables"], "SUITE": "golden.toml", "POINSOT_ARCHIVE": f"file://{made}", "POINSOT_SHA256": digest}
        run = lambda: subprocess.run(["bash", "-e", "-c", "\n".join(job["before_script"] + job["script"])], cwd=self.place, capture_output=True, text=True,
                                     env={"PATH": os.environ["PATH"], "HOME": str(self.runner.folder), "CI": "true", "CI_PROJECT_DIR": str(self.place), "POINSOT_CACHE": str(BUILD / "cache"), **variables})
        done = run()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        (self.place / "fast.toml").write_text(SCENE.format(21))
        done = run()
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("different=1", done.stdout)
        self.assertIn("fast", (self.place / "out/golden/junit.xml").read_text())

    def archive(self):
        """Makes an archive like packaging/portable, with a stand-in for the program."""
        folder = self.runner.folder / "poinsot-0.0-linux-x86_64"
        (folder / "bin").mkdir(parents=True)
        (folder / "bin/poinsot").write_text(f'#!/bin/sh\necho from the archive >&2\nexec {BUILD}/bin/poinsot "$@"\n')
        (folder / "bin/poinsot").chmod(0o755)
        (folder / "share/poinsot/ci").mkdir(parents=True)
        shutil.copy(ACTION / "compare.sh", folder / "share/poinsot/ci")
        made = self.runner.folder / "archive.tar.xz"
        subprocess.run(["tar", "cJf", made, "-C", self.runner.folder, folder.name], check=True)
        return made

    def test_installs_the_archive_and_checks_its_digest(self):
        self.make_suite()
        made = self.archive()
        digest = subprocess.run(["sha256sum", made], capture_output=True, text=True, check=True).stdout.split()[0]
        self.runner.run(suite="golden.toml", archive=f"file://{made}", sha256=digest)
        self.assertEqual(self.runner.status, 0, self.runner.said)
        self.assertGreater(self.runner.said.count("from the archive"), 1)
        for archive, sha256, text in ((f"file://{made}", "", "give the digest"), (f"file://{made}", digest[::-1], "has another SHA-256 digest"), ("nothing.tar.xz", "", "no such file"),
                                      ("file:///nothing.tar.xz", digest, "cannot be downloaded")):
            self.runner.run(suite="golden.toml", archive=archive, sha256=sha256)
            self.assertEqual(self.runner.status, 2, self.runner.said)
            self.assertIn(text, self.runner.said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
