"""For each library effect that no likely explanation has, a row that says why: for instance, why it is not friction."""

import math

from ...document.content import Verdict
from ...document.explanations import Change, NotKept, Stood
from ...document.made_keys import amount, amount_or_none
from ...mechanisms.library import mechanisms
from ..language.quantity import listing, of_column, percent, size, times
from ..language.text_table import UNKNOWN, wrapped_cells
from ..language.vocabulary import Vocabulary
from .rivals import ALIKE, LITTLE, called

HEADING = "Why it is none of the other effects"
CLEAR, MORE = 3.0, 2.0  # standard errors that are no chance; times the best one's change: what is less is like it
VISIBLE = 0.1  # noise floors: a change in a stand that is less is worth no word
EXCLUDES = 1.0  # noise floors: what is wrong by less may be bent by an effect too small to be named
WORTH = 0.01  # of a probability: what is less is not said
ADDS = 0.2  # noise floors: what takes away less adds nothing
CONSTANT, LOAD = "nothing: a constant", "load"  # what such effects follow, by `Mechanism.driver`
OF_RUNS = "each run has its own zero, and within none the load changed enough: change it between strokes of one run"
STANDS = {"hold": "in a hold", "rest": "in a rest"}
TRIED = (
    "Each effect was tried in place of a part of the best explanation, which leaves {left}, and added to all of it. "
    "What it takes away there is too little for one effect more."
)
WRONG = "Wrong: by how much what is left changes while the motor stands ({counted}), beyond chance."
NEVER = "The motor never stood long enough in this recording to say what goes on while it stands."
ALONE, NO_LESS, NOTHING = "all of it", "as much as without it", "nothing"
SAME = "{}: hardly more than the best one leaves, but less likely by other signs."


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """A table of the effects that were tried, the nearest first, with remarks; nothing for a file without them."""
    entries = content["evidence"].get("not_kept") or []
    others = [entry for entry in entries[1:] if words.twisted or not mechanisms()[entry["id"] or ""].twisted]
    if not others:
        return []
    first, key = entries[0], f"left_{words.ending}"
    tried = sorted(
        (each for each in others if each["possible"] and amount_or_none(each, key) is not None),
        key=lambda each: amount(each, key),
    )
    stood = first["stands"] or {}
    counted = listing([f"{change['count']} {phase}s" for phase, change in stood.items()])
    stands = [phase for phase in STANDS if phase in stood]
    head = [
        "effect",
        "in place of",
        "leaves (× noise)",
        *(f"wrong {STANDS[phase]}" for phase in stands),
        "added, takes away",
    ]
    rows = [_row(entry, first, stands, content, words) for entry in tried]
    alike = [entry["id"] or "" for entry in tried if amount(entry, key) <= ALIKE * amount(first, key)]
    likely = [f"{entry['id']} {percent(entry['likely'])}" for entry in others if entry["likely"] >= WORTH]
    wrong = [called(entry["ids"]) for entry in first["tied"] if _wrong(entry, first, content, words)]
    return [
        TRIED.format(left=size(amount(first, key), words.unit)),
        *(wrapped_cells([head, *rows]) if rows else []),
        WRONG.format(counted=counted) if stands else NEVER,
        *([f"Among the likely, but wrong while the motor stands: {listing(wrong)}."] if wrong else []),
        *([SAME.format(listing(alike))] if alike else []),
        *([f"How likely at work: {listing(likely)}; each other one less than 1 %."] if likely else []),
        *_not_shown([entry["id"] or "" for entry in others if entry not in tried], content, words),
    ]


def _row(entry: NotKept, first: NotKept, stands: list[str], content: Verdict, words: Vocabulary) -> list[str]:
    """The cells of an effect: what it replaces, the residual with it, where that is wrong, and what it adds."""
    floor, left_rms = amount(content["evidence"], f"floor_{words.ending}"), amount(entry, f"left_{words.ending}")
    best, instead = [each["id"] for each in content["mechanisms"]], entry["instead"] or []
    replaced = [id_ for id_ in best if id_ not in instead]
    place = ALONE if len(replaced) == len(best) > 1 else listing(replaced) or UNKNOWN
    if beside_it := [id_ for id_ in instead if id_ not in (entry["id"], *best)]:
        place += f", with {listing(beside_it)}"
    leaves = (
        NO_LESS
        if _helps_nothing(entry, content, words)
        else f"{size(left_rms, words.unit)} ({times(left_rms / floor)})"
    )
    wrong_in = wrong_by(entry, first, floor, words)
    beside = amount_or_none(entry, f"beside_{words.ending}")
    saved = 0.0 if beside is None else math.sqrt(max(amount(first, f"left_{words.ending}") ** 2 - beside**2, 0.0))
    takes = UNKNOWN if beside is None else NOTHING if saved < ADDS * floor else of_column(saved, words.unit, left_rms)
    return [entry["id"] or "", place, leaves, *(wrong_in.get(phase, UNKNOWN) for phase in stands), takes]


def _helps_nothing(entry: NotKept, content: Verdict, words: Vocabulary) -> bool:
    """Whether an effect leaves no less than the same explanation without it."""
    rest, left_rms = set(entry["instead"] or []) - {entry["id"]}, amount(entry, f"left_{words.ending}")
    alone = amount_or_none(content["evidence"], f"calibrated_{words.ending}")
    if not rest:
        return alone is not None and bool(left_rms >= LITTLE * alone)
    smaller = [each for each in content["evidence"]["explanations"] if set(each["ids"]) == rest]
    return any(left_rms > ALIKE * amount(each, f"left_{words.ending}") for each in smaller)


def _not_shown(ids: list[str], content: Verdict, words: Vocabulary) -> list[str]:
    """Which effects no recording like this can show, each with the reason, in one line."""
    drivers = {id_: mechanisms()[id_].driver for id_ in ids}
    several = isinstance(content["run"], list) and content["evidence"]["loaded"]
    reasons = {CONSTANT: "a constant cannot be told from the zero of the sensor"} | ({LOAD: OF_RUNS} if several else {})
    why = [f"{id_} ({reasons.get(driver, f'it follows {words.follows(driver)}')})" for id_, driver in drivers.items()]
    return [f"This recording could not show {listing(why, 'or')}."] if why else []


def wrong_by(entry: NotKept, first: NotKept, floor: float, words: Vocabulary) -> dict[str, str]:
    """By how much an effect's residual changes while the motor stands, by `hold` and `rest`, if it is wrong there.

    `first` is the entry of the best explanation.
    """
    return {
        phase: size(abs(change["change"]), words.unit)
        for phase, change in (entry["stands"] or {}).items()
        if _contradicts(phase, entry["stands"], first, floor)
    }


def excludes(entry: NotKept, first: NotKept, floor: float) -> bool:
    """Whether the stands of the motor exclude an effect: with it the residual changes there by more than the noise.

    `first` is the entry of the best explanation, `floor` the noise in the reading's unit.
    """
    stands = entry["stands"] or {}
    return any(_contradicts(phase, stands, first, floor, EXCLUDES) for phase in stands)


def _contradicts(
    phase: str, stands: dict[str, Change] | None, first: NotKept, floor: float, least_floors: float = VISIBLE
) -> bool:
    """Whether an effect's residual changes while the motor stands, beyond chance and more than the best one's."""
    own_change, best = (stands or {}).get(phase), (first["stands"] or {}).get(phase)
    if own_change is None:
        return False
    change = abs(own_change["change"])
    own_best = abs(best["change"]) if best else 0.0
    return bool(change > max(CLEAR * own_change["error"], least_floors * floor, MORE * own_best))


def _wrong(entry: Stood, first: NotKept, content: Verdict, words: Vocabulary) -> bool:
    """Whether the stands of the motor speak against an effect, or an explanation."""
    floor = amount(content["evidence"], f"floor_{words.ending}")
    return any(_contradicts(phase, entry["stands"], first, floor) for phase in entry["stands"])
