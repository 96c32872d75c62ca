"""The formula of an effect in the words of a rig, and what its numbers do where nothing is twisted."""

import re

from ...mechanisms.interface import Mechanism
from ..language.vocabulary import Vocabulary

RESISTS = "resists the motion"  # where the reading is a force
SCALED = re.compile(r"\btan\(|\bhelix\b")  # what only a string has


def formula(mechanism: Mechanism, words: Vocabulary) -> str:
    """The equation of an effect, without a full stop; of a rig without a string with what its symbols are."""
    if words.twisted:
        return mechanism.equation
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
