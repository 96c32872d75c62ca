"""What the numbers of adopted effects mean, a row each: what it is, its unit, what it does to the reading."""

import re
from collections.abc import Mapping, Sequence

from ...fit.problem import Act
from ...mechanisms.interface import Mechanism
from ...mechanisms.library import mechanisms
from ...recording.drivers import Drivers
from ..language.explained_words import meaning, on_rig
from ..language.quantity import listing, number, said_unit
from ..language.text_table import UNKNOWN, aligned
from ..language.vocabulary import Vocabulary
from ..measured.moved_reading import Size, cells, change, moves, not_added_up
from . import formulas
from .effect_sentence import AT
from .formulas import direction, does, formula, of_strings_alone
from .nonlinear_parameters import meaning_of, measurable, on_this_rig, unit_of_parameter, with_its_unit

HEAD = (
    "What each number under simulation means, if you are curious: nobody needs them to predict. What a number does is "
    "said for this recording, all else held; where – stands, both ends hardly differ. "
    "Sources of the formulas: docs/physics.md."
)
NO_SENTENCES: Mapping[str, str] = {}
NO_DIMENSIONS: Mapping[str, tuple[float, float]] = {}
LOOP = "{loop}"  # in the sentence of an effect that moves the reading otherwise on the way up and down
OF_NAME = "that share"  # a factor that is said once, above the table: the share is in the name
BRANCH = re.compile(r"(?:^|_)([0-9.]+)_s_")
DOES = {
    "twist": "acts on the {motion}",
    "radius": "changes the radius, as a share of it",
    "length": "lengthens the {string}",
    "resistance": "is lost where motion is resisted",
    "sensor": "adds to the reading",
}  # what a coefficient does, by the port that it acts at


def factors(words: dict[str, str], name: str) -> dict[str, str]:
    """The factor that the coefficient `name` multiplies, by the `words` in names; the longest fitting word counts."""
    rest, what = f"_{name}_", {}
    for word, factor in sorted(words.items(), key=lambda item: -len(item[0])):
        pattern = re.compile(f"_{re.escape(word)}_".replace(r"\*", "[0-9.]+"))
        if pattern.search(rest):
            what[word] = factor
            rest = pattern.sub("_", rest)
    return what


def lines(
    acts: Sequence[Act],
    drivers: Drivers,
    words: Vocabulary,
    sizes: Sequence[Sequence[Size]],
    sentences: Mapping[str, str] = NO_SENTENCES,
    dimensions: Mapping[str, tuple[float, float]] = NO_DIMENSIONS,
) -> list[str]:
    """Each effect with what it does, then a table with a row for each of its numbers, the equation last.

    An effect that acts several times is said once, and has a table for each time, in the order of time.

    `sizes` has of each act the size of all of it, then that of each coefficient that is not 0; `sentences` says by its
    id what an effect does in this recording; `dimensions` has by name each as it was adopted, and as run.yaml has it.
    """
    by_id, act_lines = dict[str, list[tuple[Act, Sequence[Size]]]](), list[str]()
    for act, own in zip(acts, sizes, strict=True):
        by_id.setdefault(act.id, []).append((act, own))
    for id_, times in by_id.items():
        opening = f"  {id_}: {sentences.get(id_) or on_rig(meaning(id_), words)}"
        if len(times) > 1:
            act_lines.append(opening)
        for place, (act, own) in enumerate(sorted(times, key=lambda pair: pair[0].nonlinear[0].get(AT, 0.0)), 1):
            begins = f"  {id_}, {place} of {len(times)}: This one" if len(times) > 1 else f"{opening} In all it"
            act_lines += _block(act, drivers, words, own, begins, dimensions)
    return [HEAD, *act_lines] if act_lines else []


def _block(
    act: Act, drivers: Drivers, words: Vocabulary, sizes: Sequence[Size], begins: str,
    dimensions: Mapping[str, tuple[float, float]],
) -> list[str]:  # fmt: skip
    """The block of an effect: its size, its number of elements, the table, and its formula letter by letter.

    `begins`: how its first line begins, up to what moves the reading.
    """
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
            shares += [] if unit else [number(value, 3)]
            strengths.append(f"{number(value, 3)} {unit}".strip())
            rows.append([name, strengths[-1], *cells(next(moved), words, whole.rms)])
            described.append(
                _what(mechanism, name, does(term.port, DOES[term.port], words), not unit and term.port == "twist")
            )
    for nonlinear in act.nonlinear:
        for key, value in nonlinear.items():
            if of_strings_alone(meaning_of(key, mechanism), words):
                continue
            name = drivers.units.name(key)
            spelled, kept = with_its_unit(key, value, mechanism, drivers.units)
            spelled = spelled or f"{number(value, 3)} {unit_of_parameter(key, name)}".strip()
            others.setdefault(key, []).append(spelled)
            rows.append([name, spelled, "", ""])
            described.append(f"{on_this_rig(key, mechanism, words)}{kept}")
    shown = 3 if {row[-1] for row in rows} <= {UNKNOWN, ""} else 4  # a column that says nothing is left out
    heads = ["number", "value", "reading moved, rms", change(whole, words)]
    head, *table = aligned([row[:shown] for row in (heads, *rows)])
    weights = f" {listing(shares)} are weights, which need not add up to 1." * (len(shares) == len(names))
    several = [f"    It is made of {len(names)} elements: the first {len(names)} rows.{weights}"] * (len(names) > 1)
    loops = LOOP in mechanism.sentence
    written = [f"{begins} {moves(whole, words, loops)}.", *several, *_shares(mechanism, names)]
    written += not_added_up(whole, each, words)
    written.append(f"    {head}")
    for row, what in zip(table, described, strict=True):
        written += [f"    {row}", f"      {what}"]
    written += measurable(act, drivers, words)
    equation = formula(mechanism, words, [key for nonlinear in act.nonlinear for key in nonlinear])
    spellings = {key: listing(values) for key, values in others.items()}
    above = formulas.Numbers(tuple(strengths), spellings, whole.rms, tuple(names), dimensions)
    in_equation = formulas.lines(equation, mechanism, words, drivers, above)
    return [*written, f"    Its formula: {formulas.split(equation)[0]}", *(f"    {line}" for line in in_equation)]


def _shares(mechanism: Mechanism, names: Sequence[str]) -> list[str]:
    """The factors with a share in the coefficients' names, and where the share stands in a name; a line each."""
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
    """What a coefficient does, the factor it multiplies, and its time constant; `share`: it has no unit."""
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
    """The factor that a coefficient multiplies; if the name has a share of it, the table's remark tells the factor."""
    if OF_NAME not in factor:
        return factor
    own_share = re.search(re.escape(word).replace(r"\*", "[0-9.]+") + ("" if "*" in word else "_([0-9.]+)"), name)
    if own_share is None:
        return direction(factor)
    return f"{own_share[0] if '*' in word else f'the {word} {own_share[1]}'} (above)"
