"""Tables: columns under one another, and no wider than a page."""

from pipeline.diagnosis.words.language.table import ROOM, aligned, within


def test_a_table_is_narrower_where_the_page_is_and_a_name_that_is_too_long_has_a_line_of_its_own() -> None:
    rows = [["name", "share"], ["creep", "37 %"]]
    assert aligned(rows) == ["name    share", "creep   37 %"] == within(rows, 0)
    assert aligned(rows, 11) == ["name   share", "creep  37 %"]
    long = "friction_hysteresis + " * 5 + "wear"
    lines = within([*rows, [long, "less than 1 %"]], 0)
    assert lines == ["name    share", "creep   37 %", long, "        less than 1 %"]
    edge = within([["n" * (ROOM - 6), "37 %"], ["m" * (ROOM - 5), "6 %"]], 0)
    assert edge == [f"{'n' * (ROOM - 6)}  37 %", "m" * (ROOM - 5), f"{' ' * (ROOM - 4)}6 %"]
