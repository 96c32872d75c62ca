"""Whatever goes wrong: nothing received is lost, nothing wrong passes as good, and docs/faults.md says what happens."""

import re

import pytest
from fault_table import FAULTS, HEAD, PAGE, ROOT, line, parts, play

LONG = ("24 hours of frames (10 Hz, accelerated)",)


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.long) if name in LONG else name for name in FAULTS]
)
def test_a_fault_does_what_the_table_says(name):
    assert line(name, play(FAULTS[name])) in PAGE.read_text().splitlines(keepends=True)


def test_the_table_has_a_line_for_every_fault_and_no_other():
    text, _ = parts(PAGE.read_text())
    assert text.startswith(HEAD)
    assert [row.split(" | ")[0].removeprefix("| ") for row in text.removeprefix(HEAD).splitlines()] == list(FAULTS)


def test_every_other_fault_names_a_test_that_is_there():
    _, rest = parts(PAGE.read_text())
    rows = [row for row in rest.splitlines() if row.startswith("| ") and not row.startswith("| what goes wrong")]
    assert len(rows) > 60
    for row in rows:
        path, _, name = re.split(r"(?<!\\)\|", row)[-2].strip().strip("`").partition("::")
        assert (ROOT / path).is_file(), row
        assert re.search(rf"^def {name}\(", (ROOT / path).read_text(), re.M) if name else path.endswith(".py"), row
