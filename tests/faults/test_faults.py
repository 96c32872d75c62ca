"""Whatever goes wrong: nothing received is lost, nothing wrong passes as good, and docs/faults.md says what happens."""

import pytest
from fault_table import FAULTS, HEAD, PAGE, line, play


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_does_what_the_table_says(name):
    assert line(name, play(FAULTS[name])) in PAGE.read_text().splitlines(keepends=True)


def test_the_table_has_a_line_for_every_fault_and_no_other():
    text = PAGE.read_text()
    assert text.startswith(HEAD)
    assert [one.split(" | ")[0].removeprefix("| ") for one in text.removeprefix(HEAD).splitlines()] == list(FAULTS)
