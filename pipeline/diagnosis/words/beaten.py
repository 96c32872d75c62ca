"""Why each explanation that was beaten was, and what comes closest where none explains, in words."""

import math
from typing import Any

from ..interface import physics
from ..search import EXPLAINED
from . import probability
from .places import EVERYWHERE, place
from .quantity import listing, size, times
from .reasons import why
from .rivals import ALIKE, ALLOWED, called, entries, left, told
from .vocabulary import Vocabulary

CLOSEST = 4  # explanations that are shown where none does
SHOWN = 8  # of those that were beaten
RARE = 0.005  # a probability below which an explanation needs no further word
VISIBLE = 0.4  # noise floors: smaller gains need no further word
UNWEIGHED = "It was not weighed: the recording lacks a mark of its effects, or cheaper ones of its size are many. "


def beaten(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """Why each explanation that was beaten was: how much worse it is, where, and following what."""
    first = next(iter(entries(content, "named", "not enough")), None)
    found = likeliest([one for one in entries(content, "beaten") if one is not first])[:SHOWN]
    lines = [with_why(_beaten(one, first, content, words), one, first) for one in found if first]
    larger = likeliest(entries(content, "not needed"))[: SHOWN - len(lines)]
    lines += [with_why(_not_needed(one, content, words), one, first) for one in larger]
    lines += [f"{called([])}: leaves {left(one, content, words)}." for one in entries(content, "nothing")]
    return lines


def with_why(said: str, one: dict[str, Any], first: dict[str, Any] | None) -> str:
    """What is said of an explanation, and then why it is less likely than the first one."""
    return " ".join(part for part in (said, why(one, first)) if part)


def likeliest(some: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Explanations by falling probability; those without one as they came, last."""
    return sorted(some, key=lambda one: -(one.get("probability") or 0.0))


def insufficient(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """What comes closest where nothing explains, with the share of the mismatch's energy that it takes."""
    ending, floor = words.ending, content["evidence"][f"floor_{words.ending}"]
    nothing = next(iter(entries(content, "nothing")), None)
    if nothing is None:
        return []
    energy, lines = nothing[f"left_{ending}"] ** 2 - floor**2, []
    for one in entries(content, "not enough", "beaten", "not needed")[:CLOSEST]:
        taken = (nothing[f"left_{ending}"] ** 2 - one[f"left_{ending}"] ** 2) / energy if energy > 0.0 else 0.0
        likely = probability.said(one)
        share = f"{100.0 * min(max(taken, 0.0), 1.0):.0f} % of the mismatch's energy"
        said = f"{called(one['ids'])}: {likely}{'; ' if likely else ''}takes {share}"
        helper = not physics(tuple(one["ids"]))
        lines.append(f"{said}{', and is no physics of the library' if helper else ''}.")
    return [*lines, f"{100.0 * EXPLAINED:.0f} % make an explanation."]


def _beaten(one: dict[str, Any], first: dict[str, Any], content: dict[str, Any], words: Vocabulary) -> str:
    ending = words.ending
    said = told(one, content, words)
    where = place(one["location"], content["evidence"], words)
    where = where if where == EVERYWHERE else f"mostly {where}"
    follows = f" This difference follows {words.follows(one['driver'])}." if one["driver"] else ""
    if one.get("probability") is not None and one["probability"] < RARE:
        return f"{said}."
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
    preferred = UNWEIGHED if one.get("probability") is None else ""
    return f"{said}, {_beside(one, first, words)}. {preferred}{differs}"


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
        return f"{told(one, content, words)}: too little less for one mechanism more."
    saved, bent = (_saved(base, one, f"{key}_{ending}") for key in ("left", "bent"))
    further = [id_ for id_ in one["ids"] if id_ not in base["ids"]]
    likely = probability.said(one)
    added = f"{listing(further)}, added to {called(base['ids'])}{f' ({likely})' if likely else ''}"
    if not saved:
        return f"{added}: explains nothing more."
    takes = "takes" if len(further) == 1 else "take"
    more = f"{takes} away {size(saved, words.unit)} rms more and {'leaves' if takes == 'takes' else 'leave'}"
    said = f"{added}: {more} {left(one, content, words)}"
    if saved > VISIBLE * content["evidence"][f"floor_{ending}"] and bent < saved:
        allowed = f"{ALLOWED[0].lower()}{ALLOWED[1:]}"
        all_of_it, sure = size(saved, words.unit), size(bent, words.unit)
        said += f". Of the {all_of_it} only {sure} are sure {allowed}" if sure != all_of_it else ""
    kept = [other for other in entries(content, "tied") if len(other["ids"]) >= len(one["ids"])]
    if any(other[f"left_{ending}"] >= one[f"left_{ending}"] for other in kept):
        return f"{said}. Some that are likely leave as much, and are ranked before it all the same."
    return f"{said}. That is too little for {'one mechanism' if len(further) == 1 else 'so many mechanisms'} more."
