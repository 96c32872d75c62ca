"""The sizes of one effect, told apart."""

from made_content import confident, content, page, told


def test_the_details_say_how_to_read_the_sizes_of_one_effect() -> None:
    read = "Sizes of one effect: rms is its usual size over the whole recording"
    largest = f"{read}; after `up to` stands its largest one"
    none = content()
    none["mechanisms"], none["alternatives"] = none["mechanisms"][:1], []
    assert largest in told() and read in told(none) and "up to`" not in told(none), "it has no `up to`"
    assert read in told() and "the last column is" not in told() and read not in page()
    assert "the last column is the rms, over the whole recording, of the part that no wrong" in told(
        content(evidence__beyond_dimensions_mm={"creep": 0.1})
    )


def test_every_size_says_of_which_explanation_it_is() -> None:
    text = told()
    assert text.count("All hold if friction_hysteresis + creep is right.") == 1
    assert "this explanation" not in text.partition("What the words mean")[0]


def test_a_wide_table_of_effects_breaks_no_line() -> None:
    own = {"evidence__beyond_dimensions_mm": {"friction_hysteresis": 0.01, "creep": 0.01}, "evidence__moved_sigma": {}}
    diagnosis = confident(0.997, 0.996, verdict="explained", alternatives=[], next_run=None, **own)
    diagnosis["mechanisms"][0]["rms_mm"] = {"value": 0.082, "low": 0.0123, "high": 0.123}
    rows = page(diagnosis).splitlines()
    at = next(at for at, line in enumerate(rows) if line.startswith("  effect "))
    head, below = rows[at : at + 2]
    assert head.endswith("  its own part") and len(head) <= 112 and below.startswith("  friction_hysteresis "), (
        "a head of many words broke over four lines where a page is narrow"
    )
    assert any(row.startswith("  Its own part is the part that no wrong dimension can make.") for row in rows), rows
    assert "part that no wrong dimension can make" in page(confident(0.9, 0.9, **own))
