"""The explanations that were weighed, in words: what ties, and why the others were beaten."""

import math
from typing import Any

from pipeline.diagnosis.search import EXPLAINED
from pipeline.diagnosis.words.places import EVERYWHERE, place
from pipeline.diagnosis.words.quantity import listing, size, times
from pipeline.diagnosis.words.vocabulary import Vocabulary

ALIKE = 1.05  # times what the best leaves: less is the same to the eye
MORE, LARGER = 1.1, 3.0  # times the mismatch: an effect that calibration hides in part, and for the most part
NOISY = 1.1  # noise floors: who leaves less has no more to explain
BENT = 0.95  # times what it leaves, that a slightly wrong formula must save to be worth a word
VISIBLE = 0.4  # noise floors: smaller gains need no further word
CLOSEST = 4  # explanations that are shown where none does
SHOWN = 8  # of those that were beaten


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


def briefly(one: dict[str, Any], content: dict[str, Any], ending: str) -> str:
    """Why an explanation that leaves as little as the best was beaten all the same, in a few words; else nothing."""
    first = next(iter(entries(content, "named")), None)
    if one["standing"] != "beaten" or first is None or one[f"left_{ending}"] > ALIKE * first[f"left_{ending}"]:
        return ""
    if one["worse"] > 0.0:
        return f"less likely by {times(math.sqrt(one['worse']))} σ"
    return "a balance" if one.get("balanced") else "not preferred"


def shared(content: dict[str, Any]) -> str:
    """What all that tie have in common, and in what they differ."""
    sets = [[entry["id"] for entry in content["mechanisms"]], *content["alternatives"]]
    common = [id_ for id_ in sets[0] if all(id_ in ids for ids in sets)]
    if not common:
        who = "two explanations have" if len(sets) == 2 else f"{len(sets)} explanations have"
        return f"The {who} no mechanism in common: any of these effects may be the missing one."
    every = "Both" if len(sets) == 2 else f"All {len(sets)}"
    rests = [" + ".join(id_ for id_ in ids if id_ not in common) or "nothing more" for ids in sets]
    differ = f"They differ in what they add to {'it' if len(common) == 1 else 'them'}"
    return f"{every} explanations have {listing(common)}. {differ}: {'; or '.join(rests)}."


def ties(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """What cannot be ruled out, a line each with what it leaves."""
    shown = {tuple(one["ids"]): one for one in content["evidence"]["explanations"]}
    lines = []
    for ids in content["alternatives"]:
        one = shown.get(tuple(ids))
        lines.append(f"{called(ids)}{': leaves ' + _bent(one, content, words) if one else ''}.")
    return lines


def _bent(one: dict[str, Any], content: dict[str, Any], words: Vocabulary) -> str:
    """What a tie leaves, and what it would leave if its formulas were a little wrong, where that is why it ties."""
    said, bent = left(one, content, words), one[f"bent_{words.ending}"]
    floor = content["evidence"][f"floor_{words.ending}"]
    if bent > BENT * one[f"left_{words.ending}"] or one[f"left_{words.ending}"] < NOISY * floor:
        return said
    formula = f"formula of {one['ids'][0]} is" if len(one["ids"]) == 1 else f"formulas of {listing(one['ids'])} are"
    return f"{said}. The {formula} not exact: if wrong by 10 %, only {times(bent / floor)} times the noise is left"


def what_is_left(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """What the named explanation leaves of the recording."""
    who = "Together they leave" if len(content["mechanisms"]) > 1 else "It leaves"
    return [f"{who} {_bent(one, content, words)}." for one in entries(content, "named")]


def hidden(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """Effects that are larger than what is missing, and where the rest of them is hidden."""
    whole, lines = content["mismatch"][f"rms_{words.ending}"] if content["mismatch"] else 0.0, []
    for entry in content["mechanisms"]:
        own = entry[f"rms_{words.ending}"]["value"]
        if not whole or own <= MORE * whole:
            continue
        sizes = f"by {size(own, words.unit)} rms, but only {size(whole, words.unit)} rms is missing"
        others = ", and in the other effects" if len(content["mechanisms"]) > 1 else ""
        said = f"{entry['id']} moves the reading {sizes}. The rest hides in dimensions that calibration moved{others}."
        unsure = " So this recording tells badly how large it is." if own > LARGER * whole else ""
        lines.append(said + unsure)
    return lines


def beaten(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """Why each explanation that was beaten was: how much worse it is, where, and following what."""
    first = next(iter(entries(content, "named", "not enough")), None)
    found = [one for one in entries(content, "beaten") if one is not first][:SHOWN]
    lines = [_beaten(one, first, content, words) for one in found if first]
    lines += [_not_needed(one, content, words) for one in entries(content, "not needed")[: SHOWN - len(lines)]]
    lines += [f"{called([])}: leaves {left(one, content, words)}." for one in entries(content, "nothing")]
    return lines


def insufficient(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """What comes closest where nothing explains, with the share of the mismatch's energy that it takes."""
    ending, floor = words.ending, content["evidence"][f"floor_{words.ending}"]
    nothing = next(iter(entries(content, "nothing")), None)
    if nothing is None:
        return []
    energy, lines = nothing[f"left_{ending}"] ** 2 - floor**2, []
    for one in entries(content, "not enough", "beaten", "not needed")[:CLOSEST]:
        taken = (nothing[f"left_{ending}"] ** 2 - one[f"left_{ending}"] ** 2) / energy if energy > 0.0 else 0.0
        said = f"{called(one['ids'])}: takes {100.0 * min(max(taken, 0.0), 1.0):.0f} % of the mismatch's energy"
        helper = all(id_.startswith("x_") for id_ in one["ids"])
        lines.append(f"{said}{', and is no physics of the library' if helper else ''}.")
    return [*lines, f"{100.0 * EXPLAINED:.0f} % make an explanation."]


def _beaten(one: dict[str, Any], first: dict[str, Any], content: dict[str, Any], words: Vocabulary) -> str:
    ending = words.ending
    said = f"{called(one['ids'])}: leaves {left(one, content, words)}"
    where = place(one["location"], content["evidence"], words)
    where = where if where == EVERYWHERE else f"mostly {where}"
    follows = f" This difference follows {words.follows(one['driver'])}." if one["driver"] else ""
    gap = size(one[f"gap_{ending}"], words.unit)
    differs = f"Its prediction differs from the best one by {gap} rms, {where}.{follows}"
    if one[f"left_{ending}"] > ALIKE * first[f"left_{ending}"]:
        return f"{said}. {differs}"
    if one["worse"] > 0.0:
        far = f"by {times(math.sqrt(one['worse']))} standard deviations"
        less = f"Weighed sample by sample, the best one is nearer to the recording {far}"
        return f"{said}, {_beside(one, first, words)}. {less}. {differs}"
    if one.get("balanced"):
        return f"{said}. Its effects are large and cancel each other almost fully: that is no explanation."
    return f"{said}, {_beside(one, first, words)}. The search prefers the best one all the same. {differs}"


def _beside(one: dict[str, Any], first: dict[str, Any], words: Vocabulary) -> str:
    """What an explanation leaves beside what the best one does, which is hardly another size."""
    mine, best = (size(each[f"left_{words.ending}"], words.unit) for each in (one, first))
    if mine == best:
        return "the same as the best one"
    more = one[f"left_{words.ending}"] > first[f"left_{words.ending}"]
    return f"{'hardly more' if more else 'even less'} than the best one ({best})"


def _saved(base: dict[str, Any], one: dict[str, Any], key: str) -> float:
    """What a larger explanation takes away of what a smaller one leaves, rms."""
    return math.sqrt(max(base[key] ** 2 - one[key] ** 2, 0.0))


def _not_needed(one: dict[str, Any], content: dict[str, Any], words: Vocabulary) -> str:
    """What a larger explanation takes away beyond the one that it contains."""
    ending, shown = words.ending, content["evidence"]["explanations"]
    smaller = [other for other in shown if set(other["ids"]) < set(one["ids"]) and other["standing"] != "not needed"]
    base = min(smaller, key=lambda other: float(other[f"left_{ending}"]), default=None)
    if base is None:
        said = f"{called(one['ids'])}: leaves {left(one, content, words)}"
        return f"{said}: too little less for one mechanism more."
    saved, bent = (_saved(base, one, f"{key}_{ending}") for key in ("left", "bent"))
    further = [id_ for id_ in one["ids"] if id_ not in base["ids"]]
    if not saved:
        return f"{listing(further)}, added to {called(base['ids'])}: explains nothing more."
    more = f"explains {size(saved, words.unit)} rms more"
    if saved > VISIBLE * content["evidence"][f"floor_{ending}"] and bent < saved:
        more += f" ({size(bent, words.unit)} if the formulas are 10 % wrong)"
    more += ". That is too little to count"
    return f"{listing(further)}, added to {called(base['ids'])}: {more}."
