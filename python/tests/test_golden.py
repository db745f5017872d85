# SPDX-License-Identifier: Apache-2.0
"""Tests the plugin of pytest with a project that uses it, tests/consumer/pytest. Each test runs pytest in a copy."""

import json
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from conftest import ROOT
from PIL import Image

CONSUMER = ROOT / "tests/consumer/pytest"
NAMES = ["test_wave", "test_picture_with_a_date", "test_arrays[40]-colour", "test_arrays[40]-grey", "test_arrays[200]-colour", "test_arrays[200]-grey"]


class Project:
    def __init__(self, folder):
        self.folder = folder
        self.baselines = folder / "tests/golden/test_plots"

    def run(self, *words, fault="", env=None, code=0):
        """Runs pytest, and checks its exit code. Returns what it printed."""
        variables = {key: value for key, value in os.environ.items() if key != "CI"}
        done = subprocess.run(
            [sys.executable, "-B", "-m", "pytest", "-p", "no:cacheprovider", *words],
            cwd=self.folder, env={**variables, "POINSOT_FAULT": fault, **(env or {})}, capture_output=True, text=True,
        )
        assert done.returncode == code, done.stdout + done.stderr
        return done.stdout + done.stderr

    def digest(self):
        return {path.name: path.read_bytes() for path in self.baselines.iterdir()}

    def report(self):
        """Returns the rows of the page, by name."""
        page = (self.folder / "out/golden/report.html").read_text()
        data = json.loads(re.search(r'<script id="data" type="application/json">(.*?)</script>', page, re.S)[1])
        return {row["name"]: row for row in data["entries"]}


@pytest.fixture
def fresh(tmp_path):
    shutil.copytree(CONSUMER, tmp_path / "project")
    return Project(tmp_path / "project")


@pytest.fixture(scope="module")
def approved(tmp_path_factory):
    """Returns a folder with a project whose pictures are approved."""
    folder = tmp_path_factory.mktemp("approved") / "project"
    shutil.copytree(CONSUMER, folder)
    Project(folder).run("tests", "--golden-update")
    return folder


@pytest.fixture
def project(approved, tmp_path):
    shutil.copytree(approved, tmp_path / "project")
    return Project(tmp_path / "project")


def test_fails_without_baselines_and_writes_none(fresh):
    said = fresh.run("tests", code=1)
    assert said.count("nothing was approved yet") == 2 * len(NAMES)  # for each test, and in the summary
    assert not fresh.baselines.exists()
    assert "approve it: pytest 'tests/test_plots.py::test_arrays[40]' --golden-update" in said


def test_lists_baselines_that_no_test_of_a_complete_file_uses(project):
    left = project.baselines / "test_of_last_year.png"
    shutil.copy(project.baselines / "test_wave.png", left)
    line = "unused     tests/golden/test_plots/test_of_last_year.png: no test compares a picture with it"
    for words in (["tests"], ["tests", "-n", "2"], []):
        said = project.run(*words)
        assert line in said
        assert said.count("unused  ") == 1
        assert f"{len(NAMES)} identical, 1 unused" in said
    for words in (["tests", "-k", "wave"], ["tests/test_plots.py::test_wave"], ["tests", "--deselect", "tests/test_plots.py::test_wave"]):
        assert "unused  " not in project.run(*words)
    assert left.exists()
    with open(project.folder / "tests/test_plots.py", "a") as tests:
        tests.write("\n\n@pytest.mark.skip\n@pytest.mark.golden\ndef test_of_last_year():\n    pass\n")
    assert "unused  " not in project.run("tests")


def test_approves_pictures_beside_the_tests_and_passes_then(project):
    assert sorted(project.digest()) == sorted(f"{name}.png" for name in NAMES)
    assert f"{len(NAMES)} identical" in project.run("tests")
    # Oracle: PIL reads the pixels that the test gave.
    assert np.all(np.asarray(Image.open(project.baselines / "test_arrays[40]-colour.png")) == 40)
    grey = np.asarray(Image.open(project.baselines / "test_arrays[200]-grey.png"))
    assert grey.shape[:2] == (30, 40)


def test_reports_all_planted_faults_of_a_run_and_nothing_else(project):
    faults = {
        "title": ["test_wave"],
        "colour,ellipse,level": ["test_wave", "test_picture_with_a_date", "test_arrays[40]-colour", "test_arrays[200]-colour"],
    }
    for fault, failing in faults.items():  # level changes pixels by one level, which rule="same" refuses
        said = project.run("tests", fault=fault, code=1)
        assert re.findall(r"^different  tests/test_plots/(.*?):", said, re.M) == failing
        rows = project.report()
        assert {name: row["status"] for name, row in rows.items()} == {
            f"tests/test_plots/{name}": "different" if name in failing else "identical" for name in NAMES
        }
        assert all(rows[f"tests/test_plots/{name}"]["differing_pixels"] > 0 for name in failing)


def test_does_not_compare_ignored_places(project):
    assert "6 identical" in project.run("tests", env={"POINSOT_DATE": "tomorrow"})


def test_updates_only_the_pictures_of_a_pattern_and_prints_their_change(project):
    before = project.digest()
    said = project.run("tests", "--golden-update=test_arrays[40]*", fault="level", code=1)
    assert re.search(r"approved   tests/test_plots/test_arrays\[40\]-colour: 1200 pixels changed, largest difference 1, FLIP mean \S+, max \S+", said)
    changed = [name for name, content in project.digest().items() if before[name] != content]
    assert changed == ["test_arrays[40]-colour.png"]


def test_refuses_updates_in_ci(project):
    before = project.digest()
    assert "the environment variable CI is set" in project.run("tests", "--golden-update", env={"CI": "true"}, fault="level", code=4)
    assert project.digest() == before


def test_reports_the_same_with_two_workers(project):
    pytest.importorskip("xdist")
    project.run("tests", "-n", "2", fault="level", code=1)
    two = project.report()
    project.run("tests", fault="level", code=1)
    one = project.report()
    assert {name: row["status"] for name, row in two.items()} == {name: row["status"] for name, row in one.items()}


def test_adds_properties_to_junit(project):
    project.run("tests", "--junitxml=junit.xml", fault="colour", code=1)
    case = next(it for it in ET.parse(project.folder / "junit.xml").iter("testcase") if it.get("name") == "test_wave")
    properties = {it.get("name"): it.get("value") for it in case.iter("property")}
    assert properties["golden"] == "tests/test_plots/test_wave: different"
    assert float(properties["golden_flip_mean"]) > 0
    assert properties["golden_new"].endswith("out/golden/tests/test_plots/test_wave.png")


def damaged(path):
    path.write_bytes(path.read_bytes()[:200])


def pointer(path):
    path.write_text("version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 10\n")


def smaller(path):
    Image.new("RGB", (20, 10)).save(path)


def linked(path):
    path.rename(path.with_suffix(".other"))
    path.symlink_to(path.with_suffix(".other").name)


def test_fails_for_baselines_that_cannot_be_compared(project):
    changes = {
        "test_wave": (damaged, "ends too early"),
        "test_picture_with_a_date": (pointer, "Git LFS"),
        "test_arrays[40]-grey": (smaller, "the size is"),
    }
    for name, (change, _) in changes.items():
        change(project.baselines / f"{name}.png")
    said = project.run("tests", code=1)
    for name, (_, text) in changes.items():
        assert re.search(rf"golden: (error|different): tests/test_plots/{re.escape(name)}: .*{text}", said), said


def test_does_not_replace_a_link(project):
    linked(project.baselines / "test_wave.png")
    before = (project.baselines / "test_wave.other").read_bytes()
    assert "is a link, which is not replaced" in project.run("tests", "--golden-update", fault="colour", code=1)
    assert (project.baselines / "test_wave.other").read_bytes() == before


WRONG_MARKERS = [
    ("max=4", "max needs a reason: reason='why"),
    ("rul='same'", "unknown argument 'rul'; did you mean rule?"),
    ("'same'", "takes named arguments only, such as golden(rule='same')"),
    ("rule='nearly'", "unknown rule; known rules: same, near, other_driver"),
    ("max='0-x', reason='r'", "the end of the range must be a number"),
    ("max=255, pixels='0-100%', flip_mean=1, flip_max=1, reason='r'", "would pass"),
    ("ignore=[(0, 0, 5)], reason='r'", "must be a list of boxes"),
    ("save=3", "must be a dictionary with arguments of savefig()"),
    ("rule='same', name=3", "name=3: must be a text"),
]
NO_PICTURES = [
    ("None", "a test with the marker golden must return a picture"),
    ("3.5", "the picture is <float>"),
    ("np.zeros((4, 4))", "expected samples of type uint8 or uint16, got float64"),
    ("'nothing.png'", "nothing.png: No such file or directory"),
]


def test_refuses_wrong_markers_and_what_is_no_picture(fresh):
    tests = [f"@pytest.mark.golden({marker})\ndef test_it{i}():\n    return np.zeros((9, 9), np.uint8)\n" for i, (marker, _) in enumerate(WRONG_MARKERS)]
    tests += [f"@pytest.mark.golden\ndef test_no{i}():\n    return {returned}\n" for i, (returned, _) in enumerate(NO_PICTURES)]
    (fresh.folder / "tests/test_plots.py").write_text("import numpy as np, pytest\n" + "".join(tests))
    said = fresh.run("tests", "--golden-update", code=1)
    assert f"{len(tests)} failed" in said
    for _, text in WRONG_MARKERS + NO_PICTURES:
        assert text in said
    assert not fresh.baselines.exists()


def test_compares_scenes_files_and_pictures_with_own_png(fresh):
    (fresh.folder / "tests/test_plots.py").write_text(
        f"""import poinsot
scene = poinsot.load({str(ROOT / 'scenes/football.toml')!r}, {{"output.size": [64, 36], "time.still": 0.5}})
class Drawn:
    def _repr_png_(self):
        return scene._repr_png_()
def test_all(golden, tmp_path):
    golden(scene, name="scene", time=0.5, size=(64, 36))
    golden(Drawn(), name="drawn")
    (tmp_path / "file.png").write_bytes(Drawn()._repr_png_())
    golden(tmp_path / "file.png", name="file")
    scene.film(tmp_path / "film.mp4", size=(64, 36), frames=(0, 2), jobs=1)
    golden(str(tmp_path / "film.mp4"), name="film")
"""
    )
    fresh.run("tests", "--golden-update")
    assert sorted(fresh.digest()) == ["test_all-drawn.png", "test_all-file.png", "test_all-film.mp4", "test_all-scene.png"]
    assert "4 identical" in fresh.run("tests")
    # The scene and its PNG show the same pixels.
    pictures = [np.asarray(Image.open(fresh.baselines / f"test_all-{name}.png").convert("RGB")) for name in ("scene", "drawn")]
    assert np.array_equal(*pictures)


@pytest.fixture(scope="module")
def generated(tmp_path_factory):
    """Returns a folder with a project whose baselines pytest-mpl has made."""
    pytest.importorskip("pytest_mpl")
    folder = tmp_path_factory.mktemp("generated") / "project"
    shutil.copytree(CONSUMER, folder)
    Project(folder).run("adopted", "--mpl-generate-path=adopted/baseline", "-k", "not steep")
    Project(folder).run("adopted", "--mpl-generate-path=adopted/pictures", "-k", "steep")
    return folder


@pytest.fixture
def adopted(generated, tmp_path):
    shutil.copytree(generated, tmp_path / "project")
    return Project(tmp_path / "project")


ADOPT = "--golden-from=pytest-mpl"


def test_finds_the_baselines_of_pytest_mpl(adopted):
    assert "4 identical" in adopted.run("adopted", ADOPT)
    (adopted.folder / "pytest.ini").write_text("[pytest]\ngolden_from = pytest-mpl\n")
    assert "4 identical" in adopted.run("adopted")


@pytest.mark.parametrize("fault, code", [("slope", 1), ("slight", 1), ("slighter", 0)])
def test_decides_as_pytest_mpl(adopted, fault, code):
    """Oracle: pytest-mpl itself, and its figure for the root mean square."""
    theirs = adopted.run("adopted", "--mpl", fault=fault, code=code)
    ours = adopted.run("adopted", ADOPT, fault=fault, code=code)
    if code:
        rms = float(re.search(r"RMS Value: (\S+)", theirs)[1])
        assert f"root mean square {rms:.3g} (tolerance" in ours
    else:
        assert "passes only by pytest-mpl's tolerance" in ours


def test_approves_in_the_place_of_pytest_mpl(adopted):
    adopted.run("adopted", ADOPT, "--golden-update", fault="slope")
    adopted.run("adopted", "--mpl", fault="slope")


def test_refuses_hashes_of_pytest_mpl(adopted):
    file = adopted.folder / "adopted/test_adopted.py"
    file.write_text(file.read_text().replace("remove_text=True", "hash_library='hashes.json'"))
    assert "hashes of pictures are not read" in adopted.run("adopted", ADOPT, code=1)
