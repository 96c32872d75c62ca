"""The explanations that were weighed, in words: what ties, and why the others were beaten."""

from collections import Counter
from typing import Any

from . import probability
from .quantity import listing, size, times
from .reasons import why
from .vocabulary import Vocabulary

ALIKE = 1.05  # times what the best leaves: less is the same to the eye
MORE, LARGER = 1.1, 3.0  # times the mismatch: an effect that calibration hides in part, and for the most part
NOISY = 1.1  # noise floors: who leaves less has no more to explain
BENT = 0.95  # times what it leaves, that a slightly wrong formula must save to be worth a word
DIMENSIONS = "Dimensions"  # the heading under which they stand
ALLOWED = "If a true effect may differ from its formula by 10 % of its size"


def called(ids: list[str]) -> str:
    """An explanation's name."""
    return " + ".join(ids) or "calibration alone"


def entries(content: dict[str, Any], *standings: str) -> list[dict[str, Any]]:
    """Explanations of some standing, the best first."""
    return [one for one in reversed(content["evidence"]["explanations"]) if one["standing"] in standings]


def left_of(one: dict[str, Any], content: dict[str, Any], ending: str) -> float:
    """What an explanation leaves, rms; of calibration alone not what the search's approximation says, but the fit's."""
    known = content["evidence"].get(f"calibrated_{ending}") if not one["ids"] else None
    return float(one[f"left_{ending}"] if known is None else known)


def left(one: dict[str, Any], content: dict[str, Any], words: Vocabulary) -> str:
    """What an explanation leaves, and in noise floors."""
    rms, floor = left_of(one, content, words.ending), content["evidence"][f"floor_{words.ending}"]
    return f"{size(rms, words.unit)} rms ({times(rms / floor)} times the noise)"


def told(one: dict[str, Any], content: dict[str, Any], words: Vocabulary) -> str:
    """An explanation by its name with its probability, if it has one, and what it leaves; without a full stop."""
    likely = probability.said(one)
    return f"{called(one['ids'])}: {likely}{'; ' if likely else ''}leaves {left(one, content, words)}"


def shared(content: dict[str, Any]) -> str:
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


def ties(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """What is likely as well, a line each with why it is less so than the best one; then what bent formulas do."""
    shown = {tuple(one["ids"]): one for one in content["evidence"]["explanations"]}
    found = [shown.get(tuple(ids)) for ids in content["alternatives"]]
    best = next(iter(entries(content, "named")), None)
    lines = [
        " ".join(
            part for part in (f"{told(one, content, words) if one else called(ids)}.", why(one or {}, best)) if part
        )
        for ids, one in zip(content["alternatives"], found, strict=True)
    ]
    all_bent = {called(one["ids"]): _bent(one, content, words) for one in found if one}
    bent = {name: ratio for name, ratio in all_bent.items() if ratio is not None}
    if bent and not all_below_noise(content, words.ending):
        who = listing([f"({name})" if len(bent) > 1 else name for name in bent])
        ends = list(dict.fromkeys(times(ratio) for ratio in (min(bent.values()), max(bent.values()))))
        leave = "leave" if len(bent) > 1 else "leaves"
        lines.append(f"{ALLOWED}, {who} {leave} {' to '.join(ends)} times the noise.")
    return lines


def all_below_noise(content: dict[str, Any], ending: str) -> bool:
    """Whether every explanation comes below the noise if its formulas may be a little wrong: that decides nothing."""
    floor = content["evidence"][f"floor_{ending}"]
    bent = [one[f"bent_{ending}"] for one in content["evidence"]["explanations"] if one["ids"]]
    return len(bent) > 1 and max(bent) < floor


def _bent(one: dict[str, Any], content: dict[str, Any], words: Vocabulary) -> float | None:
    """What is left, in noise floors, if the true effects may differ a little from the formulas; None where no less."""
    mine, bent = one[f"left_{words.ending}"], one[f"bent_{words.ending}"]
    floor = content["evidence"][f"floor_{words.ending}"]
    return None if bent > BENT * mine or mine < NOISY * floor else float(bent / floor)


def what_is_left(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """What the named explanation leaves of the recording, and what it would if its formulas were a little wrong."""
    who, lines = "Together they leave" if len(content["mechanisms"]) > 1 else "It leaves", []
    for one in entries(content, "named"):
        lines.append(f"{who} {left(one, content, words)}.")
        bent = _bent(one, content, words)
        if bent is not None and not all_below_noise(content, words.ending):
            lines.append(f"{ALLOWED}, {times(bent)} times the noise is left.")
    return lines


def hidden(content: dict[str, Any], words: Vocabulary) -> dict[str, str]:
    """Effects that are larger than what is missing, and where the rest of each is hidden."""
    whole, lines = content["mismatch"][f"rms_{words.ending}"] if content["mismatch"] else 0.0, {}
    for entry in content["mechanisms"]:
        own = entry[f"rms_{words.ending}"]["value"]
        if not whole or own <= MORE * whole:
            continue
        others = ", and in the other effects" if len(content["mechanisms"]) > 1 else ""
        unsure = "Its size is poorly known: it" if own > LARGER * whole else "It"
        lines[entry["id"]] = (
            f"{unsure} moves the reading by {size(own, words.unit)} rms, but only {size(whole, words.unit)} rms is "
            f"missing. The rest hides in dimensions that calibration moved (see {DIMENSIONS}){others}."
        )
    return lines
