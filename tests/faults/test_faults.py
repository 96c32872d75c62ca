"""Whatever goes wrong: nothing received is lost, nothing wrong passes as good, and docs/faults.md says what happens."""

import re
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor

import pytest
from bench import Row
from fault_table import FAULTS, HEAD, PAGE, ROOT, line, parts, play

AT_ONCE = 4  # a fault is mostly waiting: for a port, a silence, an end
LONG = ("24 hours of frames (10 Hz, accelerated)",)


@pytest.fixture(scope="module")
def played(request: pytest.FixtureRequest) -> Iterator[dict[str, Future[Row]]]:
    """What comes of each fault that is asked for, played beside others."""
    asked = {item.callspec.params["name"] for item in request.session.items if item.name.startswith(f"{TEST}[")}
    with ThreadPoolExecutor(AT_ONCE) as pool:
        yield {name: pool.submit(play, FAULTS[name]) for name in FAULTS if name in asked}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.long) if name in LONG else name for name in FAULTS]
)
def test_a_fault_does_what_the_table_says(name, played):
    assert line(name, played[name].result()) in PAGE.read_text().splitlines(keepends=True)


TEST = test_a_fault_does_what_the_table_says.__name__


def test_the_table_has_a_line_for_every_fault_and_no_other():
    text, _ = parts(PAGE.read_text())
    assert text.startswith(HEAD)
    assert [one.split(" | ")[0].removeprefix("| ") for one in text.removeprefix(HEAD).splitlines()] == list(FAULTS)


def test_every_other_fault_names_a_test_that_is_there():
    _, rest = parts(PAGE.read_text())
    rows = [row for row in rest.splitlines() if row.startswith("| ") and not row.startswith("| what goes wrong")]
    assert len(rows) > 60
    for row in rows:
        path, _, name = re.split(r"(?<!\\)\|", row)[-2].strip().strip("`").partition("::")
        assert (ROOT / path).is_file(), row
        assert re.search(rf"^def {name}\(", (ROOT / path).read_text(), re.M) if name else path.endswith(".py"), row
