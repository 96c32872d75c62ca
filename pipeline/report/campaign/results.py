"""A campaign's tables, summed up: medians over the new strings, who is best from how many strokes, pooled coverage."""

from itertools import groupby

import numpy as np
import pandas as pd

MAPS = {"forward": ("forward_mm", "mm"), "inverse": ("inverse_turns", "turns")}  # column and unit of each map
TRANSFER, ALONE = "transfer", "alone"
NEAR_FLOOR = 2.0  # times the floor: near enough to call the string known
TOLERANCE = 0.02  # by which coverage may miss its level


def title(model: str, how: str, titles: dict[str, str]) -> str:
    """What a model is called in tables and legends."""
    return titles.get(model, model) + (", alone" if how == ALONE else "")


def middles(few_shot: pd.DataFrame, column: str, titles: dict[str, str]) -> pd.DataFrame:
    """Median and quartiles over the strings of one error, a row for each way to learn, in the order of the titles.

    Columns: `model`, `how`, `title`, `shots`, `low`, `middle`, `high`.
    """
    order = list(titles)
    grouped = few_shot.groupby(["model", "how", "shots"])[column]
    table = grouped.quantile([0.25, 0.5, 0.75]).unstack().set_axis(["low", "middle", "high"], axis=1).reset_index()
    table["title"] = [title(model, how, titles) for model, how in zip(table["model"], table["how"], strict=True)]
    place = table["model"].map(order.index)
    keyed = table.assign(place=place, late=table["how"] == ALONE).sort_values(["late", "place", "shots"])
    return keyed.drop(columns=["place", "late"]).reset_index(drop=True)


def best(table: pd.DataFrame) -> pd.DataFrame:
    """The row of least median for each number of strokes shown; index `shots`."""
    return table.loc[table.groupby("shots")["middle"].idxmin()].set_index("shots")


def runs_of_best(table: pd.DataFrame) -> list[tuple[str, list[int], list[float]]]:
    """Title, strokes shown and medians of whoever is best, consecutive numbers of strokes together."""
    rows = [(int(str(shots)), str(row["title"]), float(row["middle"])) for shots, row in best(table).iterrows()]
    best_runs = []
    for name, group in groupby(rows, key=lambda row: row[1]):
        group_rows = list(group)
        best_runs.append((name, [row[0] for row in group_rows], [row[2] for row in group_rows]))
    return best_runs


def first_near(table: pd.DataFrame, limit: float) -> pd.Series | None:
    """The row with the fewest strokes whose median is within a limit, the best of them; None when none is."""
    near = table[table["middle"] <= limit].sort_values(["shots", "middle"])
    return None if near.empty else near.iloc[0]


def ahead_of(few_shot: pd.DataFrame, column: str, leader: pd.Series, other: pd.Series, shots: int) -> tuple[int, int]:
    """On how many strings one row of `middles` has a smaller error than another, and the number of strings."""
    errors = [
        few_shot[(few_shot["model"] == row["model"]) & (few_shot["how"] == row["how"]) & (few_shot["shots"] == shots)]
        .set_index("string")[column]
        .sort_index()
        for row in (leader, other)
    ]
    return int((errors[0] < errors[1]).sum()), len(errors[0])


def pooled(coverage: pd.DataFrame, by: list[str]) -> pd.DataFrame:
    """Share held, its standard error over the strings, median width and share outside, for each group.

    Strings are what is drawn, so the error counts how they differ: points of one string err alike.
    """
    rows = []
    for key, group in coverage.groupby(by, sort=True):
        held_points = (group["held"].fillna(0.0) * group["points"]).groupby(group["string"]).sum()
        points, outside = group.groupby("string")["points"].sum(), float(group["outside"].sum())
        total, count = float(points.sum()), len(points)
        share = float(held_points.sum()) / total if total else np.nan
        spread = float(np.sum((held_points - share * points) ** 2)) * count / max(count - 1, 1)
        error = float(np.sqrt(spread)) / total if total and count > 1 else np.nan
        width = float(group["width"].median())
        rows.append((*key, share, error, width, outside / max(total + outside, 1.0), count))
    return pd.DataFrame(rows, columns=[*by, "held", "error", "width", "outside", "strings"])


def by_string(coverage: pd.DataFrame, level: float) -> pd.Series:
    """Share held of each string at one level, both maps together."""
    at_level = coverage[np.isclose(coverage["level"], level) & (coverage["points"] > 0)]
    held_points = (at_level["held"] * at_level["points"]).groupby(at_level["string"]).sum()
    return held_points / at_level.groupby("string")["points"].sum()
