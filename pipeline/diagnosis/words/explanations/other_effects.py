"""Why each effect of the library is none of the likely explanations', a short sentence each: why is it not friction?"""

import math

from ...document.content import Part, Verdict
from ...mechanisms.library import mechanisms
from ..language.quantity import listing, percent, size, times
from ..language.vocabulary import Vocabulary
from .rivals import ALIKE, LITTLE, NO_LESS, called

HEADING = "Why it is none of the other effects"
CLEAR, MORE = 3.0, 2.0  # standard errors that are no chance; times the best one's change: what is less is like it
VISIBLE = 0.1  # noise floors: a change in a stand that is less is worth no word
WORTH = 0.01  # of a probability: what is less is not said
ADDS = 0.2  # noise floors: what takes away less adds nothing
CONSTANT = "nothing: a constant"  # what such an effect follows, by `Mechanism.driver`
SEVERAL = 3  # effects that add nothing: from so many on it is said once
NOTHING_ADDED = "added to the best one takes away nothing"
NOTHING_MORE = " Where a line does not say more, the effect takes away nothing when it is added."
STANDS = {"hold": "in a hold", "rest": "in a rest"}
HEAD = "Each effect was tried instead of the best explanation ({best}, which leaves {left}), and added to it."
BRACKETS = " In brackets after its name: how likely the effect is at work."


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """The head, what the stands of the motor say, then a sentence an effect; nothing where an older file has none."""
    first, *others = content["evidence"].get("not_kept") or [None]
    others = [entry for entry in others if words.twisted or not mechanisms()[entry["id"]].twisted]
    if first is None or not others:
        return []
    best = called([entry["id"] for entry in content["mechanisms"]])
    left = size(first[f"left_{words.ending}"], words.unit)
    why = {_name(entry): _why(entry, first, content, words) for entry in _nearest_first(others, words)}
    often = sum(reason.endswith(NOTHING_ADDED) for reason in why.values()) >= SEVERAL
    likely = any(entry["likely"] >= WORTH for entry in others)
    alike: dict[str, list[str]] = {}
    for name, reason in why.items():
        alike.setdefault(reason.removesuffix(f"; {NOTHING_ADDED}") if often else reason, []).append(name)
    return [
        f"{HEAD.format(best=best, left=left)}{BRACKETS * likely}{NOTHING_MORE * often}",
        *_standing(content, first, others, words),
        *(f"{listing(names)}: {'each ' * _several(names, reason)}{reason}." for reason, names in alike.items()),
    ]


def _several(names: list[str], reason: str) -> bool:
    """Whether a reason is that of several effects, each of them alone."""
    return len(names) > 1 and reason.startswith("alone")


def _nearest_first(entries: list[Part], words: Vocabulary) -> list[Part]:
    """The entries by what the best explanation with each leaves; those that no recording like this can show last."""
    key = f"left_{words.ending}"
    return sorted(entries, key=lambda entry: math.inf if entry[key] is None else entry[key])


def _name(entry: Part) -> str:
    return f"{entry['id']} ({percent(entry['likely'])})" if entry["likely"] >= WORTH else str(entry["id"])


def _why(entry: Part, first: Part, content: Verdict, words: Vocabulary) -> str:
    """Why an effect is not kept, without a full stop."""
    floor, left = content["evidence"][f"floor_{words.ending}"], entry[f"left_{words.ending}"]
    if not entry["possible"] or left is None:
        return _not_shown(mechanisms()[entry["id"]].driver, words)
    instead = called(entry["instead"]) if len(entry["instead"]) > 1 else "alone"
    leaves = f"{instead} leaves {size(left, words.unit)} ({times(left / floor)} times the noise)"
    alone = content["evidence"].get(f"calibrated_{words.ending}")
    if alone and left >= LITTLE * alone and len(entry["instead"]) == 1:
        leaves = f"alone {NO_LESS}"
    elif without := _not_better(entry, content, words):
        leaves = f"{instead} leaves no less than {without}"
    if left <= ALIKE * first[f"left_{words.ending}"]:
        leaves += ", hardly more than the best one, but is less likely by its other signs"
    parts = [leaves]
    wrong = wrong_standing(entry, first, floor, words)
    parts += [f"wrong while the motor stands, by {listing(wrong)}"] if wrong else []
    return "; ".join([*parts, *_beside(entry, first, floor, words)])


def _not_better(entry: Part, content: Verdict, words: Vocabulary) -> str:
    """The part of an explanation without this effect that leaves no more than it; nothing where the effect helps it."""
    rest, key = set(entry["instead"]) - {entry["id"]}, f"left_{words.ending}"
    smaller = [
        each for each in content["evidence"]["explanations"]
        if rest and set(each["ids"]) == rest and entry[key] > ALIKE * each[key]
    ]  # fmt: skip
    return called(smaller[0]["ids"]) if smaller else ""


def _not_shown(driver: str, words: Vocabulary) -> str:
    """Why no recording like this can show an effect that follows `driver`, without a full stop."""
    if driver == CONSTANT:
        return "this recording could not show it: a constant cannot be told from the zero of the sensor"
    return f"this recording could not show it (it follows {words.follows(driver)})"


def wrong_standing(entry: Part, first: Part, floor: float, words: Vocabulary) -> list[str]:
    """By how much an effect is wrong while the motor stands, in holds and in rests; nothing where it is not.

    `first` is the entry of the best explanation.
    """
    return [
        f"{size(abs(known['change']), words.unit)} {STANDS[phase]}"
        for phase, known in (entry["stands"] or {}).items()
        if _contradicts(phase, entry, first, floor)
    ]


def _beside(entry: Part, first: Part, floor: float, words: Vocabulary) -> list[str]:
    """What an effect adds to the best explanation; nothing where it was not tried beside it."""
    beside = entry[f"beside_{words.ending}"]
    if beside is None:
        return []
    saved = math.sqrt(max(first[f"left_{words.ending}"] ** 2 - beside**2, 0.0))
    if saved < ADDS * floor:
        return [NOTHING_ADDED]
    return [f"added to the best one takes away {size(saved, words.unit)} more, too little for one effect more"]


def _contradicts(phase: str, entry: Part, first: Part, floor: float) -> bool:
    """Whether what an effect leaves changes while the motor stands, beyond chance and more than the best one's does."""
    known, best = (entry["stands"] or {}).get(phase), first["stands"].get(phase, {"change": 0.0})
    if known is None:
        return False
    change = abs(known["change"])
    return bool(change > max(CLEAR * known["error"], VISIBLE * floor, MORE * abs(best["change"])))


def _standing(content: Verdict, first: Part, others: list[Part], words: Vocabulary) -> list[str]:
    """What the recording says while the motor stands: for the best explanation, and against which effects."""
    floor = content["evidence"][f"floor_{words.ending}"]
    if not first["stands"]:
        return ["The motor never stood long enough in this recording to say what goes on while it stands."]
    counted = listing([f"{known['count']} {phase}s" for phase, known in first["stands"].items()])
    likely = [called(entry["ids"]) for entry in first["tied"] if _wrong(entry, first, floor)]
    against = [entry["id"] for entry in others if _wrong(entry, first, floor)]
    stands = f"While the motor stands ({counted}), the reading"
    if not against and not likely:
        return [f"{stands} speaks against none of them."]
    best = called([entry["id"] for entry in content["mechanisms"]])
    sure = [f"against {listing(likely)}, though likely"] if likely else []
    others_against = [f"against {listing(against)}"] if against else []
    return [f"{stands} fits {best}, and speaks {' and '.join([*sure, *others_against])}."]


def _wrong(entry: Part, first: Part, floor: float) -> bool:
    """Whether the stands of the motor speak against an effect, or an explanation."""
    return any(_contradicts(phase, entry, first, floor) for phase in (entry["stands"] or {}))
