"""What the numbers of adopted effects mean, a row each: what it is, its unit, what it does to the reading."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from ...fit.problem import Act
from ...mechanisms.interface import Mechanism
from ...mechanisms.library import mechanisms
from ...recording.drivers import Drivers
from ..language.explained_words import meaning, on_rig
from ..language.quantity import at, number, said_unit, size
from ..language.table import UNKNOWN, aligned
from ..language.vocabulary import Vocabulary
from .formulas import direction, does, formula, of_strings_alone
from .shape_numbers import meaning_of, shape_number

HEAD = (
    "What each number under simulation means, for who looks: nobody needs them to predict. What a number does is said "
    "for this recording, all else held. Equations and sources: docs/physics.md."
)
UNSEEN = 0.01  # of the rms of an effect: a difference between two motions that is less is none
OF_NAME = "that share"  # a factor that is said once, above the table: the share is in the name
BRANCH = re.compile(r"(?:^|_)([0-9.]+)_s_")
DOES = {
    "twist": "acts on the {motion}",
    "radius": "changes the radius, as a share of it",
    "length": "lengthens the {string}",
    "resistance": "is lost where motion is resisted",
    "sensor": "adds to the reading",
}  # what a coefficient does, by the port that it acts at


@dataclass(frozen=True)
class Size:
    """What something does to the reading: rms; at the highest motion less at the lowest one; and these two `ends`."""

    rms: float
    at_top: float
    ends: tuple[float, float]


def factors(words: dict[str, str], name: str) -> dict[str, str]:
    """What the coefficient `name` multiplies, by the `words` in names; of two words at one place the longer one."""
    left, what = f"_{name}_", {}
    for word, factor in sorted(words.items(), key=lambda item: -len(item[0])):
        pattern = re.compile(f"_{re.escape(word)}_".replace(r"\*", "[0-9.]+"))
        if pattern.search(left):
            what[word] = factor
            left = pattern.sub("_", left)
    return what


def lines(acts: Sequence[Act], drivers: Drivers, words: Vocabulary, sizes: Sequence[Sequence[Size]]) -> list[str]:
    """Each effect with what it does, then a row for each of its numbers, the equation last.

    `sizes` has of each act the size of all of it, then that of each coefficient that is not 0.
    """
    act_lines = [line for act, own in zip(acts, sizes, strict=True) for line in _block(act, drivers, words, own)]
    return [HEAD, *act_lines] if act_lines else []


def _block(act: Act, drivers: Drivers, words: Vocabulary, sizes: Sequence[Size]) -> list[str]:
    mechanism, (whole, *each) = mechanisms()[act.id], sizes
    coefficients, moved = iter(act.coefficients), iter(each)
    rows, described, names = [], [], list[str]()
    for nonlinear in act.nonlinear:
        for term in mechanism.terms(drivers, nonlinear):
            value = next(coefficients)
            if not value:
                continue
            name, unit = drivers.units.name(term.name), said_unit(drivers.units.unit(term.unit))
            names.append(name)
            rows.append([f"{name} = {number(value, 3)} {unit or '(a share)'}", *_cells(next(moved), words, whole.rms)])
            described.append(_what(mechanism, name, does(term.port, DOES[term.port], words)))
    head, *table = aligned([["number", "reading moved, rms", _between(whole, words)], *rows])
    written = [f"  {act.id}: {on_rig(meaning(act.id), words)} In all it {_moves(whole, words)}."]
    written += [*_shares(mechanism, names), f"    {head}"]
    before = None
    for row, what in zip(table, described, strict=True):
        written += [f"    {row}", *([f"      {what}"] if what != before else [])]
        before = what
    for nonlinear in act.nonlinear:
        for key, value in nonlinear.items():
            name = drivers.units.name(key)
            if of_strings_alone(meaning_of(key), words):
                continue
            written.append(f"    {name} = {number(value, 3)}{shape_number(key, name, words)}")
    return [*written, f"    Its formula: {formula(mechanism, words)}"]


def _shares(mechanism: Mechanism, names: Sequence[str]) -> list[str]:
    """What each factor is that has a share in the names of coefficients, and where it stands there; a line each."""
    shares = {}
    for name in names:
        for word, factor in factors(mechanism.names, name).items():
            pattern = re.escape(word).replace(r"\*", "([0-9.]+)")
            share = re.search(pattern if "*" in word else f"{pattern}_([0-9.]+)", name)
            if OF_NAME in factor and share and word not in shares:
                meant = factor.replace(OF_NAME, "a share")
                shares[word] = f"    {word}: {meant}. In {name} the share is {share[1]}."
    return list(shares.values())


def _what(mechanism: Mechanism, name: str, done: str) -> str:
    """What a coefficient does, what it multiplies, and its time constant."""
    branch = BRANCH.search(name)
    parts = [
        done,
        *(
            f"it multiplies {_multiplied(name, word, factor)}"
            for word, factor in factors(mechanism.names, name).items()
        ),
        *([f"it acts with a time constant of {branch[1]} s"] if branch else []),
    ]
    return "; ".join(parts)


def _multiplied(name: str, word: str, factor: str) -> str:
    """What a coefficient multiplies: a factor with a share is said above the table, where the name has its share."""
    if OF_NAME not in factor:
        return factor
    return word if "*" in word or re.search(rf"{re.escape(word)}_[0-9]", name) else direction(factor)


def _between(moved: Size, words: Vocabulary) -> str:
    """Between which motions the reading is compared."""
    low, high = moved.ends
    top, bottom = at(high, "", high - low), at(low, words.motion_unit, high - low)
    return f"at {top} against {bottom}"


def _cells(moved: Size, words: Vocabulary, whole_rms: float) -> list[str]:
    """What something does to the reading in cells; a difference that nobody would see beside all of it is left out."""
    way = f"{'+' if moved.at_top > 0.0 else '-'}{size(abs(moved.at_top), words.unit)}"
    return [size(moved.rms, words.unit), way if abs(moved.at_top) > UNSEEN * whole_rms else UNKNOWN]


def _moves(moved: Size, words: Vocabulary) -> str:
    """What something does to the reading, without a full stop."""
    typical, way = _cells(moved, words, moved.rms)
    return f"moves the reading by {typical} rms{f', and by {way} {_between(moved, words)}' if way != UNKNOWN else ''}"
