"""An explanation that improves nothing on strokes that no fit has seen: whether it does not, and what is said then."""

import math

from ..content import Verdict
from . import holdout
from .level import NO_BETTER
from .unseen import WORSE, errors
from .vocabulary import Vocabulary


def harmful(content: Verdict, words: Vocabulary) -> bool:
    """Whether what is named makes the simulator worse on strokes that no fit has seen."""
    unseen_errors = errors(content, words)
    if unseen_errors is None or content["verdict"] not in ("explained", "ambiguous"):
        return False
    _, calibrated, explained = unseen_errors
    return explained > max(WORSE * calibrated, calibrated + 0.1 * float(content["fit"][f"noise_floor_{words.ending}"]))


def improves_nothing(content: Verdict, words: Vocabulary) -> bool:
    """Whether what is named makes the simulator no better on strokes that no fit has seen; worse is no better."""
    unseen_errors = errors(content, words)
    named = content["verdict"] in ("explained", "ambiguous")
    return named and unseen_errors is not None and unseen_errors[2] > NO_BETTER * unseen_errors[1]


def said(content: Verdict, words: Vocabulary) -> str:
    """What must stand beside each name and number of an explanation that improves nothing; ends a phrase, or nothing.

    It is the same wherever a reader may take a number from.
    """
    if not improves_nothing(content, words):
        return ""
    does = "makes the simulator worse" if harmful(content, words) else "improves nothing"
    small = ", and is too small to show there" if too_small(content, words) else ""
    return f"on the {holdout.strokes(content)} the explanation {does}{small}"


def doubt(content: Verdict, words: Vocabulary) -> str:
    """The same where it speaks against the explanation: what is too small to show is not doubted for that."""
    return "" if too_small(content, words) else said(content, words)


def too_small(content: Verdict, words: Vocabulary) -> bool:
    """Whether an explanation that improves nothing could not: all that was missing is little beside their noise."""
    unseen_errors, missing = errors(content, words), content["mismatch"]
    if unseen_errors is None or not missing or harmful(content, words) or not improves_nothing(content, words):
        return False
    _, calibrated, _ = unseen_errors
    least = math.sqrt(max(calibrated**2 - float(missing[f"rms_{words.ending}"]) ** 2, 0.0))
    return least > NO_BETTER * calibrated


def other_choice(content: Verdict) -> list[str]:
    """That the procedure chose other effects without the last strokes, where it did: what failed there is their fit."""
    chosen = content["evidence"].get("chosen_without_them")
    if chosen is None or set(chosen) == {entry["id"] for entry in content["mechanisms"]}:
        return []
    name = " + ".join(chosen) or "no effect"
    return [
        f"Without those strokes the same procedure chose {name}, and that is what errs there. So the recording is too "
        "short to choose, and what is named above has not been tried on strokes that it has not seen."
    ]
