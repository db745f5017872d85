# SPDX-License-Identifier: Apache-2.0
"""Tests arguments: every function refuses wrong values by the argument's name. Also times with units, frames, files."""

import copy
import datetime
import errno
import functools
import inspect
import os
import pickle
import warnings
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import poinsot
from poinsot import _errors

OWN = {"body": {"principal_moments": [1, 2, 2.5]}, "motion": {"omega_body": [0.05, 2, 0]}}
CIRCLE = []
CIRCLE.append(CIRCLE)

WRONG = [
    *(None, True, -1, 0, 1.5, float("nan"), 1e300, 10**400, 2**63, Fraction(10**400), 1j, "", "x", "a\0b", "\ud800"),
    *(b"x", object(), [], (1, "2"), [1, 2, 3], [[1], [1, 2]], {}, {1: 2}, {"x": object()}, {"\ud800": 1}),
    *(range(5, 2), range(0, 9, 2), lambda: None, len, CIRCLE, {"x": CIRCLE}, slice(3), np.arange(3), np.float64(0.5)),
    *(np.ma.array([1.0], mask=[True]), np.array("2001-01-01", "M8[s]"), np.array(3, "m8"), np.array([object()])),
    *(2**31, 2**40, 10**5000, -(10**400), np.timedelta64(2, "Y"), np.timedelta64("NaT"), np.ma.masked, [None]),
    *(np.ma.array(np.eye(2), mask=np.eye(2)), np.array([1j]), Decimal("sNaN"), Decimal("1e999"), datetime.date.today()),
]

# A good value of each argument that has no default.
PICTURE = np.zeros((16, 16, 3), np.uint8)
GOOD = {"path": "scenes/none.toml", "source": OWN, "overrides": {}, "t": 0.0, "times": 0.0}
GOOD |= {"reference": PICTURE, "test": PICTURE, "table": {"t": [0.0], "T": [1.0], "omega_B": [[0.0, 1.0, 0.0]]}}


def called(it):
    """Returns a value as a text for messages. Python refuses to write an integer of 5000 digits."""
    return f"<{it.bit_length()} bits>" if isinstance(it, int) else f"{it!r:.60}"


def functions(scene):
    """Yields every public function, and every method of a scene, with its name."""
    for name in poinsot.__all__:
        if inspect.isfunction(thing := getattr(poinsot, name)):
            yield name, thing
    for name, _ in inspect.getmembers(poinsot.Scene, inspect.isfunction):
        if not name.startswith("_"):
            yield f"Scene.{name}", getattr(scene, name)


def test_messages_name_wrong_arguments_in_python_terms(tmp_path, racket):
    refused = 0
    for name, function in functions(racket):
        parameters = inspect.signature(function).parameters
        required = [name for name, parameter in parameters.items() if parameter.default is parameter.empty]
        assert GOOD.keys() >= set(required), f"{name}: give GOOD a value of {required}"
        good = {name: GOOD[name] for name in required}
        if name in ("Scene.save", "Scene.film"):
            good["path"] = tmp_path / "none" / "a.mp4"  # fails soon if all other arguments are good
        for parameter in parameters:
            for wrong in WRONG:
                where = f"{name}({parameter}={called(wrong)})"
                try:
                    with warnings.catch_warnings():
                        warnings.simplefilter("ignore", UserWarning)
                        function(**{**good, parameter: wrong})
                except poinsot.Error as error:
                    refused += 1
                    for word in ("--", "_core", "0x", "-D ", "array([", "incompatible", "argument must be", "0" * 30):
                        assert word not in str(error), f"{where}: {error}"
                    assert str(error), where
                except BaseException as error:
                    raise AssertionError(f"{where}: {error!r}") from error
    assert refused > 500


NO_DURATIONS = [it for it in WRONG if not (isinstance(it, float) and 0.001 <= it <= 3600)]


@pytest.mark.parametrize("wrong", NO_DURATIONS, ids=[called(wrong) for wrong in NO_DURATIONS])
def test_a_wrong_value_of_a_scene_is_refused_with_its_key(racket, wrong):
    for given in (wrong, [wrong], {"x": wrong}):
        with pytest.raises((poinsot.UsageError, poinsot.SceneError)) as caught:
            racket.replace({"time.duration": given})
        assert str(caught.value).startswith(("time.duration", "a key of time.duration")), str(caught.value)
        assert len(str(caught.value)) < 400, "a message shows no large value whole"
        with pytest.raises((poinsot.UsageError, poinsot.SceneError), match=r"time\.duration|a list contains itself"):
            poinsot.loads({**OWN, "time": {"duration": given}})


def test_masks_none_and_complex_numbers_are_named_with_their_key():
    masked = np.ma.array([[2.0, 0, 0], [0, 2, 0], [0, 0, 3]], mask=np.eye(3))
    for key, wrong, words in (
        ("body.inertia", masked, r"^body\.inertia: has masked values"),
        ("body.principal_moments", [1, None, 2], r"^body\.principal_moments\[1\]=None: a scene accepts"),
        ("motion.omega_body", np.array([1, 2, 3j]), r"^motion\.omega_body\[0\]=\S*1\+0j\S*: a scene accepts"),
        ("body.mass", 10**400, r"^body\.mass=<int>: is beyond the range of doubles"),
    ):
        table, _, name = key.partition(".")
        with pytest.raises(poinsot.UsageError, match=words):
            poinsot.loads(OWN, {key: wrong})
        with pytest.raises(poinsot.UsageError, match=words):
            poinsot.loads({**OWN, table: {name: wrong}})


@pytest.mark.parametrize(
    ("given", "seconds"),
    [
        (np.timedelta64(1500, "ns"), 1.5e-6),
        (np.timedelta64(2, "s"), 2.0),
        (np.array(250, "m8[ms]"), 0.25),
        (datetime.timedelta(milliseconds=300), 0.3),
        (Decimal("0.3"), 0.3),
    ],
)
def test_a_time_of_a_scene_may_have_its_unit(given, seconds):
    started = poinsot.loads({**OWN, "time": {"start": given}})
    assert started.motion_time(0) == seconds  # film time 0 is this motion time
    assert poinsot.loads(OWN).replace({"time.start": given}).motion_time(0) == seconds
    with pytest.raises(poinsot.SceneError, match=r"body\.mass.* s"):  # only keys of times take a unit
        poinsot.loads({**OWN, "body": {"principal_moments": [1, 2, 2.5], "mass": np.timedelta64(2, "s")}})


def test_series_of_pandas_are_vectors_and_paths_are_texts(tmp_path):
    (tmp_path / "own.toml").write_text('[style]\ntheme = "dark"\n')
    styled = poinsot.loads(OWN, {"style.file": Path("own.toml")}, folder=tmp_path)
    assert styled.overrides == {"style.file": "own.toml"}
    pandas = pytest.importorskip("pandas")
    moments = pandas.Series([1.0, 2.0, 2.5], index=["a", "b", "c"])
    assert poinsot.loads(OWN, {"body.principal_moments": moments}).overrides == {"body.principal_moments": [1, 2, 2.5]}
    with pytest.raises(poinsot.UsageError, match=r"^body\.principal_moments\[1\]"):
        poinsot.loads(OWN, {"body.principal_moments": pandas.Series([1, None, 2.5], dtype=object)})


def test_times_that_are_not_finite_are_shown_short():
    scene = poinsot.loads(OWN)
    for wrong in (10**400, [0, 10**5000], np.timedelta64("NaT"), np.array(["NaT"], "m8[s]")):
        with pytest.raises(poinsot.UsageError, match=r"^times.* = (<int>|NaT): a time is a finite number") as caught:
            scene.trajectory(wrong)
        assert len(str(caught.value)) < 100


@pytest.mark.parametrize("wrong", [0, -1, 1025, 2**31, 2**40, 1.5, "2", True])
def test_jobs_are_from_1_to_1024(racket, tmp_path, wrong):
    for made in (functools.partial(racket.film, tmp_path / "a.mp4"), functools.partial(poinsot.diff, PICTURE, PICTURE)):
        with pytest.raises(poinsot.UsageError, match="^jobs=.*must be 1 to 1024"):
            made(jobs=wrong)


def test_options_in_texts_of_the_user_are_kept(racket):
    for theme in ("--width 300", "a --resume b"):
        with pytest.raises(poinsot.SceneError, match=f'got "{theme}"'):
            racket.replace({"style.theme": theme})
    source = poinsot.loads(OWN).text + "[style]\ntheme = '--size 3x3' # --force\n"
    with pytest.raises(poinsot.SceneError, match=r"theme = '--size 3x3' # --force"):
        poinsot.loads(source)
    for kept in ("'--width 300'", '"--limit frames=N"', "   1 | name = --force", "`--resume`"):
        assert _errors.in_python(f"use --force\n{kept}\n--dpi 300") == f"use force=True\n{kept}\ndpi=300"


def test_a_scene_takes_no_attributes_and_equals_its_copy(racket):
    with pytest.raises(AttributeError):
        racket.foo = 1
    with pytest.raises(AttributeError):
        racket.name = "other"
    again = pickle.loads(pickle.dumps(racket))
    assert again == racket and hash(again) == hash(racket) and again is not racket
    assert racket.replace({"style.theme": "dark"}) != racket != racket.text
    assert poinsot.loads(OWN) == poinsot.loads(OWN) != poinsot.loads(OWN, folder="/") != poinsot.loads(OWN)


def test_scenes_cannot_be_made_by_their_class():
    with pytest.raises(TypeError, match=r"poinsot.load\(\)"):
        poinsot.Scene()


@pytest.mark.parametrize(
    ("given", "seconds"),
    [
        (np.array([1500, -3], "m8[ms]"), [1.5, -0.003]),
        (np.timedelta64(2, "h"), 7200.0),
        (np.array([[3]], "m8[25us]"), [[75e-6]]),
        (np.array([7], "m8[as]"), [7e-18]),
        (np.array(2**20, "m8[W]"), 2.0**20 * 604800),
        (datetime.timedelta(days=1, microseconds=1), 86400.000001),
        ([datetime.timedelta(0, 2), 3, Decimal("0.5"), Fraction(1, 4)], [2.0, 3.0, 0.5, 0.25]),
        ([np.timedelta64(5, "s"), 2.5], [5.0, 2.5]),
        (np.ma.array([1.0, 2.0], mask=[False, False]), [1.0, 2.0]),
        (np.array([1, 2], ">f4"), [1.0, 2.0]),
        (np.float16(0.5), 0.5),
        ([], []),
        (range(3), [0.0, 1.0, 2.0]),
    ],
)
def test_times_are_seconds_or_have_a_unit(given, seconds):
    t = poinsot.loads(OWN).trajectory(given).t
    assert t.dtype == np.float64 and t.shape == np.shape(seconds)
    assert t.tolist() == seconds  # to the last bit, because each value is rounded once


def test_timedeltas_of_pandas_are_times():
    pandas = pytest.importorskip("pandas")
    given = pandas.to_timedelta([1, 2.5], unit="s")
    for form in (given, pandas.Series(given), list(given)):
        assert poinsot.loads(OWN).trajectory(form).t.tolist() == [1, 2.5]
    assert poinsot.loads(OWN).trajectory(given[1]).t == 2.5
    for dates in (pandas.date_range("2001-01-01", periods=2), pandas.Series([1.0, None]), pandas.array([1, None])):
        with pytest.raises(poinsot.UsageError, match="times"):
            poinsot.loads(OWN).trajectory(dates)


class Quantity(np.ndarray):
    """An array with a unit, like those of packages for units."""

    unit = "ms"


@pytest.mark.parametrize(
    ("given", "place"),
    [
        (np.ma.array([1.0, 2.0], mask=[False, True]), r"times\[1\] = masked"),
        ([[1.0, float("nan")]], r"times\[0, 1\] = nan"),
        (np.array(["NaT", 1], "m8[s]"), r"times\[0\] = NaT"),
        (np.array([1], "m8[Y]"), "unit"),
        (np.array([1], "m8"), "unit"),
        (np.array([1], "M8[s]"), "datetime64"),
        (np.array([1500]).view(Quantity), "unit of its own"),
        ([1j], "complex"),
        (["1.5"], "<U3"),
        ([True, False], "bool"),
        ([1.0, None], r"times\[1\]: .*None"),
        (10**400, "inf|whole|number"),
        ([[1], [1, 2]], "number of seconds"),
    ],
)
def test_values_that_are_not_times_are_refused_with_their_index(given, place):
    with pytest.raises(poinsot.UsageError, match=place):
        poinsot.loads(OWN).trajectory(given)


def test_film_times_lie_in_the_film(racket, tmp_path):
    for wrong in (-1, 1e300, 14.1, [0, 15], None):
        with pytest.raises(poinsot.UsageError, match="^t"):
            racket.motion_time(wrong)
    for wrong in (-1, 14.1, [0.0], "1"):
        for made in (racket.render, lambda t: racket.save(tmp_path / "a.png", t)):
            with pytest.raises(poinsot.UsageError, match="^t"):
                made(wrong)
    assert racket.motion_time(np.timedelta64(10, "s")) == racket.motion_time(10.0)


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ((3, 5), "3-5"),
        (np.array([3, 5]), "3-5"),
        ([np.int32(3), 5], "3-5"),
        (range(3, 6), "3-5"),
        (range(0, 1), "0-0"),
    ],
)
def test_frames_are_a_pair_or_a_range(racket, monkeypatch, asked, words):
    seen = []
    monkeypatch.setattr(poinsot._scene._program, "run", lambda command, output, said, progress: seen.extend(said))
    film = racket.film("a.mp4", frames=asked)
    assert seen[seen.index("--frames") + 1] == words
    assert film.frame_count == len(range(*map(int, words.split("-")))) + 1


@pytest.mark.parametrize(
    "asked",
    [
        *((0, 5, 9), [1], 5, np.arange(10), range(0, 10, 2), range(5, 5), range(9, 0, -1), (1.0, 2), (True, 2)),
        *("0-9", (3, 0), (-1, 2), (0, 420), range(0, 421), slice(0, 9), {0, 9}, (None, 3)),
    ],
)
def test_invalid_frames_are_refused(racket, asked):
    with pytest.raises(poinsot.UsageError, match="^frames="):
        racket.film("a.mp4", frames=asked)


@pytest.mark.parametrize("size", [320, "320x180", (320.5, 100), (320,), (1, 2, 3), {}, (True, 90)])
def test_a_size_is_two_whole_numbers(racket, size):
    film, save = functools.partial(racket.film, "a.mp4"), functools.partial(racket.save, "a.png")
    for made in (racket.render, film, save):
        with pytest.raises(poinsot.UsageError, match="^size=.*width and height in pixels"):
            made(size=size)


@pytest.mark.parametrize(
    ("name", "kind", "number"),
    [
        ("nothing.toml", FileNotFoundError, errno.ENOENT),
        ("", FileNotFoundError, errno.ENOENT),
        (".", IsADirectoryError, errno.EISDIR),
        ("file/below.toml", NotADirectoryError, errno.ENOTDIR),
        ("x" * 300, OSError, errno.ENAMETOOLONG),
    ],
)
def test_an_unreadable_file_raises_pythons_own_error_too(tmp_path, monkeypatch, name, kind, number):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("")
    with pytest.raises(kind):
        open(name)  # the oracle
    with pytest.raises(kind) as caught:
        poinsot.load(name)
    error = caught.value
    assert isinstance(error, poinsot.FileError) and (error.errno, error.filename) == (number, name)
    assert str(error).endswith(("directory", "File name too long", "Not a directory"))
    assert error.strerror == os.strerror(number)
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), str(again), again.errno) == (type(error), str(error), number)


def failing_calls(scene, path):
    """Yields calls that read or write a file `path` with various endings."""
    for suffix, call in ((".png", poinsot.diff), (".mp4", poinsot.diff)):
        yield functools.partial(call, f"{path}{suffix}", PICTURE)
        yield functools.partial(call, PICTURE, PICTURE, mask=f"{path}.png")
    yield functools.partial(scene.grade, f"{path}.csv")
    yield functools.partial(poinsot.load, f"{path}.toml")
    for suffix in (".png", ".pdf"):
        yield functools.partial(scene.save, f"{path}{suffix}", size=(32, 32))
    yield functools.partial(scene.film, f"{path}.mp4", size=(32, 32), frames=(0, 1))


@pytest.mark.parametrize(
    ("name", "kind", "number"),
    [
        ("none/x", FileNotFoundError, errno.ENOENT),
        ("file/x", NotADirectoryError, errno.ENOTDIR),
        ("x" * 300, OSError, errno.ENAMETOOLONG),
    ],
)
def test_file_errors_have_the_systems_number_and_reason(tmp_path, monkeypatch, racket, name, kind, number):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("")
    with pytest.raises(kind):
        open(name)  # the oracle
    for call in failing_calls(racket, name):
        with pytest.raises(kind) as caught:
            call()
        error = caught.value
        assert isinstance(error, poinsot.FileError), call
        assert (error.errno, error.strerror) == (number, os.strerror(number)), call
        assert error.filename and os.path.dirname(name) in error.filename, call


def test_an_unwritable_folder_raises_the_systems_error(racket):
    # Not even root can create a file in /proc.
    for made in (functools.partial(racket.save, "/proc/x.png"), functools.partial(racket.film, "/proc/x.mp4")):
        with pytest.raises((FileNotFoundError, PermissionError)) as caught:
            made(size=(32, 32))
        assert isinstance(caught.value, poinsot.FileError) and caught.value.filename.startswith("/proc")


def test_errors_keep_file_names_that_are_not_utf8(tmp_path, racket):
    name = os.fsdecode(os.fsencode(tmp_path) + b"/\xff/a.mp4")
    for call in (functools.partial(racket.film, name), functools.partial(poinsot.diff, name, name)):
        with pytest.raises(FileNotFoundError) as caught:
            call()
        assert caught.value.filename in (name, os.path.dirname(name))


def test_errors_of_unwritten_files_have_the_reason(tmp_path, racket):
    with pytest.raises(FileNotFoundError, match="no such folder") as caught:
        racket.film(tmp_path / "none" / "a.mp4")
    assert isinstance(caught.value, poinsot.FileError)
    (tmp_path / "a.png").write_text("a note of mine")
    with pytest.raises(FileExistsError, match="not written by poinsot; force=True replaces it") as caught:
        racket.save(tmp_path / "a.png")
    assert isinstance(caught.value, poinsot.FileError) and caught.value.filename == str(tmp_path / "a.png")
    (tmp_path / "b.png").mkdir()
    with pytest.raises(IsADirectoryError):
        racket.save(tmp_path / "b.png", size=(32, 32))
    assert racket.save(tmp_path / "a.png", force=True).read_bytes().startswith(b"\x89PNG")


def test_a_program_that_cannot_be_started_is_named_with_its_variable(tmp_path, monkeypatch, racket):
    monkeypatch.setenv("POINSOT_PROGRAM", str(tmp_path / "nothing"))
    with pytest.raises(FileNotFoundError, match=r"^POINSOT_PROGRAM=.*nothing: cannot be started") as caught:
        racket.film("a.mp4")
    assert isinstance(caught.value, poinsot.FileError)


def test_a_program_that_writes_no_file_is_reported(tmp_path, monkeypatch, racket):
    monkeypatch.setenv("POINSOT_PROGRAM", "/bin/true")
    for name in ("a.mp4", "{frame:03}.png"):
        with pytest.raises(poinsot.FileError, match="POINSOT_PROGRAM=/bin/true exited with 0 but did not write the file"):
            racket.film(tmp_path / name)


def test_exceeding_a_limit_raises_a_limit_error(tmp_path):
    with pytest.raises(poinsot.LimitError, match=r'limits=\{"frames": N\} raises the limit') as caught:
        poinsot.loads(OWN, limits={"frames": 1})
    assert isinstance(caught.value, poinsot.SceneError) and len(caught.value.problems) == 1
    with pytest.raises(poinsot.SceneError) as caught:
        poinsot.loads(OWN, {"style.theme": "no such"}, limits={"frames": 1})
    assert not isinstance(caught.value, poinsot.LimitError)  # the limit is not the only problem
    for limits, words in (({"output": 1024}, "output"), ({"memory": "1 MiB"}, "memory")):
        scene = poinsot.loads({**OWN, "time": {"duration": 0.1}}, {"output.size": [64, 36]}, limits=limits)
        with pytest.raises(poinsot.LimitError, match=rf'limits={{"{words}": \w+}} raises the limit') as caught:
            scene.film(tmp_path / f"{words}.mp4")
        assert "--" not in str(caught.value) and "poinsot:" not in str(caught.value)
    with pytest.raises(poinsot.LimitError, match=r'^size=.*limits={"side": N} raises the limit'):
        scene.render(size=(100_000, 90))


def test_a_wrong_override_is_reported_without_a_file(racket):
    with pytest.raises(poinsot.SceneError) as caught:
        racket.replace({"style.theme": "drak"})
    problem = caught.value.problems[0]
    assert (problem.file, problem.line, problem.column, problem.override) == ("", 0, 0, "style.theme")
    assert problem.message.startswith("style.theme: ")
    again = copy.deepcopy(caught.value)
    assert (str(again), again.problems) == (str(caught.value), caught.value.problems)


def test_files_with_names_that_are_not_utf8_are_read_and_written(tmp_path, racket):
    name = os.fsencode(tmp_path) + b"/\xff.toml"
    with open(name, "w") as file:
        file.write(racket.text)
    scene = poinsot.load(name)
    assert os.fsencode(scene.name) == b"\xff"
    assert pickle.loads(pickle.dumps(scene)).info() == scene.info()
    scene.save(os.fsencode(tmp_path) + b"/\xfe.png", size=(32, 32))
    assert os.path.exists(os.fsencode(tmp_path) + b"/\xfe.png")
