"""The load and the twist of recorded strokes: which later ones differ, and words for a legend."""

import argparse
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import pandas as pd

from ...ground.stored import schemas
from .recorded_conditions import KINDS, NEAR, Kind, between, conditions, in_words, is_other_load
from .shown_strokes import listed, ranges

APART = "Later strokes under other conditions"
OTHERWISE = "Recorded under other conditions"
MOST = 4  # conditions that a sentence tells one by one
FEW, MORE = 0.25, 2.0  # a load of fewer of the learnt strokes, and so many times more of the later ones, is another one


def add_dataset(parser: argparse.ArgumentParser) -> None:
    """Add the option for the points behind the metrics to a command line."""
    parser.add_argument("--dataset", type=Path, help="the material's dataset.parquet: what its strokes were like")


def dataset_from(path: Path | None) -> pd.DataFrame | None:
    """The points named on a command line, if any."""
    return schemas.read(path, schemas.DATASET) if path else None


def _share(load_n: float, loads_n: pd.Series) -> float:
    """The share of strokes that were recorded under a load."""
    return float(((loads_n - load_n).abs() <= NEAR * loads_n.abs().clip(lower=abs(load_n))).mean())


def _is_rare_load(load_n: float, seen_n: pd.Series, later_n: pd.Series) -> bool:
    """Whether few learnt strokes were recorded under a load, and many of the later ones."""
    seen = _share(load_n, seen_n)
    return seen < FEW and MORE * seen < _share(load_n, later_n)


def _is_other_twist(top_turns: float, tops_turns: Iterable[float]) -> bool:
    return not (1.0 - NEAR) * min(tops_turns) <= top_turns <= (1.0 + NEAR) * max(tops_turns)


def later_apart(dataset: pd.DataFrame | None) -> str:
    """A sentence on held-out later strokes under a load or to a twist that few training strokes have; else empty."""
    if dataset is None:
        return ""
    by_stroke = conditions(dataset)
    split = dataset.groupby(["string", "stroke"], sort=False)["later"].first()
    seen, later = by_stroke[split == "train"], by_stroke[split == "test"]
    if seen.empty or later.empty:
        return ""
    loads, twists = _apart_of_own(later, seen)
    others = later[loads | twists]
    if others.empty:
        return ""
    strokes = sorted({int(stroke) for _, stroke in others.index})
    kinds = [kind for kind, are_others in zip(KINDS, (loads.any(), twists.any()), strict=True) if are_others]
    is_like = seen["load_n"].map(lambda load_n: not is_other_load(load_n, set(others["load_n"])))
    usual = seen[~is_like] if loads.any() and not is_like.all() else seen
    rest = "most others" if len(usual) < len(seen) else "the others"
    what = " and ".join(f"another {kind}" for *_, kind in kinds)
    return (
        f"{APART}: n={ranges(strokes)} {'was' if len(strokes) == 1 else 'were'} recorded {in_words(others, kinds)}, "
        f"{rest} {in_words(usual, kinds)}. So the errors on later strokes are errors at {what} too, and do not decide "
        "which model to take."
    )


def _apart_of_own(later: pd.DataFrame, seen: pd.DataFrame) -> tuple[pd.Series, pd.Series]:
    """Which later strokes have a load, and which a twist, that few training strokes of their own string have.

    Those of a string without training strokes are measured by all others.
    """
    loads, twists = (pd.Series(False, index=later.index) for _ in range(2))
    for string, own_later in later.groupby(level="string", sort=False):
        of_string = seen[seen.index.get_level_values("string") == string]
        own_seen = seen if of_string.empty else of_string
        for key, own in own_later.iterrows():
            loads[key] = _is_rare_load(own["load_n"], own_seen["load_n"], own_later["load_n"])
            twists[key] = _is_other_twist(own["top_turns"], own_seen["top_turns"])
    return loads, twists


def _usual(sizes: pd.Series) -> float:
    """The size that most strokes share, or nearly."""
    return float(max(sizes, key=lambda size: (abs(sizes - size) <= NEAR * abs(size)).sum()))


def otherwise(dataset: pd.DataFrame | None, strokes: Sequence[int] | None = None) -> str:
    """A sentence on named strokes with another load or twist than most strokes; else empty."""
    if dataset is None:
        return ""
    by_stroke = conditions(dataset)
    usual_n, usual_turns = _usual(by_stroke["load_n"]), _usual(by_stroke["top_turns"])
    loads = by_stroke["load_n"].map(lambda load_n: is_other_load(load_n, [usual_n]))
    twists = by_stroke["top_turns"].map(lambda top_turns: _is_other_twist(top_turns, [usual_turns]))
    number = by_stroke.index.get_level_values("stroke")
    is_shown = number.isin(list(number if strokes is None else strokes))
    is_other = loads | twists
    others, rest = by_stroke[is_other & is_shown], by_stroke[~is_other]
    if others.empty or rest.empty:
        return ""
    kinds = [kind for kind, are in zip(KINDS, (loads, twists), strict=True) if are[is_shown].any()]
    is_of_some = bool({stroke for _, stroke in others.index} & {stroke for _, stroke in rest.index})
    shown = "" if strokes is None else " of those shown"
    if is_of_some:
        return f"{OTHERWISE}: {_by_string(by_stroke[is_other], others, rest, kinds, shown)}."
    if strokes is not None:
        rest = rest[rest.index.get_level_values("stroke").isin(list(strokes))]
    if rest.empty:
        return f"{OTHERWISE}: {'; '.join(_by_condition(others, kinds))}."
    named = _by_condition(others, kinds)
    if len(named) > MOST:
        named = [f"n={ranges(sorted({int(at) for _, at in others.index}))} {in_words(others, kinds)}"]
    return f"{OTHERWISE}: {'; '.join(named)}; the others{shown} {in_words(rest, kinds)}."


def _by_condition(others: pd.DataFrame, kinds: Iterable[Kind]) -> list[str]:
    """Strokes and their condition in words, those of one condition together."""
    strokes: dict[str, list[int]] = {}
    for at, condition in others.groupby(level="stroke"):
        strokes.setdefault(in_words(condition, kinds), []).append(int(at))
    return [f"n={ranges(numbers)} {words}" for words, numbers in strokes.items()]


def _by_string(every: pd.DataFrame, shown: pd.DataFrame, rest: pd.DataFrame, kinds: Sequence[Kind], which: str) -> str:
    """The same where strings differ: `every` are all strokes of another condition, `shown` those in a table.

    `which` follows the word "others".
    """
    named = []
    for string in dict.fromkeys(shown.index.get_level_values("string")):
        own = every.xs(string, level="string", drop_level=False)
        if string not in rest.index.get_level_values("string"):
            named.append(f"all strokes of string {string} {in_words(own, kinds)}")
        else:
            strokes = _by_condition(shown.xs(string, level="string", drop_level=False), kinds)
            named.append(f"of string {string} {' and '.join(strokes)}")
    if len(named) > MOST:
        named = [f"strokes of {len(named)} strings {in_words(shown, kinds)}"]
    return f"{'; '.join(named)}; all others{which} {in_words(rest, kinds)}"


def labels(points: pd.DataFrame, strokes: Mapping[int, Sequence[str]]) -> dict[int, str]:
    """`n=5` for each stroke, with its load where the loads of the strokes differ, and its twist where it is smaller.

    `strokes` has the strings of each. Where these differ in a load or a twist, each has its own, in their order.
    """
    by_stroke = conditions(points)
    loads = by_stroke["load_n"]
    has_loads = any(is_other_load(load_n, [loads.median()]) for load_n in loads)
    most_turns = by_stroke["top_turns"].max()
    words = {}
    for stroke, strings in strokes.items():
        own = by_stroke.loc[[(string, stroke) for string in strings]]
        more = [f"{_each_load(own)} N"] * has_loads
        if (own["top_turns"] < (1.0 - NEAR) * most_turns).any():
            more.append(f"to {_each(own['top_turns'])} turns")
        words[stroke] = f"n={stroke}" + (f" ({', '.join(more)})" if more else "")
    return words


def _each_load(own: pd.DataFrame) -> str:
    """Loads in words as `_each`, one that changes within a stroke with its range: 15 to 40."""
    if (own["high_n"] > own["low_n"]).any():
        ranges_n = [between(low, high, "").strip() for low, high in zip(own["low_n"], own["high_n"], strict=True)]
        return listed(list(dict.fromkeys(ranges_n)))
    return _each(own["load_n"])


def _each(sizes: pd.Series) -> str:
    """Sizes in words, once where they are nearly the same: 20, 15 and 25."""
    is_near = sizes.max() - sizes.min() <= NEAR * abs(sizes.max())
    return listed([f"{size:.3g}" for size in (sizes[:1] if is_near else sizes)])
