"""The load and the twist that each stroke was recorded under, and both in words."""

from collections.abc import Iterable

import pandas as pd

Kind = tuple[str, str, str, str]  # column, and in words: what stands before a size, its unit, what it is
KINDS: tuple[Kind, ...] = (("load_n", "at ", "N", "load"), ("top_turns", "to ", "turns", "twist"))
SPAN = (0.05, 0.95)  # quantiles of a stroke's load between which it is told to lie
CHANGING = " (changing within a stroke)"
NEAR = 0.05  # of a load or a twist: what differs by less is the same


def conditions(points: pd.DataFrame) -> pd.DataFrame:
    """The median load in N and the largest twist in turns, `load_n` and `top_turns`, by string and stroke.

    The load lies from `low_n` to `high_n`, both the median where it does not change within the stroke. Strokes
    within which it changes about the same load have that as `load_n`: a difference of their medians says nothing.
    """
    strokes = points.groupby(["string", "stroke"], sort=False)
    loads = strokes["load_n"]
    median_n, low_n, high_n = loads.median(), loads.quantile(SPAN[0]), loads.quantile(SPAN[1])
    changes = high_n - low_n > 2.0 * NEAR * median_n.abs()
    usual_n = median_n[changes].median()
    about = changes & (low_n <= usual_n) & (usual_n <= high_n)
    load_n = median_n.mask(about, usual_n)
    low_n, high_n = low_n.where(changes, load_n), high_n.where(changes, load_n)
    top_turns = strokes["motor_turns"].max()
    return pd.DataFrame({"load_n": load_n, "low_n": low_n, "high_n": high_n, "top_turns": top_turns})


def between(low: float, high: float, unit: str) -> str:
    """Some sizes in words: 20 N, 16 to 20 turns."""
    first, last = f"{low:.3g}", f"{high:.3g}"
    return f"{first} {unit}" if first == last else f"{first} to {last} {unit}"


def in_words(by_stroke: pd.DataFrame, kinds: Iterable[Kind]) -> str:
    """A load and a twist in words: at 20 N and to 16 turns; at 15 to 40 N (changing within a stroke)."""
    words = []
    for column, word, unit, _ in kinds:
        low, high = (by_stroke[name] for name in (("low_n", "high_n") if column == "load_n" else (column, column)))
        words.append(f"{word}{between(low.min(), high.max(), unit)}{CHANGING * bool((high > low).any())}")
    return " and ".join(words)


def is_other_load(load_n: float, loads_n: Iterable[float]) -> bool:
    """Whether a load is another one than each of some loads, all in N."""
    return all(abs(load_n - other) > NEAR * max(abs(load_n), abs(other)) for other in loads_n)
