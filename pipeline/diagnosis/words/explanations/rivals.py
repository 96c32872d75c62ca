"""The explanations that were weighed, in words: which ones tie, and why the others were beaten."""

from ...document.content import Verdict, left_with_discrepancy
from ...document.explanations import ExplanationEntry
from ...document.made_keys import amount, amount_or_none
from ..language.quantity import size, times
from ..language.vocabulary import Vocabulary

LITTLE = 0.98  # times what calibration alone leaves: who leaves more explains nothing
NO_LESS = "leaves as much as no effect does"  # a fit that leaves more did not find its best
ALIKE = 1.05  # times what the best leaves: less is the same to the eye
MORE, LARGER = 1.1, 3.0  # times the mismatch: an effect that calibration hides in part, and for the most part
NOISY = 1.1  # noise floors: who leaves less has no more to explain
WORTH_SAYING = 0.95  # of what it leaves: a slightly wrong formula must leave less to be worth a word
DIMENSIONS = "Dimensions"  # the heading under which they stand
ALLOWED = "If a true effect may differ from its formula by 10 % of its size"


def called(ids: list[str]) -> str:
    """An explanation's name."""
    return " + ".join(ids) or "calibration alone"


def entries(content: Verdict, *standings: str) -> list[ExplanationEntry]:
    """Explanations of some standing, the best first."""
    return [
        explanation
        for explanation in reversed(content["evidence"]["explanations"])
        if explanation["standing"] in standings
    ]


def left_of(explanation: ExplanationEntry, content: Verdict, ending: str) -> float:
    """The rms that an explanation leaves; for calibration alone, the fit's number, not the search's approximation.

    Of effects that were fitted worse than some of them alone it is what these leave: the others could do nothing.
    """
    ids = set(explanation["ids"])
    parts = [each for each in content["evidence"]["explanations"] if each["ids"] and set(each["ids"]) < ids]
    calibrated_rms = amount_or_none(content["evidence"], f"calibrated_{ending}")
    alone = [float(calibrated_rms)] if calibrated_rms is not None else []
    own = [] if alone and not ids else [amount(explanation, f"left_{ending}")]
    return min([*own, *alone, *(amount(each, f"left_{ending}") for each in parts)])


def left(explanation: ExplanationEntry, content: Verdict, words: Vocabulary) -> str:
    """The rms that an explanation leaves, also in noise floors."""
    rms, floor = left_of(explanation, content, words.ending), amount(content["evidence"], f"floor_{words.ending}")
    return f"{size(rms, words.unit)} rms ({times(rms / floor)} times the noise)"


def no_less(explanation: ExplanationEntry, content: Verdict, words: Vocabulary) -> bool:
    """Whether an explanation leaves as much as calibration alone, or even more; False in an older file."""
    alone, ids = amount_or_none(content["evidence"], f"calibrated_{words.ending}"), explanation["ids"]
    return bool(alone and ids and amount(explanation, f"left_{words.ending}") >= LITTLE * alone)


def all_below_noise(content: Verdict, ending: str) -> bool:
    """Whether every explanation comes below the noise if its formulas may be a little wrong: none decides then."""
    floor = amount(content["evidence"], f"floor_{ending}")
    with_discrepancy = [
        left_with_discrepancy(explanation, ending)
        for explanation in content["evidence"]["explanations"]
        if explanation["ids"]
    ]
    return len(with_discrepancy) > 1 and max(with_discrepancy) < floor


def with_discrepancy(explanation: ExplanationEntry, content: Verdict, words: Vocabulary) -> float | None:
    """The residual in noise floors if true effects differ a little from the formulas; None where no less."""
    mine, with_discrepancy = (
        amount(explanation, f"left_{words.ending}"),
        left_with_discrepancy(explanation, words.ending),
    )
    floor = amount(content["evidence"], f"floor_{words.ending}")
    return None if with_discrepancy > WORTH_SAYING * mine or mine < NOISY * floor else float(with_discrepancy / floor)
