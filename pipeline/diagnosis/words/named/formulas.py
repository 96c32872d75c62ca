"""The formula of an effect in the words of a rig, and a table of its letters: value and meaning."""

import re
from collections.abc import Iterable, Mapping

import numpy as np

from ....ground.kinematics import Array
from ...mechanisms.interface import Mechanism
from ...recording.drivers import Drivers
from ..language.quantity import number, quantity, said_unit, size, span
from ..language.text_table import aligned
from ..language.vocabulary import Vocabulary
from ..measured.adopted_numbers import UNUSED, Numbers, adopted, rows
from .nonlinear_parameters import MEANT, meaning_of, on_this_rig

LETTER = re.compile(r"(?<![A-Za-z0-9_])[A-Za-z]+(?:_[A-Za-z0-9]+)?[0-9]?'*(?![A-Za-z0-9_])")
OWN = re.compile(r"(?:^|, )([A-Za-z][A-Za-z0-9_']*): ")  # in the rest of an equation, which says what its letters are
CALCULATED, DIMENSION = "calculated", "see run.yaml"
DIMENSIONS = {"r": "radius_mm", "d": "torsion_zone_mm"}  # of a string, by their letters
ALWAYS = " | "  # in what a letter is: before a value that is always the same
KEYS = {"reach": "reach_mm", "theta_c": "critical_turns"}  # numbers of the table above, by their letter
FUNCTIONS = {
    "sum": "over all i, one for each strength",
    "ln": "the natural logarithm",
    "exp": "e to the power of",
    "max": "the larger of both",
    "min": "the smaller of both",
    "sign": "1 or -1, as what it stands before",
}
SIGNS = {
    r"\[": "[ ]: 1 once what stands in it is so, 0 before",
    r"\bd[a-z_]+/dt": "d/dt: how fast something changes",
    r"''?": "': how fast something changes",
    r"-\+|\+-": "-+: the one or the other, see `sign`",
}

RESISTS = "resists the motion"  # where the reading is a force
SCALED = re.compile(r"\btan\(|\bhelix\b")  # what only a string has


def formula(mechanism: Mechanism, words: Vocabulary, shape: Iterable[str] = ()) -> str:
    """The equation of an effect, without a full stop; on a rig without a string, with its symbols explained.

    `shape` are its nonlinear parameters, which tell its variant.
    """
    of_kind = next((mechanism.variants[key] for key in shape if key in mechanism.variants), mechanism.equation)
    if words.twisted:
        return of_kind
    equation = mechanism.plain_equation or of_kind.replace("theta", "q")
    named = {"q": words.motion, "x": words.reading, "y": words.reading}
    meant = [f"{symbol}: the {word}" for symbol, word in named.items() if re.search(rf"\bd?{symbol}(_|\b)", equation)]
    return equation if mechanism.plain_equation or not meant else f"{equation}; {', '.join(meant)}"


def does(port: str, usual: str, words: Vocabulary) -> str:
    """What a coefficient does at a port; `usual` is the phrase for most rigs."""
    phrase = RESISTS if port == "resistance" and words.differentiates else usual
    return phrase.format(motion=words.motion, string=words.string, reading=words.reading)


def direction(factor: str) -> str:
    """The factor of a coefficient whose name has no share in it: the direction alone."""
    return f"{factor.partition(',')[0]} of motion, from -1 to 1"


def of_strings_alone(meaning: str, words: Vocabulary) -> bool:
    """Whether a number of the formula has a meaning only on rigs where something is twisted."""
    return not words.twisted and bool(SCALED.search(meaning))


def lines(equation: str, mechanism: Mechanism, words: Vocabulary, drivers: Drivers, numbers: Numbers) -> list[str]:
    """A row for each letter of an equation, and a line on its functions; `equation` is as `formula` gives it."""
    meanings = of_equation(equation, mechanism, words)
    rows = [["letter", "value", "what it is"]]
    for letter, meaning in meanings.items():
        what, _, always = meaning.partition(ALWAYS)
        own = what if meaning_of(what, mechanism) else KEYS.get(letter, "")
        value = always or _value(letter, own, meaning, mechanism, words, drivers, numbers)
        rows.append([letter, value, on_this_rig(own, mechanism, words) if own == what else what])
    used = functions(equation, mechanism)
    return [*(aligned(rows) if meanings else []), *([f"Signs: {'; '.join(used)}."] if used else [])]


def of_equation(equation: str, mechanism: Mechanism, words: Vocabulary) -> dict[str, str]:
    """The meaning of each letter of an equation, in the words of a rig; the equation's own rest may give some."""
    shown, own_words = split(equation)
    meanings = {**MEANT, **mechanism.letters, **own_words}
    letters = dict.fromkeys(_without_rate(letter, meanings) for letter in LETTER.findall(shown))
    return {letter: _on_rig(meanings[letter], words) for letter in letters if letter in meanings}


def split(equation: str) -> tuple[str, dict[str, str]]:
    """An equation without its explaining rest, and the meanings of letters that the rest gives."""
    shown, _, rest = equation.partition("; ")
    if not OWN.match(rest):
        return equation, {}
    _, *parts = OWN.split(rest)
    return shown, dict(zip(parts[::2], parts[1::2], strict=True))


def functions(equation: str, mechanism: Mechanism) -> list[str]:
    """What each function and sign of an equation does."""
    shown, used = split(equation)[0], LETTER.findall(equation)
    function_lines = [f"{name}: {does}" for name, does in FUNCTIONS.items() if name in used]
    return [
        *function_lines,
        *(does for sign, does in SIGNS.items() if re.search(sign, _without_primed(shown, mechanism))),
    ]


def _without_primed(equation: str, mechanism: Mechanism) -> str:
    """An equation without the letters that have a prime in their name."""
    for letter in (*MEANT, *mechanism.letters):
        equation = equation.replace(letter, "") if letter.endswith("'") else equation
    return equation


def _value(
    letter: str, key: str, meaning: str, mechanism: Mechanism, words: Vocabulary, drivers: Drivers, numbers: Numbers
) -> str:  # fmt: skip
    """The value of a letter with its unit: the range of a variable; else where the value stands, or how it is found."""
    if key in numbers.others:
        return numbers.others[key]
    if meaning_of(meaning, mechanism):
        return UNUSED
    if letter in mechanism.strengths:
        return rows(mechanism.rows.get(letter, ""), numbers)
    named = next((other for other in numbers.others if re.search(rf"\b{other}\b", meaning)), "")
    if named:
        return f"by {named}"
    if letter == "dx":
        return f"{size(numbers.rms, words.unit)} rms"
    if letter in mechanism.letters:
        return CALCULATED
    if letter in DIMENSIONS and DIMENSIONS[letter] in numbers.dimensions:
        return adopted(*numbers.dimensions[DIMENSIONS[letter]])
    return _of_recording(letter, words, drivers) or CALCULATED


def _of_recording(letter: str, words: Vocabulary, drivers: Drivers) -> str:
    """The range of a variable in the recording; for a dimension, where it stands; nothing for other letters."""
    load = drivers.units.load_size
    degrees = np.degrees(np.arctan(drivers.tangent))
    ranges: dict[str, tuple[Array, str]] = {
        "F": (load * drivers.load, drivers.units.load),
        "a": (degrees, "deg"),
        "c": (drivers.stroke - drivers.stroke.min(), "strokes"),
        "q": (drivers.motion, words.motion_unit),
        "t": (drivers.elapsed_s, "s"),
        "theta": (drivers.motion, words.motion_unit),
        "travel": (drivers.path, words.motion_unit),
        "v": (np.abs(drivers.rate), f"{words.motion_unit}/s"),
        "x": (drivers.contraction, words.unit),
    }
    if letter in ranges:
        values, unit = ranges[letter]
        low, high = float(values.min()), float(values.max())
        return f"{number(low, 3)} {said_unit(unit)}" if low == high else span(low, high, unit, high - low)
    return {"F_ref": quantity(load, drivers.units.load), "r": DIMENSION, "d": DIMENSION}.get(letter, "")


def _on_rig(meaning: str, words: Vocabulary) -> str:
    if words.twisted:
        return meaning
    return meaning.replace("twist", words.motion).replace("displacement", words.reading)


def _without_rate(letter: str, meanings: Mapping[str, str]) -> str:
    """The letter of a rate of change: `z_i` for `dz_i`, `q` for `q''`; a letter with its own meaning stays."""
    bare = letter.rstrip("'") if letter not in meanings else letter
    return bare.removeprefix("d") if bare not in meanings and bare.removeprefix("d") in meanings else bare
