"""The results of a campaign on new strings, in words: sentences and tables, with every number taken from the errors."""

import pandas as pd

from ..layout.plain_markdown import line
from .results import (
    ALONE,
    MAPS,
    NEAR_FLOOR,
    TRANSFER,
    ahead_of,
    best,
    first_near,
    middles,
    runs_of_best,
    title,
)

MATERIAL_SHOTS = (0, 2)  # strokes shown, of the tables by material
CALLED = {
    "direction": "direction of motion", "stroke": "stroke number n", "separator_mm": "separator b",
    "length_mm": "length l", "radius_mm": "radius r", "torsion_zone_mm": "torsion zone d",
    "stiffness_n_per_mm": "stiffness", "load_n": "load", "material": "material",
}  # fmt: skip


def size(value: float) -> str:
    """An error to three digits, however large."""
    return f"{value:#.3g}".rstrip(".") if value < 1000 else f"{value:.2g}"


def _strokes(numbers: list[int]) -> str:
    first, last = numbers[0], numbers[-1]
    return f"{first} stroke{'s' * (first != 1)}" if first == last else f"{first} to {last} strokes"


def leaders(few_shot: pd.DataFrame, column: str, unit: str, titles: dict[str, str]) -> str:
    """Which model is best from how many strokes on, and on how many strings it beats the best other way to learn."""
    table = middles(few_shot, column, titles)
    sentences = []
    for name, shots, values in runs_of_best(table):
        sizes = size(values[0]) if len(values) == 1 else f"{size(values[0])} to {size(values[-1])}"
        sentences.append(f"from {_strokes(shots)} {name} is best ({sizes} {unit} median)")
    text, ends = "; ".join(sentences), sorted({int(table["shots"].min()), int(table["shots"].max())})
    return f"{text[0].upper()}{text[1:]}. {' '.join(_won(few_shot, table, column, shots) for shots in ends)}"


def _won(few_shot: pd.DataFrame, table: pd.DataFrame, column: str, shots: int) -> str:
    """On how many strings the best is ahead of the second, where there are two."""
    ranked = table[table["shots"] == shots].sort_values("middle")
    if len(ranked) < 2:
        return ""
    first, other = ranked.iloc[0], ranked.iloc[1]
    won, of = ahead_of(few_shot, column, first, other, shots)
    with_them = f"With {_strokes([shots])} shown {first['title']} errs less"
    return f"{with_them} than the second, {other['title']}, on {won} of {of} strings."


def nearest(few_shot: pd.DataFrame, column: str, unit: str, level: float, titles: dict[str, str]) -> str:
    """Which model first comes near the floor; if none does, which comes nearest."""
    table = middles(few_shot, column, titles)
    near, limit = first_near(table, NEAR_FLOOR * level), f"{NEAR_FLOOR:g} times the floor"
    if near is not None:
        return (
            f"The first to come within {limit} is {near['title']}, from {_strokes([int(near['shots'])])}"
            f" ({size(near['middle'])} {unit}, {near['middle'] / level:.2f} times)."
        )
    least = table.loc[table["middle"].idxmin()]
    return (
        f"None comes within {limit}; the nearest is {least['title']} from {_strokes([int(least['shots'])])}"
        f" ({size(least['middle'])} {unit}, {least['middle'] / level:.2f} times)."
    )


def without_others(few_shot: pd.DataFrame, column: str, unit: str, titles: dict[str, str]) -> str:
    """From how many strokes on a model of one string alone beats all models that learnt from others."""
    table = middles(few_shot, column, titles)
    others, own = table[table["how"] == TRANSFER], table[table["how"] == ALONE]
    if others.empty or own.empty:
        return ""
    both = best(own).add_suffix("_own").join(best(others).add_suffix("_other"), how="inner")
    ahead = both[both["middle_own"] < both["middle_other"]]
    if ahead.empty:
        last = both.iloc[-1]
        return (
            f"Learning from the string alone is never better: with {_strokes([int(both.index[-1])])} shown"
            f" {last['title_own']} errs by {size(last['middle_own'])} {unit}, {last['title_other']} by"
            f" {size(last['middle_other'])}."
        )
    shots, first = int(ahead.index[0]), ahead.iloc[0]
    return (
        f"{first['title_own'].split(',')[0]}, from the string alone, errs less than all that learnt from other strings"
        f" with {_strokes([shots])} shown ({size(first['middle_own'])} against {size(first['middle_other'])} {unit})."
    )


def shots_table(few_shot: pd.DataFrame, floor: pd.DataFrame, column: str, titles: dict[str, str]) -> list[str]:
    """Median and quartiles of every model by strokes shown, the least of each column in bold, the floor last."""
    table = middles(few_shot, column, titles)
    shots, least = sorted(table["shots"].unique()), best(table)["title"]
    lines = [line(["model", *(f"{number} shown" for number in shots)]), line(["---"] * (1 + len(shots)))]
    for name, rows_of_title in table.groupby("title", sort=False):
        at = rows_of_title.set_index("shots")
        cells = []
        for number in shots:
            if number not in at.index:
                cells.append("")
                continue
            middle, low, high = (size(at.loc[number, part]) for part in ("middle", "low", "high"))
            cells.append(f"{f'**{middle}**' if least[number] == name else middle} ({low}–{high})")
        lines.append(line([str(name), *cells]))
    low, middle, high = (size(value) for value in floor[column].quantile([0.25, 0.5, 0.75]))
    return [*lines, line(["floor", *[f"{middle} ({low}–{high})"] * len(shots)]), ""]


def untold(few_shot: pd.DataFrame, titles: dict[str, str]) -> list[str]:
    """The inputs that each fitted model does not read, and its errors before it sees a stroke."""
    lines = [
        "Found by giving each fitted model other strings' values, one quantity at a time: what does not move its",
        "answers it cannot tell. A string's own correction, on top of it, does know eq. 4, direction and stroke.",
        "",
    ]
    for model, rows_of_model in few_shot.groupby("model", sort=False):
        missing = [words for name, words in CALLED.items() if name not in str(rows_of_model["reads"].iloc[0]).split()]
        ranks = []
        for map_, (column, _) in MAPS.items():
            start = middles(few_shot, column, titles)
            ranked = list(start[(start["shots"] == 0) & (start["how"] == TRANSFER)].sort_values("middle")["model"])
            if model in ranked:
                ranks.append(f"{map_} {ranked.index(model) + 1} of {len(ranked)}")
        place = f" Rank with no stroke shown, among those that learnt from others: {', '.join(ranks)}." if ranks else ""
        sentence = f"cannot tell {', '.join(missing)}" if missing else "reads all of them"
        lines.append(f"- {title(str(model), '', titles)}: {sentence}.{place}")
    return [*lines, ""]


def by_material(few_shot: pd.DataFrame, floor: pd.DataFrame, titles: dict[str, str]) -> list[str]:
    """Medians of every model by material, forward and inverse, for few strokes shown."""
    strings = floor.groupby("material")["string"].nunique()
    lines = []
    for column, unit in MAPS.values():
        for shots in MATERIAL_SHOTS:
            at_shots = few_shot[few_shot["shots"] == shots]
            heads = [f"{material} ({count})" for material, count in strings.items()]
            lines += [line([f"{unit}, {shots} shown (strings)", *heads]), line(["---"] * (1 + len(strings)))]
            order = middles(at_shots, column, titles)[["model", "how", "title"]].drop_duplicates()
            medians = at_shots.groupby(["model", "how", "material"])[column].median()
            for model, how, name in order.itertuples(index=False):
                lines.append(line([name, *(size(medians[model, how, material]) for material in strings.index)]))
            beneath = floor.groupby("material")[column].median()
            lines += [line(["floor", *(size(beneath[material]) for material in strings.index)]), ""]
    return lines
