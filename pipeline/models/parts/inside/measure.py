"""By what a question is inside or outside: what a material was recorded under, or the string that it names.

A question can lie in the ranges of its material where its own string was never under that load. How that string then
differs from the others no error tells. So a question about a recorded string is measured by the string's own loads,
strokes, twists and contractions, and one about a string that nobody recorded by those of all.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import pandas as pd

from ....ground.kinematics import Array
from ....ground.units import unit_of
from ....ground.words.counts import counted
from ..box import Box, room
from ..conditions import VARIES
from .assumed_stiffness import is_never_measured, said_once
from .beyond_range import inward
from .recorded_pairs import Paired, pairs_of
from .recorded_strokes import LOAD, Under

OWN = ("motor_turns", "displacement_mm", "stroke", "direction", LOAD)  # columns of which each string has its own range
WAYS = {1.0: "winding", -1.0: "unwinding"}
NAMED = 4  # other strings that are named


@dataclass(frozen=True)
class Measure:
    """The ranges that were recorded, the pairs of condition and twist, and the strokes under each load.

    `string` is the one whose recordings they are, empty for all; `whole` is then the measure of all, and `others` are
    the boxes of the other strings.
    """

    box: Box
    pairs: tuple[Paired, ...]
    under: Under | None
    never_measured: bool = False  # the stiffness of any string
    string: str = ""
    ends: Mapping[str, tuple[float, float]] = field(default_factory=dict)  # least and most, in the column's unit
    whole: "Measure | None" = None
    others: Mapping[str, Box] = field(default_factory=dict)

    @property
    def whose(self) -> str:
        """Whose recordings they are, after a word such as recorded; empty for those of all strings."""
        return f" of string {self.string}" if self.string else ""

    def leaning(self, name: str, value: float) -> str:
        """That a value of a column, in its unit, was recorded of other strings alone; empty where of none."""
        if self.whole is None or name not in self.ends or not _holds(self.whole.box, name, value):
            return ""
        least, most = self.ends[name]
        if _holds(self.box, name, value) or (name == "stroke" and value > most):  # ahead: errors were measured there
            return ""
        strings = [string for string, box in self.others.items() if _holds(box, name, value)]
        span, at = _span(name, least, most), _at(name, f"{value:.4g}")
        return f"string {self.string} was recorded {span} only; {at} the answer leans on {_named(strings)}"

    def gaps(self, points: pd.DataFrame) -> dict[str, list[str]]:
        """By each condition of the `pairs`, between which recorded values a question lies, as `Paired.gaps` says it.

        The string is named only where others were recorded otherwise.
        """
        return said_once(
            points, {paired.name: self._gaps(paired, points) for paired in self.pairs}, self.never_measured
        )

    def never(self, points: pd.DataFrame, turns: Array) -> dict[str, list[str]]:
        """By each condition of the `pairs`, that a twist was not recorded around it, as `Paired.never` says it.

        Twists in turns, of shape (points,).
        """
        return said_once(
            points, {paired.name: paired.never(points, turns) for paired in self.pairs}, self.never_measured
        )

    def _gaps(self, paired: Paired, points: pd.DataFrame) -> list[str]:
        """The gaps of one condition."""
        gaps = paired.gaps(points)
        of_all = next((pair for pair in self.whole.pairs if pair.name == paired.name), None) if self.whole else None
        if of_all is None:
            return gaps
        without = replace(paired, whose="").gaps(points)
        return [
            any_ if any_ == bare else gap for gap, bare, any_ in zip(gaps, without, of_all.gaps(points), strict=True)
        ]


def measures(points: pd.DataFrame, ahead: int) -> dict[str, Measure]:
    """The measure of each of several strings, and under the name "" that of all points.

    Errors were measured up to `ahead` strokes after the last one. A string alone has the measure of all.
    """
    whole = Measure(Box.of(points), pairs_of(points), Under.of(points, ahead), is_never_measured(points))
    tables = {str(string): own for string, own in points.groupby(points["string"].astype(str))}
    if len(tables) < 2:
        return {"": whole}
    names = [name for name in OWN if name in whole.box.low and (name != LOAD or whole.under)]
    rooms = {name: room(name, float(points[name].min()), float(points[name].max())) for name in names}
    ends = {string: {name: _ends(own[name]) for name in names} for string, own in tables.items()}
    boxes = {string: _box(whole.box, ends[string], rooms) for string in tables}
    return {"": whole} | {
        string: Measure(
            boxes[string],
            tuple(replace(paired, whose=f" of string {string}") for paired in pairs_of(own, _rooms(whole.pairs))),
            Under.of(own, ahead, whole.under.room, f" of string {string}") if whole.under else None,
            whole.never_measured,
            string,
            ends[string],
            whole,
            {other: box for other, box in boxes.items() if other != string},
        )
        for string, own in tables.items()
    }


def _ends(values: pd.Series) -> tuple[float, float]:
    """The least and the most of a column, in its unit."""
    return float(values.min()), float(values.max())


def _box(whole: Box, ends: Mapping[str, tuple[float, float]], rooms: Mapping[str, float]) -> Box:
    """The box of one string: its own ranges with a room that is its own or all strings', and their sizes."""
    wide = {name: max(rooms[name], room(name, *own)) for name, own in ends.items()}
    low = whole.low | {name: least - wide[name] for name, (least, _) in ends.items()}
    return Box(low, whole.high | {name: most + wide[name] for name, (_, most) in ends.items()}, whole.materials)


def _rooms(pairs: tuple[Paired, ...]) -> dict[str, float]:
    """The room of each condition that differs among all strings, in its unit."""
    return {paired.name: paired.room for paired in pairs}


def _holds(box: Box, name: str, value: float) -> bool:
    """Whether a value of a column, in its unit, lies in a box."""
    return box.low[name] <= value <= box.high[name]


def _span(name: str, least: float, most: float) -> str:
    """Where a string was recorded, by a column: at 15 N; at 0 to 20 turns; in strokes 5 to 12."""
    if name == "direction":
        return WAYS[least]
    if name == LOAD and most - least <= 2.0 * VARIES * abs(most):
        return _at(name, f"{(least + most) / 2.0:.3g}")
    digits = [f"{end:g}" for end in (inward(least, up=True), inward(most, up=False))]
    plural = "s" * (name == "stroke" and least != most)
    return _at(name, " to ".join(dict.fromkeys(digits)), plural)


def _at(name: str, number: str, plural: str = "") -> str:
    """A place in words, by a column and a number: at 30 N; in stroke 3; unwinding."""
    if name == "direction":
        return WAYS[float(number)]
    return f"in stroke{plural} {number}" if name == "stroke" else f"at {number} {unit_of(name)}"


def _named(strings: list[str]) -> str:
    """Strings of the material: string A; strings A and B; of many the first, and how many more."""
    if not strings:
        return "other strings of the material"
    more = len(strings) - NAMED
    names = [*strings[:NAMED], counted(more, "more string")] if more > 0 else strings
    several = "s" * (len(names) > 1)
    return f"string{several} {' and '.join(filter(None, [', '.join(names[:-1]), names[-1]]))} of the material"
