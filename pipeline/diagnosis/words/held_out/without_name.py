"""A verdict that names no effect: whether dimensions moved without benefit, and whether adopted effects still hold."""

from ...document.content import Verdict
from ...document.made_keys import amount, amount_or_none
from ..language.vocabulary import Vocabulary
from . import unseen

LITTLE = 1.05  # times what the moved dimensions leave: who leaves no more without moving them gains nothing by it
UNNAMED = ("consistent", "parameters")


def kept_times(content: Verdict, words: Vocabulary) -> float:
    """The residual of the adopted simulator, in noise floors, where that explains the recording; else 0."""
    adopted_rms = amount_or_none(content["evidence"], f"adopted_{words.ending}")
    if content["verdict"] not in UNNAMED or adopted_rms is None:
        return 0.0
    ratio = float(adopted_rms) / amount(content["evidence"], f"floor_{words.ending}")
    return ratio if ratio <= unseen.STILL_MISSING else 0.0


def moved_in_vain(content: Verdict, words: Vocabulary) -> bool:
    """Whether moved dimensions bring the simulation hardly nearer to the recording."""
    before, after = (
        amount_or_none(content["evidence"], f"{name}_{words.ending}") for name in ("nominal", "calibrated")
    )
    return before is not None and after is not None and bool(before <= LITTLE * after)
