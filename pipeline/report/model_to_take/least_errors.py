"""The table of all models in words: which errs least where, how the INN stands, and what the simulator misses."""

from collections.abc import Iterable

import pandas as pd

from ...ground.model_names import FLOORS, PAPER, SIMULATOR
from ..layout.plain_markdown import plain
from .fitted import SPLITS, times_floor

NEAR = {"forward": 1.05, "inverse": 1.10}  # times its floor: what a model that knows the direction should reach
FAR = 10.0  # times the floor, from which the error of a diagnosed simulator needs a reason


def _shown(row: pd.Series) -> str:
    return f"{row['median']:.3f}"


def _named(rows: pd.DataFrame, words: Iterable[str]) -> str:
    """Titles, each with a few words in brackets."""
    return ", ".join(f"{plain(title)} ({word})" for title, word in zip(rows["title"], words, strict=True))


def _least(models: pd.DataFrame) -> pd.DataFrame:
    """The models with the least error: several where the table shows the same number."""
    shown = models.apply(_shown, axis=1)
    return models[shown == _shown(models.loc[models["median"].idxmin()])]


def on_all_points(models: pd.DataFrame, where: str, unit: str) -> str:
    """The model with the least error of all, and the least without knowing the direction, if that is another."""
    text = ""
    for rows, of in ((models, ""), (models[~models["direction"]], "; of the models that are not told the direction: ")):
        if rows.empty or (of and not _least(models)["direction"].any()):
            continue
        least = _least(rows)
        text += f"{of}{', '.join(map(plain, least['title']))} ({_shown(least.iloc[0])} {unit})"
    return f"Least error {where}: {text}."


def by_column(chosen: pd.DataFrame) -> str:
    """The model with the least error in each column, in order; empty where one model leads in all."""
    parts = chosen[chosen["column"] != "all"]
    least = [_least(models) for _, models in parts.groupby("column", sort=False)]
    if not least:
        return ""
    of, count = pd.concat(least), len(least)
    named = []
    for title in dict.fromkeys(chosen["title"]):
        own = list(of.loc[of["title"] == title, "column"])
        named += [f"{plain(title)} ({'every column' if len(own) == count > 1 else ', '.join(own)})"] if own else []
    return f"Least error by column: {'; '.join(named)}."


def against_others(inn: pd.Series, models: pd.DataFrame, unit: str) -> str:
    """The models that the INN beats, and those that beat it."""
    others = models[models["model"] != PAPER]
    sides = {"less": others[others["median"] > inn["median"]], "more": others[others["median"] <= inn["median"]]}
    words = []
    for side, rows in sides.items():
        alike = (rows["high"] >= inn["low"]) & (rows["low"] <= inn["high"])
        sizes = [_shown(row) + ", within the spread of the seeds" * bool(alike[at]) for at, row in rows.iterrows()]
        words += [f"{side} than {_named(rows, sizes)}"] if sizes else []
        if len(rows) == len(others) > 1:
            words[-1] = f"{side} than all others: {_named(rows, sizes)}"
    return f"The {plain(inn['title'])} ({_shown(inn)} {unit}) errs {'; '.join(words)}." if words else ""


def cost_of_direction(chosen: pd.DataFrame, inn: pd.Series, unit: str) -> str:
    """The cost for the INN of not knowing the direction, from the floors; empty if it knows it."""
    floors = chosen[chosen["column"] == "all"].set_index("model")["median"]
    if inn["direction"] or not set(FLOORS) <= set(floors.index):
        return ""
    blind, directed = (f"{floors[name]:.3f}" for name in ("floor_blind", "floor"))
    if blind == directed:
        return " It is not told the direction, which costs nothing here."
    return f" It is not told the direction, without which the floor is {blind} {unit} instead of {directed} {unit}."


def sentences(chosen: pd.DataFrame) -> list[str]:
    """Lines of a Markdown list on one split and map: who is best where, how the INN stands, who is near the floor."""
    whole = chosen[(chosen["column"] == "all") & ~chosen["model"].isin(FLOORS)].sort_values("median", kind="stable")
    way, unit, split = chosen["map"].iloc[0], chosen["unit"].iloc[0], SPLITS[chosen["split"].iloc[0]]
    text = [on_all_points(whole, f"{way}, {split}", unit), by_column(chosen[~chosen["model"].isin(FLOORS)])]
    for _, inn in whole[whole["model"] == PAPER].iterrows():
        text.append(against_others(inn, whole, unit) + cost_of_direction(chosen, inn, unit))
    near = whole[whole["direction"] & (whole["ratio"] <= NEAR[way])]
    names = _named(near, [f"{ratio:.2f} ×" for ratio in near["ratio"]]) or "none"
    text.append(f"Models that know the direction and err by at most {NEAR[way]:.2f} × their floor: {names}.")
    return [f"- {words}" for words in text if words]


def on_simulator(table_of: pd.DataFrame, split: str, way: str) -> list[str]:
    """A line on the diagnosed simulator's large error on later strokes; empty where it is not large."""
    mine = table_of[(table_of["model"] == SIMULATOR) & (table_of["column"] == "all") & (table_of["map"] == way)]
    own = mine.set_index("split")
    if split != "later" or split not in own.index or not own.loc[split, "ratio"] > FAR:
        return []
    row = own.loc[split]
    inside = (
        f" It errs by {own.loc['within', 'median']:.3f} {row['unit']} within strokes." if "within" in own.index else ""
    )
    return [
        f"- {plain(row['title'])} ({row['median']:.3f} {row['unit']}, {times_floor(row['ratio'])} × its floor): for "
        "this table the effects were diagnosed without the later strokes, and what was named does not foresee them."
        f"{inside} An error so large says that the effects are not settled, or that the later strokes have another "
        "load or twist. Do not predict later strokes with it."
    ]
