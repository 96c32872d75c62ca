"""Tables: columns under one another, and no wider than a page."""

from pipeline.diagnosis.words.language.text_table import ROOM, aligned, within, wrapped_cells


def test_a_table_is_narrower_where_the_page_is_and_a_name_that_is_too_long_has_a_line_of_its_own() -> None:
    rows = [["name", "share"], ["creep", "37 %"]]
    assert aligned(rows) == ["name    share", "creep   37 %"] == within(rows, 0)
    assert aligned(rows, 11) == ["name   share", "creep  37 %"]
    long = "friction_hysteresis + " * 5 + "wear"
    lines = within([*rows, [long, "less than 1 %"]], 0)
    assert lines == ["name    share", "creep   37 %", long, "        less than 1 %"]
    edge = within([["n" * (ROOM - 6), "37 %"], ["m" * (ROOM - 5), "6 %"]], 0)
    assert edge == [f"{'n' * (ROOM - 6)}  37 %", "m" * (ROOM - 5), f"{' ' * (ROOM - 4)}6 %"]


def test_a_table_too_wide_for_a_page_goes_on_below_in_its_widest_column():
    """Its last columns stood in lines of their own, away from their heads."""
    origin = "1 (taken, after the scale of -1 that stands in the file run.yaml)"
    rows = [["dimension", "as measured", "moved by"], ["gain", origin, "0.25"], ["radius", "0.4 mm", "2.2" * 14]]
    lines = wrapped_cells(rows)
    assert max(map(len, lines)) <= ROOM < len(aligned(rows)[2]), lines
    at = lines[0].index("moved by")
    assert lines[1][at:] == "0.25" and "taken" in lines[1] and lines[2].strip() == "run.yaml)", lines
    assert lines[3].startswith("radius") and len(lines) == 4
    assert wrapped_cells(rows[:1]) == aligned(rows[:1])
