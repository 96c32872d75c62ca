"""The range in which a planned motion gets an error band, as a verdict's page states it before any plan."""

from ....run.planned_motion.motion_course import ALIKE
from ....run.planned_motion.planned_limits import (
    LONGER,
    SHORT_S,
    from_on,
    least_speed,
    most_speed,
    share_of_slowest,
    stands_still,
    up_to,
)
from ...document.content import Verdict
from ...document.evidence import Covered
from ...document.made_keys import amount, extent
from ...mechanisms.library import mechanisms
from ..language.quantity import at, duration, ends, listing, span
from ..language.vocabulary import Vocabulary

WIDER = "speeds, holds and rests reach further than recorded"


def within(content: Verdict, words: Vocabulary) -> str:
    """Motion, speeds, loads and stands within which a plan has a band; nothing where an older file lacks them.

    Speeds are the limits of the warning that a plan gets which leaves them, rounded so that they are inside; the other
    limits lack its room.
    """
    covered = content["evidence"].get("covered")
    if covered is None:
        return ""
    low, high = extent(content["evidence"], words.driver)
    slow, fast = covered.get("strokes_per_s") or covered["speed_per_s"]
    acting = [entry["id"] for entry in content["mechanisms"]]
    likely = {*acting, *(id_ for ids in content["alternatives"] for id_ in ids)}
    library = mechanisms()
    other = fast < ALIKE * slow or any(library[id_].paced for id_ in likely if id_ in library)
    speeds = _speeds(covered, other, words) or ends(share_of_slowest(other) * slow, fast, f"{words.motion_unit}/s")
    parts = [span(low, high, words.motion_unit, high - low), speeds]
    if words.load is not None and covered["load"][1] > 0.0:
        least, most = covered["load"]
        usual = ends(0.5 * (least + most), 0.5 * (least + most), words.load_unit)
        parts.append(usual if stands_still(least, most) else ends(least, most, words.load_unit))
    stands_s = {name: max(LONGER * amount(covered, f"longest_{name}_s"), SHORT_S) for name in ("hold", "rest")}
    parts += [f"{name}s of up to {duration(longest_s)}" for name, longest_s in stands_s.items()]
    if any(library[id_].remembers_turns for id_ in acting if id_ in library):
        parts.append(f"reversals near {_turned(covered, words, high - low)}")
    return f"{listing(parts)} ({WIDER})"


def _speeds(covered: Covered, other: bool, words: Vocabulary) -> str:
    """How slow and how fast a planned stroke may be, in a plan's own terms; nothing where an older file lacks it."""
    if "strokes_per_s" not in covered:
        return ""
    (slow, fast), unit = covered["strokes_per_s"], f"{words.motion_unit}/s"
    least = from_on(least_speed(slow, other))
    most = up_to(most_speed(fast, covered["fastest_per_s"], other))
    return f"a speed of {least} to {most} {unit} in each stroke (its median; recorded: {ends(slow, fast, unit)})"


def _turned(covered: Covered, words: Vocabulary, whole: float) -> str:
    """The motions near which a plan may turn, at the top and at the bottom; `whole` is the recorded range."""
    turned = covered.get("turned")
    if not turned:
        return "recorded ones"
    places = {
        end: listing([_place(low, high, words, whole) for low, high in turned[end]])
        for end in ("top", "bottom")
        if turned[end]
    }
    called = {} if words.twisted else {"top": "far end", "bottom": "near end"}
    return " and ".join(f"{where} at the {called.get(end, end)}" for end, where in places.items())


def _place(low: float, high: float, words: Vocabulary, whole: float) -> str:
    """One place, or a stretch without a gap in which a plan may turn anywhere."""
    least, most = at(low, words.motion_unit, whole), at(high, words.motion_unit, whole)
    return most if least == most else span(low, high, words.motion_unit, whole)
