"""The explanations that were weighed, in words: what ties, and why the others were beaten."""

from collections import Counter

from ...document.content import Part, Verdict
from ..language.quantity import listing, size, times
from ..language.vocabulary import Vocabulary
from . import probability
from .reasons import why

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


def entries(content: Verdict, *standings: str) -> list[Part]:
    """Explanations of some standing, the best first."""
    return [
        explanation
        for explanation in reversed(content["evidence"]["explanations"])
        if explanation["standing"] in standings
    ]


def left_of(explanation: Part, content: Verdict, ending: str) -> float:
    """What an explanation leaves, rms; of calibration alone not what the search's approximation says, but the fit's."""
    known = content["evidence"].get(f"calibrated_{ending}") if not explanation["ids"] else None
    return float(explanation[f"left_{ending}"] if known is None else known)


def left(explanation: Part, content: Verdict, words: Vocabulary) -> str:
    """What an explanation leaves, and in noise floors."""
    rms, floor = left_of(explanation, content, words.ending), content["evidence"][f"floor_{words.ending}"]
    return f"{size(rms, words.unit)} rms ({times(rms / floor)} times the noise)"


def told(explanation: Part, content: Verdict, words: Vocabulary) -> str:
    """An explanation by its name with its probability, if it has one, and what it leaves; without a full stop."""
    likely = probability.said(explanation)
    leaves = NO_LESS if no_less(explanation, content, words) else f"leaves {left(explanation, content, words)}"
    return f"{called(explanation['ids'])}: {likely}{'; ' if likely else ''}{leaves}"


def no_less(explanation: Part, content: Verdict, words: Vocabulary) -> bool:
    """Whether an explanation leaves as much as calibration alone, or even more; False in an older file."""
    alone, ids = content["evidence"].get(f"calibrated_{words.ending}"), explanation["ids"]
    return bool(alone and ids and explanation[f"left_{words.ending}"] >= LITTLE * alone)


def shared(content: Verdict) -> str:
    """What all that tie have in common, or most of them."""
    sets = [[entry["id"] for entry in content["mechanisms"]], *content["alternatives"]]
    count = len(sets)
    common = [id_ for id_ in sets[0] if all(id_ in ids for ids in sets)]
    if common:
        every = (
            f"Both explanations have {listing(common)}"
            if count == 2
            else f"All {count} explanations have {listing(common)}"
        )
        return f"{every}. {'The other one is' if count == 2 else 'The others, one a line, are'}:"
    often = Counter(id_ for ids in sets for id_ in ids).most_common(1)[0]
    if 2 * often[1] > count > 2:
        return (
            f"{often[1]} of the {count} explanations have {often[0]}; no mechanism is in all of them. The others are:"
        )
    who = "two explanations have" if count == 2 else f"{count} explanations have"
    return f"The {who} no mechanism in common: any of these effects may be the missing one."


def ties(content: Verdict, words: Vocabulary) -> list[str]:
    """What is likely as well, a line each with why it is less so than the best one; then what a discrepancy does."""
    shown = {tuple(explanation["ids"]): explanation for explanation in content["evidence"]["explanations"]}
    tied = [shown.get(tuple(ids)) for ids in content["alternatives"]]
    first = next(iter(entries(content, "named")), None)
    lines = [
        " ".join(
            part
            for part in (
                f"{told(explanation, content, words) if explanation else called(ids)}.",
                why(explanation or {}, first),
            )
            if part
        )
        for ids, explanation in zip(content["alternatives"], tied, strict=True)
    ]
    all_ratios = {
        called(explanation["ids"]): _with_discrepancy(explanation, content, words)
        for explanation in tied
        if explanation
    }
    ratios = {name: ratio for name, ratio in all_ratios.items() if ratio is not None}
    if ratios and not all_below_noise(content, words.ending):
        who = listing([f"({name})" if len(ratios) > 1 else name for name in ratios])
        ends = list(dict.fromkeys(times(ratio) for ratio in (min(ratios.values()), max(ratios.values()))))
        leave = "leave" if len(ratios) > 1 else "leaves"
        lines.append(f"{ALLOWED}, {who} {leave} {' to '.join(ends)} times the noise.")
    return lines


def all_below_noise(content: Verdict, ending: str) -> bool:
    """Whether every explanation comes below the noise if its formulas may be a little wrong: that decides nothing."""
    floor = content["evidence"][f"floor_{ending}"]
    with_discrepancy = [
        explanation[f"bent_{ending}"] for explanation in content["evidence"]["explanations"] if explanation["ids"]
    ]
    return len(with_discrepancy) > 1 and max(with_discrepancy) < floor


def _with_discrepancy(explanation: Part, content: Verdict, words: Vocabulary) -> float | None:
    """What is left, in noise floors, if the true effects may differ a little from the formulas; None where no less."""
    mine, with_discrepancy = explanation[f"left_{words.ending}"], explanation[f"bent_{words.ending}"]
    floor = content["evidence"][f"floor_{words.ending}"]
    return None if with_discrepancy > WORTH_SAYING * mine or mine < NOISY * floor else float(with_discrepancy / floor)


def what_is_left(content: Verdict, words: Vocabulary) -> list[str]:
    """What the named explanation leaves of the recording, and what it would if its formulas were a little wrong."""
    lines = []
    for explanation in entries(content, "named"):
        lines.append(f"{called(explanation['ids'])} leaves {left(explanation, content, words)}.")
        with_discrepancy = _with_discrepancy(explanation, content, words)
        if with_discrepancy is not None and not all_below_noise(content, words.ending):
            lines.append(f"{ALLOWED}, {called(explanation['ids'])} leaves {times(with_discrepancy)} times the noise.")
    return lines


def hidden(content: Verdict, words: Vocabulary) -> dict[str, str]:
    """Effects that are larger than what is missing, and where the rest of each is hidden."""
    whole, lines = content["mismatch"][f"rms_{words.ending}"] if content["mismatch"] else 0.0, {}
    for entry in content["mechanisms"]:
        own = entry[f"rms_{words.ending}"]["value"]
        if not whole or own <= MORE * whole:
            continue
        others = ", and in the other effects" if len(content["mechanisms"]) > 1 else ""
        unsure = "Its size is no surer than the dimensions: it" if own > LARGER * whole else "It"
        lines[entry["id"]] = (
            f"{unsure} moves the reading by {size(own, words.unit)} rms, but only {size(whole, words.unit)} rms is "
            f"missing. Much of it hides in dimensions that calibration moved (see {DIMENSIONS}){others}."
        )
    return lines
