"""What the numbers of adopted effects mean, a row each: what it is, its unit, what it does to the reading."""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from ...fit.problem import Act
from ...mechanisms.interface import Mechanism
from ...mechanisms.library import mechanisms
from ...recording.drivers import Drivers
from ..language.explained_words import meaning, on_rig
from ..language.quantity import at, listing, number, percent, quantity, said_unit, size, to_the_band
from ..language.table import UNKNOWN, aligned
from ..language.vocabulary import Vocabulary
from . import formulas
from .formulas import direction, does, formula, of_strings_alone
from .nonlinear_parameters import LOAD, meaning_of, on_this_rig, unit_of_parameter

HEAD = (
    "What each number under simulation means, if you are curious: nobody needs them to predict. What a number does is "
    "said for this recording, all else held; where – stands, both ends hardly differ. "
    "Sources of the formulas: docs/physics.md."
)
NO_SENTENCES: Mapping[str, str] = {}
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


def lines(
    acts: Sequence[Act],
    drivers: Drivers,
    words: Vocabulary,
    sizes: Sequence[Sequence[Size]],
    sentences: Mapping[str, str] = NO_SENTENCES,
) -> list[str]:
    """Each effect with what it does, then a table with a row for each of its numbers, the equation last.

    `sizes` has of each act the size of all of it, then that of each coefficient that is not 0; `sentences` says by its
    id what an effect does in this recording.
    """
    act_lines = [
        line
        for act, own in zip(acts, sizes, strict=True)
        for line in _block(act, drivers, words, own, sentences.get(act.id) or on_rig(meaning(act.id), words))
    ]
    return [HEAD, *act_lines] if act_lines else []


def _block(act: Act, drivers: Drivers, words: Vocabulary, sizes: Sequence[Size], does_here: str) -> list[str]:
    """An effect: what it does, of how many elements it is made, the table, and its formula letter by letter."""
    mechanism, (whole, *each) = mechanisms()[act.id], sizes
    coefficients, moved = iter(act.coefficients), iter(each)
    rows, described, names, shares = list[list[str]](), list[str](), list[str](), list[str]()
    strengths, others = list[str](), dict[str, list[str]]()
    for nonlinear in act.nonlinear:
        for term in mechanism.terms(drivers, nonlinear):
            value = next(coefficients)
            if not value:
                continue
            name, unit = drivers.units.name(term.name), said_unit(drivers.units.unit(term.unit))
            names.append(name)
            shares += [] if unit else [percent(value)]
            strengths.append(f"{number(value, 3)} {unit}".strip())
            rows.append([name, strengths[-1], *_cells(next(moved), words, whole.rms)])
            described.append(
                _what(mechanism, name, does(term.port, DOES[term.port], words), not unit and term.port == "twist")
            )
    for nonlinear in act.nonlinear:
        for key, value in nonlinear.items():
            if of_strings_alone(meaning_of(key, mechanism), words):
                continue
            name, kept = drivers.units.name(key), ""
            spelled = f"{number(value, 3)} {unit_of_parameter(key, name)}".strip()
            if key.endswith(LOAD):
                spelled = f"{number(drivers.units.load_size * value, 3)} {drivers.units.load}"
                counted = quantity(drivers.units.load_size, drivers.units.load)
                kept = f"; run.yaml has it as {number(value, 3)}, in {counted}"
            others.setdefault(key, []).append(spelled)
            rows.append([name, spelled, "", ""])
            described.append(f"{on_this_rig(key, mechanism, words)}{kept}")
    shown = 3 if {row[-1] for row in rows} <= {UNKNOWN, ""} else 4  # a column that says nothing is left out
    heads = ["number", "value", "reading moved, rms", _between(whole, words)]
    head, *table = aligned([row[:shown] for row in (heads, *rows)])
    made = f" {listing(shares)} are weights, which need not add up to 100 %." * (len(shares) == len(names))
    several = [f"    It is made of {len(names)} elements: the first {len(names)} rows.{made}"] * (len(names) > 1)
    written = [f"  {act.id}: {does_here} In all it {_moves(whole, words)}.", *several, *_shares(mechanism, names)]
    written += _adding_up(whole, each, words)
    written.append(f"    {head}")
    for row, what in zip(table, described, strict=True):
        written += [f"    {row}", f"      {what}"]
    equation = formula(mechanism, words, [key for nonlinear in act.nonlinear for key in nonlinear])
    above = formulas.Numbers(tuple(strengths), {key: listing(values) for key, values in others.items()}, whole.rms)
    in_equation = formulas.lines(equation, mechanism, words, drivers, above)
    return [*written, f"    Its formula: {formulas.split(equation)[0]}", *(f"    {line}" for line in in_equation)]


def _adding_up(whole: Size, each: Sequence[Size], words: Vocabulary) -> list[str]:
    """By how much the rows of the last column do not add up to what the whole effect does there, and why."""
    least = UNSEEN * whole.rms
    shown = [moved.at_top for moved in each if abs(moved.at_top) > least]
    ways = [_cells(replace(whole, at_top=total), words, whole.rms)[1] for total in (sum(shown), whole.at_top)]
    if ways[0] == ways[1] or not shown or UNKNOWN in ways:
        return []
    small = abs(sum(moved.at_top for moved in each) - whole.at_top) < least
    left_out = f"where – stands it is less than {size(least, words.unit)} each"
    why = left_out if small else "what each number does depends on the others"
    return [f"    The rows of the last column add up to {ways[0]}, not to {ways[1]}: {why}."]


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


def _what(mechanism: Mechanism, name: str, done: str, share: bool = False) -> str:
    """What a coefficient does, what it multiplies, and its time constant; `share`: it has no unit."""
    branch = BRANCH.search(name)
    multiplied = [_multiplied(name, word, factor) for word, factor in factors(mechanism.names, name).items()]
    if share and len(multiplied) == 1 and not branch:
        return f"how much of {multiplied[0]} {done}"
    parts = [
        f"how strong it is; {done}" if share and not multiplied else done,
        *([f"it multiplies {listing(multiplied)}"] if multiplied else []),
        *([f"it acts with a time constant of {branch[1]} s"] if branch else []),
    ]
    return "; ".join(parts)


def _multiplied(name: str, word: str, factor: str) -> str:
    """What a coefficient multiplies: a factor with a share is said above the table, where the name has its share."""
    if OF_NAME not in factor:
        return factor
    own_share = re.search(re.escape(word).replace(r"\*", "[0-9.]+") + ("" if "*" in word else "_([0-9.]+)"), name)
    if own_share is None:
        return direction(factor)
    return f"{own_share[0] if '*' in word else f'the {word} {own_share[1]}'} (above)"


def _between(moved: Size, words: Vocabulary) -> str:
    """Between which motions the reading is compared."""
    low, high = moved.ends
    top, bottom = at(high, "", high - low), at(low, words.motion_unit, high - low)
    return f"at {top} against {bottom}"


def _cells(moved: Size, words: Vocabulary, whole_rms: float) -> list[str]:
    """What something does to the reading in cells; a difference that nobody would see beside all of it is left out."""
    least = 10.0 ** math.floor(math.log10(whole_rms)) if whole_rms > 0.0 else 0.0
    way = f"{'+' if moved.at_top > 0.0 else '-'}{_in_unit(abs(moved.at_top), least, words.unit)}"
    return [_in_unit(moved.rms, least, words.unit), way if abs(moved.at_top) > UNSEEN * whole_rms else UNKNOWN]


def _in_unit(value: float, least: float, unit: str) -> str:
    """A size in the unit that all of its column have, to a hundredth of `least`: 0.0003 mm beside 0.0268 mm."""
    return f"{to_the_band(value, 0.1 * least, 3)} {said_unit(unit)}".rstrip()


def _moves(moved: Size, words: Vocabulary) -> str:
    """What something does to the reading, without a full stop."""
    typical, way = size(moved.rms, words.unit), _cells(moved, words, moved.rms)[1]
    return f"moves the reading by {typical} rms{f', and by {way} {_between(moved, words)}' if way != UNKNOWN else ''}"
