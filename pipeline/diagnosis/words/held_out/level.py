"""The level that physics has to reach: what a regression without physics foretells of unseen strokes, in words."""

from ...document.content import Verdict
from ...document.made_keys import amount, amount_or_none
from ..language.places import EVERYWHERE, place
from ..language.quantity import size
from ..language.vocabulary import Vocabulary
from . import holdout

BETTER = 2.0 / 3.0  # times the error of the verdict's simulator: a regression below finds what the physics misses
NO_BETTER = 0.95  # times the other error: who errs by more improves nothing
METHOD = "A regression without physics (boosted trees over all that was recorded)"


def beaten(content: Verdict, words: Vocabulary) -> list[str]:
    """Whether and where a regression foretells unseen strokes better than the verdict's simulator, in words."""
    errors = _errors(content, words)
    if errors is None or content["verdict"] == "unknown" or errors[1] > BETTER * errors[0]:
        return []
    who = "the explanation" if content["verdict"] in ("explained", "ambiguous") else "the calibrated simulator"
    who = holdout.of_other(content) or who
    own, without = (f"{size(error, words.unit)} rms" for error in errors)
    floor = amount(content["fit"], f"noise_floor_{words.ending}")
    noise = f" So it is partly counted in the noise of {size(floor, words.unit)}." if errors[1] < floor else ""
    return [
        f"{METHOD} foretells the {holdout.strokes(content)} better than {who}: {without} against {own}. "
        f"What it foretells of them beyond {who}: {_where(content, words)}.{noise}"
    ]


def place_of_missing(content: Verdict, words: Vocabulary) -> str:
    """Where the part of the error on unseen strokes lies that a regression foretells, and which driver it follows.

    Returns a sentence. It is empty where a regression foretells no more than the verdict's simulator, and where
    `beaten` says it already.
    """
    errors = _errors(content, words)
    if errors is None or errors[1] > NO_BETTER * errors[0] or beaten(content, words):
        return ""
    return f"What a regression without physics foretells of it: {_where(content, words)}."


def to_reach(content: Verdict, words: Vocabulary) -> list[str]:
    """How much of an unknown mismatch a regression can foretell, and from which driver."""
    errors = _errors(content, words)
    if errors is None:
        return []
    own, without = (f"{size(error, words.unit)} rms" for error in errors)
    who = holdout.closest(content) or holdout.of_other(content) or "calibration"
    errs = f"{METHOD} errs by {without} on the {holdout.strokes(content)}, {who} by {own}"
    if errors[1] > NO_BETTER * errors[0]:
        return [f"{errs}: it does no better, so nothing that was recorded foretells more of it."]
    return [f"{errs}. That is the level which physics still has to reach: {_where(content, words)}."]


def _errors(content: Verdict, words: Vocabulary) -> tuple[float, float] | None:
    """The error of the verdict's simulator on unseen strokes, and that of a regression; None where none was asked."""
    heldout = content["fit"]["heldout"]
    without = amount_or_none(heldout or {}, f"without_physics_{words.ending}")
    return None if heldout is None or without is None else (amount(heldout, f"explained_{words.ending}"), without)


def _where(content: Verdict, words: Vocabulary) -> str:
    """Where the part lies that the regression adds, and the driver that it follows."""
    remainder = content["evidence"]["left_of_unseen"]
    where = place(remainder["location"], content["evidence"], words)
    lies = "it is spread over these strokes" if where == EVERYWHERE else f"most of it lies {where}"
    return f"{lies}, and it follows {words.follows(remainder['driver'], content['evidence']['loaded'])}"
