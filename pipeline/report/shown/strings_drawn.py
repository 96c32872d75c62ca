"""Which strings a figure draws where several share its strokes, and what it says of that beneath."""

from collections.abc import Mapping, Sequence

import pandas as pd

from ...ground.words.counts import are, counted
from .shown_strokes import listed

LOOKS = ("full colour", "light colour", "lighter colour", "lightest colour")  # of the first string, the second, …
NAMED = 3  # strings that are not drawn
Strings = Mapping[int, Sequence[str]]  # by stroke


def strings_drawn(points: pd.DataFrame, strokes: Sequence[int], most: int) -> dict[int, list[str]]:
    """The strings whose winding a figure draws of each stroke: as few as hold every stroke, those that hold most first.

    Up to `most` strings are drawn where there are so many; with 1 each stroke is of one string.
    """
    winding = points[(points["phase"] == "winding") & points["stroke"].isin(list(strokes))]
    holds = {str(string): set(own["stroke"]) for string, own in winding.groupby("string", sort=False)}
    chosen: list[str] = []
    while len(chosen) < len(holds):
        missing = {stroke for stroke in strokes if not any(stroke in holds[string] for string in chosen)}
        if not missing and len(chosen) >= most:
            break
        rest = [string for string in holds if string not in chosen]
        chosen.append(max(rest, key=lambda string: len(holds[string] & (missing or set(strokes)))))
    of_stroke = {stroke: [string for string in chosen if stroke in holds[string]] for stroke in strokes}
    return of_stroke if most > 1 else {stroke: strings[:1] for stroke, strings in of_stroke.items()}


def names_drawn(of_stroke: Strings) -> list[str]:
    """The strings of `strings_drawn`, each once."""
    return list(dict.fromkeys(string for strings in of_stroke.values() for string in strings))


def side_by_side(of_stroke: Strings) -> bool:
    """Whether a stroke is drawn of several strings, which then must look different."""
    return any(len(strings) > 1 for strings in of_stroke.values())


def of_one(of_stroke: Strings, points: pd.DataFrame) -> str:
    """Words of a title: " of reel-a" where that string alone is drawn of several; else empty."""
    names = names_drawn(of_stroke)
    return f" of {names[0]}" if len(names) == 1 < points["string"].nunique() else ""


def which_strings(of_stroke: Strings, points: pd.DataFrame) -> str:
    """A sentence on which strings are drawn, and which are not; empty of a material of one string."""
    every, names = sorted(map(str, points["string"].unique())), names_drawn(of_stroke)
    if len(every) < 2 or not names:
        return ""
    undrawn = [string for string in every if string not in names]
    if len(names) == 1:
        parts = [f"drawn is {names[0]} alone"]
    elif side_by_side(of_stroke):
        parts = [", ".join(f"{look} is {name}" for look, name in zip(LOOKS, names, strict=False))]
        fewer = {stroke: strings for stroke, strings in of_stroke.items() if len(strings) < len(names)}
        parts += [f"{words} alone" for words in _by_strings(fewer)]
    else:
        parts = [f"drawn is {listed(_by_strings(of_stroke))}"]
    if undrawn:
        words = listed(undrawn) if len(undrawn) <= NAMED else counted(len(undrawn), "other string")
        parts.append(f"{words} {are(len(undrawn))} not")
    if undrawn or not side_by_side(of_stroke):
        parts.append(f"the tables are of {'both' if len(every) == 2 else f'all {len(every)}'}")
    return f"Every string counts its own strokes: {'; '.join(parts)}."


def _by_strings(of_stroke: Strings) -> list[str]:
    """Strokes in words, those of the same strings together: "n=1, 5 of reel-a"."""
    strokes: dict[str, list[int]] = {}
    for stroke, strings in of_stroke.items():
        strokes.setdefault(listed(strings), []).append(stroke)
    return [f"n={', '.join(map(str, numbers))} of {names}" for names, numbers in strokes.items()]
