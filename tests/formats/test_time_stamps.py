"""Time stamps written as dates or times of day: every usual way of writing them, past midnight, and what is none."""

import numpy as np
import pandas as pd
import pytest

from pipeline.formats.time_stamps import holds_stamps, is_stamp, stamps_s


def read(*stamps: str | None) -> list[float]:
    """Seconds from the first stamp."""
    return stamps_s(pd.Series(list(stamps), dtype=object)).tolist()


@pytest.mark.parametrize(
    "stamp",
    [
        "2026-11-23 10:30:00.25",
        "2026-11-23T10:30:00.250",
        "2026-11-23T10:30:00.250Z",
        "2026/11/23 10:30:00,250",
        "23.11.2026 10:30:00,25",
        "23/11/2026 10:30:00.25",
        "11/23/2026 10:30:00.25 AM",
        " 10:30:00.25 ",
        "10:30:00.25 am",
    ],
)
def test_usual_stamps_are_read_to_the_fraction_of_a_second(stamp):
    assert is_stamp(stamp)
    assert read(stamp.replace(":30:", ":29:"), stamp.replace(".25", ".75").replace(",25", ",75")) == [
        0.0,
        pytest.approx(60.5, abs=1e-9),
    ]


def test_afternoon_and_noon_and_midnight_of_twelve_hours():
    assert read("12:00:00 AM", "12:00:00 PM", "01:00:00 pm") == [0.0, 43200.0, 46800.0]


def test_a_zone_is_taken_off():
    assert np.diff(read("2026-10-25T02:59:59+02:00", "2026-10-25T02:00:00+01:00")).tolist() == [1.0]
    assert np.diff(read("2026-03-29T01:59:59-0330", "2026-03-29T05:30:00Z")).tolist() == [1.0]


@pytest.mark.parametrize(
    "stamps",
    [
        ("23:59:59.5", "00:00:00.5"),
        ("2026-12-31 23:59:59.5", "2027-01-01 00:00:00.5"),
        ("03.04.2026 23:59:59.5", "04.04.2026 00:00:00.5"),
        ("04/03/2026 23:59:59.5", "04/04/2026 00:00:00.5"),
        ("01/31/2026 23:59:59.5", "02/01/2026 00:00:00.5"),
    ],
)
def test_midnight_is_passed_in_one_second_whichever_stands_first_of_day_and_month(stamps):
    assert np.diff(read(*stamps)).tolist() == [1.0]


def test_a_stamp_that_falls_back_a_little_is_left_for_the_mending_of_clocks():
    assert np.diff(read("10:30:02", "10:30:01")).tolist() == [-1.0]


@pytest.mark.parametrize("cell", ["1.5", "2026-11-23", "10:30", "10:61:00", "", "10:30:00 o'clock", None, 3.5])
def test_what_is_no_stamp_is_told(cell):
    assert not is_stamp(cell)
    assert np.isnan(read(cell if isinstance(cell, str) else None)[0])


def test_a_day_that_no_calendar_has_is_no_stamp():
    assert np.isnan(read("2026-02-28 10:30:00", "2026-02-30 10:30:00")[1])


def test_an_empty_cell_between_times_of_day_hides_no_midnight():
    assert read("23:59:59", None, "00:00:01")[::2] == [0.0, 2.0]


def test_columns_of_dates_and_durations_are_read_too():
    stamps = pd.Series(pd.to_datetime(["2026-11-23 23:59:59.5", "2026-11-24 00:00:00.5"]))
    assert stamps_s(stamps).tolist() == stamps_s(stamps.dt.tz_localize("UTC")).tolist() == [0.0, 1.0]
    assert stamps_s(stamps - stamps[0]).tolist() == [0.0, 1.0]
    assert (
        holds_stamps(stamps)
        and not holds_stamps(pd.Series([1.0, 2.0]))
        and not holds_stamps(pd.Series([], dtype=object))
    )
