# SPDX-License-Identifier: Apache-2.0
"""Runs every row of "The lecture, row by row" in docs/physics.md, and compares its results with the numbers that the row
states. The lecture's path in docs/gallery.md must show, at each step, the scenes of the rows that it names. Planted
faults show that the check finds a wrong row, and a wrong step of the path.

    lecture_test.py PROGRAM

docs/testing.md describes the form of a row.
"""
import concurrent.futures
import decimal
import functools
import itertools
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unicodedata
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
PAGE, GALLERY = ROOT / "docs/physics.md", ROOT / "docs/gallery.md"
NOTEBOOK = ROOT / "python/notebooks/lecture15.ipynb"
SECTION = "## The lecture, row by row\n"
COUNTS = {"Eq": 40, "Figure": 4, "Claim": 30}
MOST_IN_WORDS = 8
KINDS = {"Result", "Scene", "Code", "Test", "In words only"}
FEWEST_DIGITS = 3  # a number with fewer would show little
LONGEST_S = 60  # of one command

# Rows whose command does not yet show all that the lecture says, each with what is missing. Make this list empty.
PENDING = {}

NUMBER = r"[-−]?\d+(?:\.\d+)?(?:e-?\d+)?"
RESULT = re.compile(rf"""(?:[Aa]t\ (?:t\ =\ (?P<t>{NUMBER})\ s|(?P<always>every\ time)),\ )?
    `(?P<key>\w+)(?P<places>(?:\[\d\])*)`\ is\ (?:(?P<numbers>{NUMBER}|\({NUMBER}(?:,\ {NUMBER})+\))(?:\ (?P<unit>[^`]+))?
    |`(?P<word>\w+)`)\.$""", re.X)
LINK = re.compile(r"\]\(([^)#]+)\)")
SCENE = re.compile(r"scenes/(\w+)\.toml")

PATH = "## The lecture in its own order\n"
TABLE = "## Which scene draws which equation\n"
NAMED = re.compile(r"(?:(Eq|Figure|Claim)s? )?(\d+)(?: to (\d+))?")  # "Claims 15", "19" or "Eq 27 to 29"


class Fault(Exception):
    """A problem of a row."""


class Command:
    """A command of a row, with its results and the paragraphs down to it."""

    def __init__(self, words, paragraphs):
        self.words, self.paragraphs, self.results = words, paragraphs, []
        self.scenes = set(SCENE.findall(words))


class Row:
    """One row: its name, the heading above it, paragraphs, commands and items."""

    def __init__(self, text, heading=None):
        self.heading = heading
        self.name, self.title = re.match(r"(\w+ \d+): (.+)", text).groups()
        self.commands, self.items, self.paragraphs, self.lines = [], {}, [], 0
        self.early = []  # results before the first command, which belong to no command
        for block in re.split(r"\n\n+", text.partition("\n")[2].strip("\n")):
            if block.startswith("    ./poinsot "):
                for words in re.findall(r"^    \./(poinsot .+)$", block, re.M):
                    self.commands.append(Command(words, list(self.paragraphs)))
            elif block.startswith("- **"):
                self.add_items(block)
            elif block.strip():
                self.paragraphs.append(block)

    def add_items(self, block):
        self.lines += len(re.findall(r"^- ", block, re.M))
        for kind, words in re.findall(r"^- \*\*(.+?):\*\* (.+(?:\n  .+)*)", block, re.M):
            self.items.setdefault(kind, []).append(re.sub(r"\s+", " ", words))
            if kind == "Result":
                (self.commands[-1].results if self.commands else self.early).append(self.items[kind][-1])

    def links(self, kind):
        return [link for words in self.items.get(kind, []) for link in LINK.findall(words)]

    def only_in_words(self):
        return "In words only" in self.items


def section(page, heading):
    _, found, rest = page.partition(heading)
    return re.split(r"^## ", rest, maxsplit=1, flags=re.M)[0] if found else ""


def parts(text):
    """Returns the parts of a section: the heading, and the text below it."""
    return [part.partition("\n")[::2] for part in re.split(r"^### ", text, flags=re.M)[1:]]


def rows(page):
    return [Row(text, heading) for heading, part in parts(section(page, SECTION))
            for text in re.split(r"^#### ", part, flags=re.M)[1:]]


def problems_of_list(found):
    """Returns what is wrong with the list of rows: each kind is numbered from 1, and in order."""
    for kind, count in COUNTS.items():
        numbers = [int(row.name.split()[1]) for row in found if row.name.split()[0] == kind]
        if numbers != list(range(1, count + 1)):
            yield f"{kind}: expected 1 to {count} in order, and found {numbers}"
    if len(found) != sum(COUNTS.values()):
        yield f"expected {sum(COUNTS.values())} rows, and found {len(found)}"
    if (count := sum(row.only_in_words() for row in found)) > MOST_IN_WORDS:
        yield f"{count} rows are in words only, more than {MOST_IN_WORDS}"


class Step:
    """One step of the gallery's path: its heading, its scenes, and the names of the rows that it shows."""

    def __init__(self, heading, cells):
        self.heading, self.shown, self.scenes = heading, cells[0], SCENE.findall(cells[0])
        self.names = list(names_of_rows(cells[-1]))

    def __str__(self):
        return f"the step {', '.join(self.scenes) or self.shown}"

    def is_linked(self):
        return self.shown == ", ".join(f"[{scene}](../scenes/{scene}.toml)" for scene in self.scenes)


def names_of_rows(cell):
    """Returns the rows that a cell names: Eq 1, Eq 3, Eq 4 and Claim 7 for "Eq 1, 3 to 4, Claim 7"."""
    kind = None
    for named in cell.split(", "):
        if not (match := NAMED.fullmatch(named)) or not (kind := match[1] or kind):
            raise Fault(f"the path has {named!r} instead of rows, such as Claims 1, 2, Eq 3 to 5")
        yield from (f"{kind} {number}" for number in range(int(match[2]), int(match[3] or match[2]) + 1))


def steps(gallery):
    return [Step(heading, [cell.strip() for cell in line.strip("|").split("|")])
            for heading, part in parts(section(gallery, PATH)) for line in re.findall(r"^\|.+", part, re.M)[2:]]


def problems_of_path(gallery, found):
    """Returns what is wrong with the path: each step names rows, each row has a command with a scene of each step that
    names it, and is first named below its own heading. The rows in words only are named above the first step."""
    by_name, first = {row.name: row for row in found}, {}
    in_words = {row.name for row in found if row.only_in_words()}
    for step in steps(gallery):
        if not step.is_linked():
            yield f"{step} is not a list of links to scenes: {step.shown}"
        for name in step.names:
            first.setdefault(name, step)
            if name not in by_name or name in in_words:
                yield f"{step} names {name}, which is not a row with a command"
            elif not any(command.scenes & set(step.scenes) for command in by_name[name].commands):
                yield f"{step} names {name}, which has no command with this scene"
    for row in found:
        if row.name in first:
            yield from problems_of_first(first[row.name], row)
        elif row.name not in in_words:
            yield f"the path does not name {row.name}"
    said = re.search(r"((?:\w+ \d+(?:, | and )?)+) have no scene\.", section(gallery, PATH))
    if not said or set(re.findall(r"\w+ \d+", said[1])) != in_words:
        yield f"the path must say that {sorted(in_words)} have no scene"
    if {heading for heading, _ in parts(section(gallery, PATH))} != {row.heading for row in found}:
        yield "the path's headings differ from those of the rows"
    yield from problems_of_table(gallery, first)


def problems_of_first(step, row):
    if step.heading != row.heading:
        yield f"{step} below {step.heading!r} is the first to name {row.name}, which belongs to {row.heading!r}"
    if row.commands and not row.commands[0].scenes & set(step.scenes):
        yield f"{step} is the first to name {row.name}, whose first command has another scene"


def problems_of_table(gallery, first):
    """Returns which equations of the table lack the scene by which the path shows them first."""
    for begin, end, line in re.findall(r"^\| (\d+)(?:–(\d+))? \| (.+)$", section(gallery, TABLE), re.M):
        for name in (f"Eq {number}" for number in range(int(begin), int(end or begin) + 1)):
            if name in first and not set(SCENE.findall(line)) & set(first[name].scenes):
                yield f"the table of equations lacks {first[name]} of {name}"


def rows_of_notebook(cells):
    """Returns pairs of the rows that a text names, such as "**Eq 20.** The axis precesses", and the code up to the next."""
    pairs = []
    for cell in cells:
        text = "".join(cell["source"])
        if cell["cell_type"] == "code":
            if pairs:
                pairs[-1][1] += text + "\n"
        elif names := re.findall(r"^\*\*(\w+ \d+)\.\*\*", text, re.M):
            pairs.append([names, ""])
    return pairs


def problems_of_notebook(cells, found):
    """Returns what is wrong with the notebook: it compares each row that can be computed, once and in order."""
    pairs = rows_of_notebook(cells)
    named = [name for names, _ in pairs for name in names]
    everything, expected = [row.name for row in found], [row.name for row in found if not row.only_in_words()]
    if missing := [name for name in expected if name not in named]:
        yield f"the notebook does not name {', '.join(missing)}"
    if unknown := [name for name in named if name not in everything]:
        yield f"the notebook names {', '.join(unknown)}, which the page lacks"
    for before, name in itertools.pairwise(name for name in named if name in everything):
        if everything.index(before) >= everything.index(name):
            yield f"the notebook names {name} after {before}"
    for names, code in pairs:
        if not re.search(r"^ *assert ", code, re.M):
            yield f"the notebook compares nothing for {', '.join(names)}"


def half_unit(text):
    """Returns half a unit of the last digit of a number as written: 0.005 for 2.45, 0.5e-6 for 1.57e-4."""
    return decimal.Decimal(5).scaleb(decimal.Decimal(text).as_tuple().exponent - 1)


def digits(text):
    return len(re.sub(r"e.*|\D", "", text).lstrip("0"))


def not_worked_out(command):
    """Returns the numbers of a command's results that the paragraphs do not contain, up to the sign and the last digits."""
    plain = " ".join(command.paragraphs).replace("−", "-")
    worked = [text.lstrip("-") for text in re.findall(NUMBER, plain) if digits(text) >= FEWEST_DIGITS]
    for words in command.results:
        if not (match := RESULT.match(words)) or match["word"]:
            continue
        for stated in re.findall(NUMBER, match["numbers"]):
            size = stated.lstrip("-−")
            if float(size) and not any(abs(decimal.Decimal(each) - decimal.Decimal(size)) <= max(half_unit(each), half_unit(size))
                                       for each in worked):
                yield f"the paragraphs do not work out {stated} of `{match['key']}`"


def agrees(stated, value):
    if digits(stated) < FEWEST_DIGITS and (float(stated) or "." not in stated):
        raise Fault(f"{stated} has fewer than {FEWEST_DIGITS} digits")
    return abs(decimal.Decimal(value) - decimal.Decimal(stated)) <= half_unit(stated)


def compare(result, value, unit):
    """Compares a value with a result's number, numbers or word, and its unit with the result's."""
    if result["word"]:
        expected, equal = result["word"], json.dumps(value).strip('"') == result["word"]
    else:
        expected = result["numbers"].replace("−", "-")
        stated = expected.strip("()").split(", ")
        values = value if isinstance(value, list) else [value]
        if not all(isinstance(each, (int, float)) for each in values):
            raise Fault(f"`{result['key']}` is {value}, not {expected}")
        equal = len(stated) == len(values) and all(map(agrees, stated, values))
    if not equal:
        raise Fault(f"`{result['key']}` is {value}, not {expected}")
    if (result["unit"] or "").replace("²", "^2") != unit:
        raise Fault(f"`{result['key']}` is in {unit or 'no unit'}, not in {result['unit'] or 'no unit'}")


def normal(text):
    """Returns a text in which each letter with an accent is written in one way, and spaces between words are single."""
    return re.sub(" +", " ", unicodedata.normalize("NFC", text)).strip()


class Run:
    """A row's command, run in a folder of its own that has the scenes."""

    def __init__(self, command, folder):
        self.folder = pathlib.Path(folder)
        (self.folder / "scenes").symlink_to(ROOT / "scenes")
        (self.folder / "out").mkdir()
        self.words = shlex.split(command)[1:]
        self.out = self.run(self.words)

    def run(self, words):
        run = subprocess.run([PROGRAM, *words], cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=LONGEST_S)
        if run.returncode:
            raise Fault(f"exit code {run.returncode}: {run.stderr.strip()}")
        return run.stdout

    @functools.cached_property
    def info(self):
        return json.loads(self.out)

    @functools.cached_property
    def table(self):
        """Returns units, and rows by time, of a trajectory: the same columns as in the output, from a JSON file."""
        self.run([*self.words, "-o", "out/table.json"])
        table = json.loads((self.folder / "out/table.json").read_text())
        named = [dict(zip(table["columns"], values)) for values in table["rows"]]
        if self.out.split()[0].split(",") != table["columns"] or len(self.out.split()) != len(named) + 1:
            raise Fault("the CSV output differs from the JSON file")
        return table["units"], {row["t"]: row for row in named}

    def labels(self):
        pictures = list(self.folder.glob("out/*.svg"))
        if len(pictures) != 1:
            raise Fault("the command writes no picture out/NAME.svg")
        texts = xml.etree.ElementTree.parse(pictures[0]).iter("{http://www.w3.org/2000/svg}text")
        return {normal("".join(text.itertext())) for text in texts}

    def check(self, words):
        if match := re.fullmatch(r'The output contains "(.+)"\.', words):
            if match[1] not in re.sub(r"\s+", " ", self.out):
                raise Fault(f"the output does not contain {match[1]!r}")
        elif words.startswith("The picture has the label"):
            if missing := set(re.findall(r'"(.+?)"', normal(words))) - self.labels():
                raise Fault(f"the picture lacks the labels {sorted(missing)}")
        elif not (match := RESULT.match(words)):
            raise Fault(f"unknown form of a result: {words}")
        elif match["t"] or match["always"]:
            self.check_column(match)
        else:
            self.check_key(match)

    def check_key(self, match):
        value, unit = self.info.get(match["key"]), self.info["units"].get(match["key"], "")
        for place in re.findall(r"\d", match["places"]):
            value = value[int(place)]
        compare(match, value, unit)

    def check_column(self, match):
        units, by_time = self.table
        times = [float(match["t"].replace("−", "-"))] if match["t"] else list(by_time)
        for t in times:
            if t not in by_time or match["key"] not in by_time[t]:
                raise Fault(f"the table has no {match['key']} at t = {t} s")
            compare(match, by_time[t][match["key"]], {"1": ""}.get(units[match["key"]], units[match["key"]]))


def problems_of_form(row):
    """Returns what a row lacks, and which of its links lead nowhere."""
    if not row.paragraphs:
        yield "no paragraph"
    if row.lines != sum(map(len, row.items.values())) or set(row.items) - KINDS:
        yield f"items are not of the kinds {sorted(KINDS)}"
    for kind in row.items:
        for link in row.links(kind):
            if "://" not in link and not (PAGE.parent / link).exists():
                yield f"{kind}: {link} is missing"
    if row.only_in_words():
        if set(row.items) != {"In words only"} or row.commands:
            yield "a row in words only has no command and no results"
        return
    if not row.commands:
        yield "no command"
    elif row.early:
        yield f"a result before the first command: {row.early[0]}"
    for command in row.commands:
        yield from not_worked_out(command)
        if not command.results:
            yield f"{command.words}: no Result below this command"
    yield from (f"no {kind}" for kind in ("Result", "Scene", "Test") if kind not in row.items)
    for scene in row.links("Scene"):
        picture = f"images/gallery/{pathlib.Path(scene).stem}.png"
        if not (PAGE.parent / picture).exists() or f"]({scene})" not in GALLERY.read_text():
            yield f"{scene} has no picture in the gallery"
    for command in row.commands:
        yield from (f"scenes/{scene}.toml is not among the row's scenes" for scene in sorted(command.scenes)
                    if f"../scenes/{scene}.toml" not in row.links("Scene"))


def problems_of_command(command):
    with tempfile.TemporaryDirectory() as folder:
        try:
            run = Run(command.words, folder)
            for words in command.results:
                run.check(words)
        except (Fault, subprocess.TimeoutExpired, ValueError, OSError, LookupError, TypeError) as fault:
            yield str(fault)


def problems(row):
    found = list(problems_of_form(row))
    if not found:
        found = [problem for command in row.commands for problem in problems_of_command(command)]
    return [f"{row.name}: {problem}" for problem in found]


class TheLecture(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.page = PAGE.read_text()

    def test_has_every_row_once_and_in_order(self):
        self.assertEqual(list(problems_of_list(rows(self.page))), [])

    def test_shows_in_every_row_what_the_row_states(self):
        found = rows(self.page)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            self.assertEqual([problem for each in pool.map(problems, found) for problem in each], [])
        print(f"{len(found)} rows, {sum(row.only_in_words() for row in found)} in words only, {len(PENDING)} pending", file=sys.stderr)

    def test_lists_only_rows_as_pending(self):
        self.assertEqual(set(PENDING) - {row.name for row in rows(self.page)}, set())

    def test_names_the_rows_in_words_only(self):
        names = [row.name for row in rows(self.page) if row.only_in_words()]
        said = re.search(r"in words only, because .*?:(.*?)\.", section(self.page, SECTION), re.S)[1]
        self.assertEqual(re.findall(r"\w+ \d+", said), names)

    def test_shows_every_row_in_the_path_of_the_gallery_by_the_scene_of_its_command(self):
        self.assertEqual(list(problems_of_path(GALLERY.read_text(), rows(self.page))), [])

    def test_has_every_row_that_can_be_computed_in_the_notebook(self):
        self.assertEqual(list(problems_of_notebook(json.loads(NOTEBOOK.read_text())["cells"], rows(self.page))), [])


class PlantedFaults(unittest.TestCase):
    """Each fault is planted in the page as it is, and must be found in its row."""

    def fault_of(self, name, old, new):
        text = PAGE.read_text()
        begin = text.index(f"#### {name}: ")
        end = begin + re.search(r"\n##+ ", text[begin:]).start()
        self.assertIn(old, text[begin:end])
        changed = text[:begin] + text[begin:end].replace(old, new) + text[end:]
        row, = (row for row in rows(changed) if row.name == name)
        return problems(row)

    def test_wrong_numbers_are_found(self):
        self.assertRegex(self.fault_of("Eq 20", "2.45012", "2.45013")[0], r"Eq 20: `precession_rate` is 2\.4501\d+, not 2\.45013")
        self.assertRegex(self.fault_of("Eq 5", "(0.0000, 2.2400", "(0.0000, 2.2402")[0], "`L_orbital_W` is")
        self.assertRegex(self.fault_of("Claim 9", "0.695945", "0.695955")[0], "`theta` is 0.69594")
        self.assertRegex(self.fault_of("Claim 30", "`unstable`", "`neutral`")[0], "is unstable, not neutral")

    def test_a_wrong_number_of_a_second_command_is_found(self):
        self.assertRegex(self.fault_of("Eq 20", "1.959215", "1.959225")[0], r"Eq 20: `wobbles_per_turn` is 1\.95921\d+, not 1\.959225")

    def test_a_command_without_a_result_is_found(self):
        self.assertEqual(self.fault_of("Claim 17", "- **Result:** `body_precession_rate` is 2.395130e-7 rad/s.\n", ""),
                         ["Claim 17: poinsot info scenes/chandler_wobble.toml --json: no Result below this command"])

    def test_a_number_that_is_not_worked_out_is_found(self):
        self.assertEqual(self.fault_of("Eq 20", "`precession_rate` is 2.45012", "`omega` is 3.827806"),
                         ["Eq 20: the paragraphs do not work out 3.827806 of `omega`"])

    def test_an_unknown_item_is_found(self):
        self.assertRegex(self.fault_of("Eq 5", "- **Result:** `L_total_W`", "- **Results:** `L_total_W`")[0], "items are not of the kinds")

    def test_a_wrong_unit_is_found(self):
        self.assertEqual(self.fault_of("Eq 20", "is 2.45012 rad/s.\n", "is 2.45012 deg/s.\n"), ["Eq 20: `precession_rate` is in rad/s, not in deg/s"])

    def test_too_few_digits_are_found(self):
        self.assertEqual(self.fault_of("Eq 20", "is 2.45012 rad/s.\n", "is 2.5 rad/s.\n"), ["Eq 20: 2.5 has fewer than 3 digits"])

    def test_a_missing_label_and_text_are_found(self):
        self.assertEqual(self.fault_of("Figure 3", '"ω_p"', '"Ω_q"'), ["Figure 3: the picture lacks the labels ['Ω_q']"])
        self.assertRegex(self.fault_of("Claim 11", "once in 2.56 s", "once in 2.57 s")[0], "the output does not contain")

    def test_a_missing_file_is_found(self):
        self.assertEqual(self.fault_of("Eq 24", "../scenes/tennis_racket.toml", "../scenes/no_such.toml"),
                         ["Eq 24: Scene: ../scenes/no_such.toml is missing", "Eq 24: ../scenes/no_such.toml has no picture in the gallery"])
        self.assertEqual(self.fault_of("Eq 20", "equations_18_21_test.cpp", "no_such_test.cpp"),
                         ["Eq 20: Test: ../tests/physics/no_such_test.cpp is missing"])
        self.assertEqual(self.fault_of("Eq 20", "scenes/football.toml --json", "scenes/no_such.toml --json"),
                         ["Eq 20: scenes/no_such.toml is not among the row's scenes"])

    def test_a_scene_that_cannot_be_read_is_found(self):
        self.assertRegex(self.fault_of("Eq 20", "football.toml --json", "football.toml -D body.mass=-1 --json")[0], "Eq 20: exit code 2: ")

    def test_a_missing_key_or_command_is_found(self):
        self.assertEqual(self.fault_of("Eq 20", "`wobbles_per_turn`", "`wobbles`"), ["Eq 20: `wobbles` is None, not 1.959215"])
        self.assertRegex(self.fault_of("Claim 9", "`theta`", "`thetas`")[0], "the table has no thetas at t = 0")
        self.assertRegex(self.fault_of("Eq 20", "./poinsot info", "./poinsot infos")[0], "exit code 2")
        self.assertEqual(self.fault_of("Eq 18", "    ./poinsot", "    # ./poinsot"), ["Eq 18: no command"])

    def test_a_result_before_the_first_command_is_found(self):
        self.assertEqual(self.fault_of("Eq 18", "    ./poinsot", "- **Result:** `L` is 1 m.\n\n    ./poinsot"),
                         ["Eq 18: a result before the first command: `L` is 1 m."])

    def test_a_missing_or_misplaced_row_is_found(self):
        text = PAGE.read_text()
        begin = text.index("#### Eq 20: ")
        end = text.index("#### ", begin + 1)
        self.assertEqual(list(problems_of_list(rows(text[:begin] + text[end:])))[-1], "expected 74 rows, and found 73")
        self.assertRegex(list(problems_of_list(rows(text.replace("#### Eq 20: ", "#### Eq 41: "))))[0], "^Eq: expected 1 to 40 in order")

    def fault_of_notebook(self, old, new):
        cells = json.loads(NOTEBOOK.read_text())["cells"]
        self.assertTrue(any(old in "".join(cell["source"]) for cell in cells))
        for cell in cells:
            cell["source"] = "".join(cell["source"]).replace(old, new)
        return list(problems_of_notebook(cells, rows(PAGE.read_text())))

    def test_a_row_missing_in_the_notebook_is_found(self):
        self.assertEqual(self.fault_of_notebook("**Eq 20.**", "Eq 20."), ["the notebook does not name Eq 20"])

    def test_an_unknown_row_of_the_notebook_is_found(self):
        self.assertEqual(self.fault_of_notebook("**Eq 40.**", "**Eq 40.**\n\n**Eq 41.**"),
                         ["the notebook names Eq 41, which the page lacks"])

    def test_a_row_that_the_notebook_repeats_or_misplaces_is_found(self):
        self.assertEqual(self.fault_of_notebook("**Eq 20.**", "**Eq 20.**\n\n**Eq 20.**"), ["the notebook names Eq 20 after Eq 20"])
        self.assertEqual(self.fault_of_notebook("**Eq 9.**", "**Claim 5.**")[:2],
                         ["the notebook does not name Eq 9", "the notebook names Claim 5 after Claim 5"])

    def test_a_row_that_the_notebook_does_not_compare_is_found(self):
        self.assertIn("the notebook compares nothing for Claim 29", self.fault_of_notebook("assert error(", "print(error("))

    def test_too_many_rows_in_words_only_are_found(self):
        text = re.sub(r"- \*\*Result:\*\*", "- **In words only:**", PAGE.read_text())
        self.assertRegex(list(problems_of_list(rows(text)))[-1], "rows are in words only, more than 8")


class PlantedFaultsOfThePath(unittest.TestCase):
    """Each fault is planted in the path of the gallery as it is, or in a row."""

    def faults(self, old, new, page_old="", page_new=""):
        gallery, page = GALLERY.read_text(), PAGE.read_text()
        self.assertIn(old, gallery)
        self.assertIn(page_old, page)
        return list(problems_of_path(gallery.replace(old, new), rows(page.replace(page_old, page_new))))

    def test_a_missing_row_is_found(self):
        self.assertEqual(self.faults("Eq 13, Claim 7", "Eq 13"), ["the path does not name Claim 7"])
        self.assertEqual(self.faults("Eq 15 to 17, Claim 8", "Eq 15, 17, Claim 8"), ["the path does not name Eq 16"])
        self.assertEqual(self.faults("Figure 4, ", ""), ["the path does not name Figure 4"])

    def test_an_unknown_row_is_found(self):
        self.assertEqual(self.faults("| Claim 29 |", "| Claims 29, 31 |"),
                         ["the step poinsot_symmetric names Claim 31, which is not a row with a command"])
        self.assertEqual(self.faults("| Claim 1, Eq 1 |", "| Claims 1, 2, Eq 1 |"),
                         ["the step thrown_hammer names Claim 2, which is not a row with a command"])

    def test_unreadable_names_are_found(self):
        for cell, named in (("Eq. 13", "Eq. 13"), ("Eq 13–14", "Eq 13–14"), ("7", "7"), ("", "")):
            with self.assertRaisesRegex(Fault, f"^the path has {named!r} instead of rows"):
                self.faults("| Eq 13, Claim 7 |", f"| {cell} |")

    def test_another_scene_at_a_step_is_found(self):
        self.assertEqual(self.faults("| [sphere](../scenes/sphere.toml) | A", "| [football](../scenes/football.toml) | A"),
                         ["the step football names Claim 12, which has no command with this scene",
                          "the step football is the first to name Claim 12, whose first command has another scene"])

    def test_a_step_without_its_link_is_found(self):
        self.assertEqual(self.faults("| [sphere](../scenes/sphere.toml) | A", "| sphere | A")[0],
                         "the step sphere is not a list of links to scenes: sphere")
        self.assertEqual(self.faults("| [sphere](../scenes/sphere.toml) | A", "| [ball](../scenes/sphere.toml) | A"),
                         ["the step sphere is not a list of links to scenes: [ball](../scenes/sphere.toml)"])

    def test_a_later_step_with_another_scene_is_found(self):
        self.assertEqual(self.faults("| [frisbee](../scenes/frisbee.toml) | Count", "| [sphere](../scenes/sphere.toml) | Count"),
                         ["the step sphere names Eq 20, which has no command with this scene"])

    def test_a_command_with_another_scene_is_found(self):
        command = "./poinsot info scenes/football_two_views.toml --json"
        self.assertEqual(self.faults("", "", command, "./poinsot info scenes/football.toml --json"),
                         ["the step football_two_views names Claim 17, which has no command with this scene"])

    def test_commands_in_another_order_than_the_steps_are_found(self):
        both = "| Eq 18 |", "| Eq 18 |\n| [frisbee](../scenes/frisbee.toml) | Count. | Eq 20 |"
        self.assertEqual(self.faults(*both)[0], "the step frisbee is the first to name Eq 20, whose first command has another scene")

    def test_a_row_below_another_heading_is_found(self):
        self.assertEqual(self.faults("| Eq 10 |", "| Claim 5, Eq 10 |"), [])
        self.assertEqual(self.faults("| Eq 5 |", "| Eq 5, 10 |"), ["the step thrown_baton below 'Reference point moving with body' is "
                                                                  "the first to name Eq 10, which belongs to 'Kinetic energy'"])
        self.assertIn("the path's headings differ from those of the rows", self.faults("### Kinetic energy", "### Energy"))

    def test_a_wrong_list_of_rows_without_a_scene_is_found(self):
        self.assertEqual(self.faults("Claim 2 and Claim 20 have no scene", "Claim 2 and Claim 21 have no scene"),
                         ["the path must say that ['Claim 2', 'Claim 20'] have no scene"])

    def test_a_table_without_the_scene_of_the_path_is_found(self):
        line = "| 19 | ω lies in the plane of L and k | [precession_frame](../scenes/precession_frame.toml)"
        self.assertEqual(self.faults(line, line.replace("precession_frame", "sphere")),
                         ["the table of equations lacks the step precession_frame of Eq 19"])


if __name__ == "__main__":
    unittest.main()
