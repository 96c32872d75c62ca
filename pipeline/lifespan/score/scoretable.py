"""Scores of forecasts as a table: how much each method claims, how often it holds, how wide and how wrong it is."""

from typing import Any

import numpy as np
import pandas as pd

LATE = "75% of the life"
HEADER = (
    "| method | asked | no claim | held 90 % (counted) | held 50 % (counted) | missed: too late / too early | "
    "upper end given | width of 90 % / strokes left | error of median / strokes left |"
)


def share(values: pd.Series) -> str:
    """The share among those that can be counted, and their number."""
    counted = values.dropna()
    return f"{100 * counted.mean():.1f} % ({len(counted)})" if len(counted) else "–"


def line(method: str, rows: pd.DataFrame) -> str:
    """One method's row of the table."""
    claims = rows[rows["state"] != "no claim"]
    uncensored = claims[~claims["censored"]]
    missed = claims[claims["held_90%"] == 0.0]
    late = int((missed["low"] > missed["left"]).sum())
    with np.errstate(invalid="ignore"):
        width = np.median((uncensored["high"] - uncensored["low"]) / uncensored["left"]) if len(uncensored) else np.nan
        off = (
            np.median(np.abs(uncensored["median"] - uncensored["left"]) / uncensored["left"])
            if len(uncensored)
            else np.nan
        )
    cells: list[Any] = [
        method,
        len(rows),
        len(rows) - len(claims),
        share(claims["held_90%"]),
        share(claims["held_50%"]),
        f"{late} / {len(missed) - late}",
        f"{100 * np.isfinite(claims['high']).mean():.0f} %" if len(claims) else "–",
        number(width),
        number(off),
    ]
    return "| " + " | ".join(map(str, cells)) + " |"


def number(value: float) -> str:
    """A ratio, or that half of them have no upper end."""
    return f"{value:.2f}" if np.isfinite(value) else "none"


def table(rows: pd.DataFrame, by: str) -> list[str]:
    """Lines of a table with a row for every value of a column."""
    return [HEADER, "|---|" + "---|" * 8, *(line(str(name), part) for name, part in rows.groupby(by, sort=False))]


def kinds(rows: pd.DataFrame) -> list[str]:
    """Lines of a table with a row for every kind of claim, over the whole life and late in it."""
    late = rows[rows["cut"] == LATE]
    by_state = ((state, part, late[late["state"] == state]) for state, part in rows.groupby("state"))
    pairs = [
        (line(str(state), part), line(f"{state}, {LATE}", old)) for state, part, old in by_state if state != "no claim"
    ]
    return [HEADER, "|---|" + "---|" * 8, *(row for pair in pairs for row in pair)]


def bounds(rows: pd.DataFrame) -> str:
    """The least and the greatest possible coverage, whatever the censored lives would have shown."""
    claims = rows[rows["state"] != "no claim"]
    low, high = claims["held_90%"].fillna(0.0).mean(), claims["held_90%"].fillna(1.0).mean()
    open_ = int(claims["held_90%"].isna().sum())
    return f"{open_} of {len(claims)} claims are left open by censored lives: the 90 % hold in {low:.1%} to {high:.1%}"


def words(rows: pd.DataFrame) -> str:
    """The whole account in Markdown."""
    strings = rows["string"].nunique()
    lines = [f"{strings} strings.", ""]
    for question, part in rows.groupby("question", sort=False):
        ours = part[part["method"] == "this forecast"]
        censored = ours.groupby("string")["censored"].first().sum()
        lines += [
            f"## {question}",
            "",
            f"{ours['string'].nunique()} strings, {censored} of them censored. {bounds(ours)}.",
        ]
        lines += ["", *table(part, "method"), "", *table(ours, "cut"), "", *kinds(ours), ""]
    return "\n".join(lines)
