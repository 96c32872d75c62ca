"""Excel workbooks and text with several header lines, imported by the real program."""

import datetime
import zipfile

import pytest
from formats.foreign_files import imported, read_back, refused, workbook
from made_recording import recording

from pipeline.run.samples import read_samples

GOOD = recording()
NAMES = ["time", "angle", "weg"]
CHANNELS = {
    "time_s": {"column": "time"},
    "motor_turns": {"column": "angle", "unit": "deg"},
    "displacement_mm": {"column": "weg", "unit": "cm"},
}
ROWS = [[row.time_s, row.motor_turns * 360, row.displacement_mm / 10] for row in GOOD.itertuples()]
UNITS = ["s", "deg", "cm"]


@pytest.mark.parametrize(
    ("layout", "rows"),
    [
        (None, [NAMES, *ROWS]),
        ({"skip": 2, "skip_below": 1}, [["Measured by", "somebody"], [], NAMES, UNITS, *ROWS]),
        ({"comment": "#"}, [["# rig 7"], NAMES, *ROWS, [None, None, None]]),
    ],
)
def test_a_sheet_is_read_whatever_stands_above_its_numbers(tmp_path, layout, rows):
    read_back(*imported(workbook(tmp_path / "log.xlsx", first=rows), CHANNELS, layout))


@pytest.mark.parametrize("sheet", ["second", 1])
def test_a_sheet_is_chosen_by_name_or_index(tmp_path, sheet):
    file = workbook(tmp_path / "log.xlsx", first=[["nothing"], ["here"]], second=[NAMES, *ROWS])
    read_back(*imported(file, CHANNELS, {"sheet": sheet}))


def test_clock_times_of_a_sheet_count_in_seconds(tmp_path):
    start = datetime.datetime(2026, 11, 22, 10, 15)
    rows = [[start + datetime.timedelta(milliseconds=round(1e3 * row[0])), *row[1:]] for row in ROWS]
    done, folder = imported(workbook(tmp_path / "log.xlsx", first=[NAMES, *rows]), CHANNELS)
    assert done.returncode == 0, done.stderr
    time_s = read_samples(folder)[1]["time_s"].to_numpy()
    assert time_s - time_s[0] == pytest.approx(GOOD["time_s"].to_numpy(), abs=1e-3)


def torn(file):
    """A workbook whose one sheet is no XML."""
    with zipfile.ZipFile(workbook(file, first=[NAMES, *ROWS])) as book:
        parts = {name: book.read(name) for name in book.namelist()}
    with zipfile.ZipFile(file, "w") as book:
        for name, part in parts.items():
            book.writestr(name, part[:2000] if "worksheets" in name else part)


def bomb(file):
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as book:
        book.writestr("xl/worksheets/sheet1.xml", b"<row/>" * 10_000_000)


def far_cell(file):
    """A workbook whose sheet names a row that no sheet has."""
    workbook(file, first=[NAMES, *ROWS[:9]])
    with zipfile.ZipFile(file) as book:
        parts = {name: book.read(name) for name in book.namelist()}
    name = next(name for name in parts if "worksheets" in name)
    parts[name] = parts[name].replace(b'<row r="9"', b'<row r="999999999999"')
    with zipfile.ZipFile(file, "w") as book:
        for name, part in parts.items():
            book.writestr(name, part)


@pytest.mark.parametrize(
    ("make", "layout", "says"),
    [
        (lambda f: workbook(f, first=[NAMES, *ROWS]), {"sheet": "third"}, "'third' is not in the workbook, only first"),
        (lambda f: workbook(f, first=[NAMES, *ROWS]), {"sheet": 3}, "file.sheet: is 3, but the workbook has 1"),
        (lambda f: workbook(f, a=[NAMES], b=[]), {"sheet": "b"}, "sheet 'b': holds no rows"),
        (
            lambda f: workbook(f, a=[NAMES, *ROWS[:50], *[[2.0, "broken", 1.0]] * 30, *ROWS[50:]]),
            None,
            "holds 'broken', not",
        ),
        (lambda f: workbook(f, a=[NAMES, *ROWS, [*ROWS[-1], 7, 8]]), None, "a row of 5 cells"),
        (lambda f: workbook(f, a=[NAMES[:2], *(row[:2] for row in ROWS)]), None, "there is no column 'weg', only"),
        (lambda f: workbook(f, a=[["Rig 7"], NAMES, *ROWS]), None, "set file.skip to"),
        (lambda f: workbook(f, a=[NAMES, UNITS, *ROWS]), None, "set file.skip_below to 1"),
        (torn, None, "is not a readable workbook"),
        (bomb, None, "is packed more than 200-fold"),
        (far_cell, None, "has a cell beyond row 1048576"),
        (lambda f: f.write_bytes(b"PK\x03\x04" + b"x" * 100), None, "is not a readable workbook"),
        (lambda f: zipfile.ZipFile(f, "w").writestr("a.csv", "1,2"), None, "is a zip file and no Excel workbook"),
        (
            lambda f: f.write_bytes(b"\xd0\xcf\x11\xe0" + b"x" * 99),
            None,
            "an old Excel workbook, or one with a password",
        ),
    ],
)
def test_a_workbook_that_cannot_be_read_is_refused_in_words(tmp_path, make, layout, says):
    make(tmp_path / "log.xlsx")
    refused(*imported(tmp_path / "log.xlsx", CHANNELS, layout), says)


def lines(*above, delimiter=",", decimal="."):
    rows = [delimiter.join(f"{value:.9f}" for value in row).replace(".", decimal) for row in ROWS]
    return "\n".join([*(delimiter.join(names) for names in above), *rows]) + "\n"


@pytest.mark.parametrize(
    ("text", "layout"),
    [
        (lines(NAMES, delimiter="\t"), {"delimiter": "\t"}),
        (lines(NAMES, UNITS, ["-", "+", "x"], delimiter=";", decimal=","),
         {"delimiter": ";", "decimal": ",", "skip_below": 2}),
        ("Rig 7\n\n" + lines(NAMES, UNITS), {"skip": 2, "skip_below": 1}),
    ],
)  # fmt: skip
def test_text_with_several_header_lines_is_read(tmp_path, text, layout):
    (tmp_path / "log.csv").write_text(text)
    read_back(*imported(tmp_path / "log.csv", CHANNELS, layout))


@pytest.mark.parametrize(
    ("text", "layout", "says"),
    [
        (lines(NAMES, delimiter="\t"), None, 'Mend: set file.delimiter to "\\t"'),
        (lines(NAMES, UNITS), None, "Mend: set file.skip_below to 1"),
        (lines(NAMES), {"sheet": "a"}, "file.sheet: is 'a', but the file is text, which has none"),
        (lines(NAMES), {"header": False, "skip_below": 1}, "Mend: set file.skip"),
    ],
)
def test_text_with_several_header_lines_says_which_key(tmp_path, text, layout, says):
    (tmp_path / "log.csv").write_text(text)
    refused(*imported(tmp_path / "log.csv", CHANNELS, layout), says)
