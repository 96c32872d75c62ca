"""Explanations that improve nothing on strokes that no fit has seen: the tests for them, and the words."""

import math

from ...document.content import Verdict
from ...document.made_keys import amount
from ...study.heldout import WORSE
from ..language.quantity import first_upper, size
from ..language.vocabulary import Vocabulary
from . import holdout
from .level import NO_BETTER
from .unseen import errors, other_fails

SMALL = ", and is too small to show there"


def harmful(content: Verdict, words: Vocabulary) -> bool:
    """Whether the named effects make the simulator worse on strokes that no fit has seen."""
    unseen_errors = errors(content, words)
    if unseen_errors is None or content["verdict"] not in ("explained", "ambiguous"):
        return False
    _, calibrated, explained = unseen_errors
    return explained > max(WORSE * calibrated, calibrated + 0.1 * amount(content["fit"], f"noise_floor_{words.ending}"))


def improves_nothing(content: Verdict, words: Vocabulary) -> bool:
    """Whether the named effects make the simulator no better on strokes that no fit has seen."""
    unseen_errors = errors(content, words)
    named = content["verdict"] in ("explained", "ambiguous")
    return named and unseen_errors is not None and unseen_errors[2] > NO_BETTER * unseen_errors[1]


def said(content: Verdict, words: Vocabulary) -> str:
    """The remark beside each name and number of an explanation that improves nothing; ends a phrase, or is empty.

    It is the same wherever a reader may take a number from.
    """
    if not improves_nothing(content, words):
        return ""
    if holdout.other_name(content) == holdout.NO_EFFECT:
        return f"on the {holdout.strokes(content)} nothing was tried, for without them the procedure names no effect"
    does = "makes the simulator worse" if harmful(content, words) else "improves nothing"
    return f"on the {holdout.strokes(content)} {tried(content)} {does}{too_small(content, words) * SMALL}"


def doubt(content: Verdict, words: Vocabulary) -> str:
    """The remark of `said` where it counts against the explanation; empty where effects are too small to show.

    Where other effects were named without the last strokes, these failed there, and that is the doubt.
    """
    if harmful(content, words) and holdout.of_other(content):
        return holdout.settled_otherwise(content)
    return "" if too_small(content, words) else said(content, words)


def too_small(content: Verdict, words: Vocabulary) -> bool:
    """Whether an explanation had no chance to improve: the whole mismatch is small beside the noise there."""
    unseen_errors, missing = errors(content, words), content["mismatch"]
    if unseen_errors is None or not missing or harmful(content, words) or not improves_nothing(content, words):
        return False
    _, calibrated, _ = unseen_errors
    least = math.sqrt(max(calibrated**2 - amount(missing, f"rms_{words.ending}") ** 2, 0.0))
    return least > NO_BETTER * calibrated


def tried(content: Verdict) -> str:
    """The effects that were tried on unseen strokes: the explanation, or the effects named without those strokes."""
    return holdout.of_other(content) or "the explanation"


def unsettled(content: Verdict, words: Vocabulary) -> list[str]:
    """The remark that the error on the last strokes belongs to other effects than the named; else nothing."""
    other, unseen_errors = holdout.other_name(content), errors(content, words)
    none = other == holdout.NO_EFFECT
    if not other or not content["mechanisms"] or unseen_errors is None or (none and said(content, words)):
        return []
    best, count = holdout.named(content), 1 + len(content["alternatives"])
    error = f"the error on the {holdout.strokes(content)} ({size(unseen_errors[2], words.unit)}) is that of"
    without = f"Without the {holdout.split(content)} the procedure names"
    if none and (closest := holdout.closest(content)):
        which = "the same effects, which come" if holdout.closest_is_named(content) else f"{closest}, which comes"
        return [f"{without} no effect, so the name {best} is not settled; {error} {which} closest there."]
    if none:
        return [f"{without} no effect, so the name {best} is not settled, and {error} calibration alone."]
    if other_fails(content, words):
        return [f"{first_upper(error)} {other}, not of {best}. A longer recording can settle the name."]
    foretold = f"that misses the {holdout.strokes(content)} by {size(unseen_errors[2], words.unit)}"
    end = f"{foretold}. {best} was not tried on them, and its error there is not known."
    if set(other.split(" + ")) in map(set, content["alternatives"]):
        return [f"{without} {other}, another of the {count} likely explanations, and {end}"]
    return [f"{without} {other}, and {end} A longer recording can settle the name."]


def other_choice(content: Verdict) -> list[str]:
    """The remark that the recording is too short to choose, if other effects were chosen without the last strokes."""
    if not holdout.other_name(content):
        return []
    return ["So the recording is too short to choose."]
