"""The formula of an effect in the words of a rig, letter by letter, and its numbers where nothing is twisted."""

import re
from collections.abc import Iterable, Mapping

from ...mechanisms.interface import Mechanism
from ..language.vocabulary import Vocabulary

RESISTS = "resists the motion"  # where the reading is a force
SCALED = re.compile(r"\btan\(|\bhelix\b")  # what only a string has
LETTER = re.compile(r"(?<![A-Za-z0-9_])[A-Za-z]+(?:_[A-Za-z0-9]+)?[0-9]?'*(?![A-Za-z0-9_])")
MEANT = {
    "A": "the height of the ripple",
    "F": "the load",
    "F_ref": "the load at which the numbers hold",
    "K": "the stiffness of the string",
    "P": "how much longer the string is for good",
    "T": "the temperature",
    "a": "the helix angle, between a string and the axis",
    "c": "the strokes worked so far",
    "d": "the torsion zone",
    "delay": "by how much the reading is late",
    "dx": "what the effect adds to the displacement",
    "k": "the strength, from the first rows of the table",
    "p": "where in the turn the ripple begins",
    "r": "the radius of the string",
    "r_e": "the radius that acts",
    "reach": "how far the reading falls behind before it slips",
    "t": "the time",
    "tau": "a time constant",
    "theta": "the twist of the motor",
    "theta'": "the twist after the play",
    "theta_c": "the critical twist",
    "theta_s": "the twist that the string sees",
    "travel": "the distance travelled so far",
    "x": "the displacement, by the dimensions alone",
    "x_m": "the displacement that the sensor reads",
}


def formula(mechanism: Mechanism, words: Vocabulary, shape: Iterable[str] = ()) -> str:
    """The equation of an effect, without a full stop; of a rig without a string with what its symbols are.

    `shape` are its nonlinear parameters, which tell of which kind it is.
    """
    if words.twisted:
        return next((mechanism.variants[key] for key in shape if key in mechanism.variants), mechanism.equation)
    equation = mechanism.plain_equation or mechanism.equation.replace("theta", "q")
    named = {"q": words.motion, "x": words.reading, "y": words.reading}
    meant = [f"{symbol}: the {word}" for symbol, word in named.items() if re.search(rf"\bd?{symbol}(_|\b)", equation)]
    return equation if mechanism.plain_equation or not meant else f"{equation}; {', '.join(meant)}"


def does(port: str, usual: str, words: Vocabulary) -> str:
    """What a coefficient does at a port; `usual` is what it does on most rigs."""
    phrase = RESISTS if port == "resistance" and words.differentiates else usual
    return phrase.format(motion=words.motion, string=words.string, reading=words.reading)


def direction(factor: str) -> str:
    """What a coefficient multiplies whose name has no share in it: the direction alone."""
    return f"{factor.partition(',')[0]} of motion, from -1 to 1"


def of_strings_alone(meaning: str, words: Vocabulary) -> bool:
    """Whether a number of the formula means nothing on a rig, since nothing is twisted there."""
    return not words.twisted and bool(SCALED.search(meaning))


def letter_by_letter(equation: str, mechanism: Mechanism, words: Vocabulary) -> str:
    """Each letter of a formula with what it is, in one sentence; empty where none is known.

    On a rig without a string the formula itself says what its motion and its reading are, or all that it has.
    """
    if not words.twisted and mechanism.plain_equation:
        return ""
    meanings = {**MEANT, **mechanism.letters}
    letters = dict.fromkeys(_without_rate(letter, meanings) for letter in LETTER.findall(equation))
    known = [letter for letter in letters if letter in meanings]
    known = known if words.twisted else [letter for letter in known if letter not in ("q", "x", "y", "dx")]
    line = f"In it: {'; '.join(f'{letter}: {meanings[letter]}' for letter in known)}." if known else ""
    return line if words.twisted else line.replace("twist", words.motion).replace("displacement", words.reading)


def _without_rate(letter: str, meanings: Mapping[str, str]) -> str:
    """The letter whose rate of change one is: `z_i` of `dz_i`, `q` of `q''`; one that has a meaning stays."""
    bare = letter.rstrip("'") if letter not in meanings else letter
    return bare.removeprefix("d") if bare not in meanings and bare.removeprefix("d") in meanings else bare
