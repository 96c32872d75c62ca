"""Which effects are sure, which probable and which open, from how likely each is in whichever explanation; in words."""

from typing import Any

from ..bounds import at_bound
from ..library import mechanisms
from . import probability, rivals
from .dimensions import name_of
from .quantity import duration, listing, percent, size
from .vocabulary import Vocabulary

SURE, PROBABLE = 0.8, 0.5
COMPARES = (
    "The percentages compare explanations made of the library's effects, in which each dimension may move by up to "
    "three times its tolerance"
)
WIDE = 2.0  # times its lower end: where the upper end of an interval is more, the size is poorly known
# drivers that go on over a whole recording
SLOW = ("time under load", "absolute time", "worked strokes", "load x worked strokes", "travel")


def alike(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """That slow effects are hard to tell apart in a recording under one load, where one of them is named."""
    there = slow_alike(content, words)
    if not there:
        return []
    others = listing(slow_others(there), "or")
    return [
        f"Under one load slow effects look much alike. A percentage compares the library's formulas: where a law of "
        f"this rig differs from them, {listing(there)} may hide {others}, or stand in for it."
    ]


def slow_others(there: list[str]) -> list[str]:
    """The other slow effects of the library."""
    return [id_ for id_, mechanism in mechanisms().items() if mechanism.driver in SLOW and id_ not in there]


def slow_alike(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """The named effects that are slow, where a recording under one load cannot tell them from others that are."""
    if content["evidence"]["loaded"] or words.load is None:
        return []
    return [entry["id"] for entry in content["mechanisms"] if mechanisms()[entry["id"]].driver in SLOW]


def asks(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """The test at the rig that tells slow effects apart, with its least time; nothing where none is named."""
    there = slow_alike(content, words)
    if not there:
        return []
    tests = "; ".join(dict.fromkeys(mechanisms()[id_].told_apart_by for id_ in there))
    found = [entry["parameters"].values() for entry in content["mechanisms"] if entry["id"] in there]
    times = [float(each["value"]) for one in found for each in one if each.get("unit") == "s"]
    least = f" Hold and rest for {duration(2.0 * max(times))} or longer each: twice its time constant." if times else ""
    run = " The run to make next is not this test." if content.get("next_run") else ""
    return [f"What tells {listing(there)} from what looks like it: {tests}.{least}{run}"]


def limits(content: dict[str, Any]) -> str:
    """What the percentages stand on, and which dimensions are at the end of it."""
    found = [name_of(name) for name in at_bound(content["evidence"]["moved_sigma"]) if name in content["parameters"]]
    if not found:
        return f"{COMPARES}."
    stand = f"The {listing(found)} {'stand' if len(found) > 1 else 'stands'} at that limit"
    return f"{COMPARES}. {stand}: measured better, {'they' if len(found) > 1 else 'it'} can change the percentages."


def known(content: dict[str, Any]) -> dict[str, float]:
    """How likely each named effect is at work; nothing where no probability is known."""
    if content["verdict"] not in ("explained", "ambiguous") or not probability.known(content):
        return {}
    return {entry["id"]: entry["confidence"] for entry in content["mechanisms"] if "confidence" in entry}


def summary(content: dict[str, Any]) -> list[str]:
    """The effects by how sure each is; those that only an explanation beside the best one has are open."""
    shares = known(content)
    sure = [f"{id_} ({percent(share)})" for id_, share in shares.items() if share >= SURE]
    probable = [f"{id_} ({percent(share)})" for id_, share in shares.items() if PROBABLE <= share < SURE]
    doubtful = [f"{id_} ({percent(share)})" for id_, share in shares.items() if share < PROBABLE]
    others = {id_: probability.at_work(content, id_) for ids in content["alternatives"] for id_ in ids}
    beside = [f"{id_} ({percent(share)})" for id_, share in others.items() if id_ not in shares]
    groups = {
        f"Sure ({percent(SURE)} or more)": sure,
        f"Probable ({percent(PROBABLE)} or more)": probable,
        "Open": [*doubtful, *beside],
    }
    said = [f"{word}: {listing(found)}." for word, found in groups.items() if found]
    return [" ".join(said), limits(content)] if shares else []


def sizes(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """How much is missing, and which effects' own sizes the recording leaves open; nothing where nothing is named."""
    if content["verdict"] not in ("explained", "ambiguous") or not content["mismatch"]:
        return []
    missing = size(content["mismatch"][f"rms_{words.ending}"], words.unit)
    found = {entry["id"]: entry[f"rms_{words.ending}"] for entry in content["mechanisms"]}
    poorly = [f"{id_} ({span(low, high, words)})" for id_, (low, high) in poorly_known(content, words).items()]
    own = f"Poorly known is how much {listing(poorly)} {'do' if len(poorly) > 1 else 'does'} alone" if poorly else ""
    if not poorly and all(known["high"] > known["low"] for known in found.values()):
        own = "Each effect's own size is known" if len(found) > 1 else "The effect's own size is known"
        own += f" to {percent(max(_half(known) for known in found.values()))} or better"
    return [f"Size: {missing} rms is missing after calibration.{f' {own}, if this explanation is right.' * bool(own)}"]


def _half(known: dict[str, float]) -> float:
    """The longer half of an interval, as a share of the value."""
    longer = max(known["high"] - known["value"], known["value"] - known["low"])
    return longer / known["value"] if known["value"] else 0.0


def poorly_known(content: dict[str, Any], words: Vocabulary) -> dict[str, tuple[float, float]]:
    """The effects whose own size the recording leaves open, each with its interval."""
    found = {entry["id"]: entry[f"rms_{words.ending}"] for entry in content["mechanisms"]}
    return {
        id_: (known["low"], known["high"])
        for id_, known in found.items()
        if wide(known) or hidden(known["value"], content, words)
    }


def partly_hidden(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """The effects that are larger than what is missing, so that moved dimensions must take some of each back."""
    key = f"rms_{words.ending}"
    limit = rivals.MORE * content["mismatch"][key] if content["mismatch"] else float("inf")
    return [entry["id"] for entry in content["mechanisms"] if entry[key]["value"] > limit]


def wide(known: dict[str, float]) -> bool:
    """Whether the interval of a size is wide."""
    return known["high"] > max(WIDE * known["low"], known["low"])


def hidden(own: float, content: dict[str, Any], words: Vocabulary) -> bool:
    """Whether an effect is far larger than what is missing, so that moved dimensions must take most of it back."""
    return bool(own > rivals.LARGER * content["mismatch"][f"rms_{words.ending}"])


def span(low: float, high: float, words: Vocabulary) -> str:
    """An interval of a size: `0 to 0.40 mm`."""
    least, most = size(low, words.unit), size(high, words.unit)
    return f"{least.removesuffix(most[most.find(' ') :])} to {most}"


def needed(content: dict[str, Any]) -> list[str]:
    """What to think of an effect of the best explanation that is less likely than not."""
    best = {entry["id"] for entry in content["mechanisms"]}
    others = [set(ids) for ids in content["alternatives"]]
    lines = []
    for id_, share in known(content).items():
        rest = best - {id_}
        swapped = [ids - rest for ids in others if ids >= rest]
        if share >= PROBABLE:
            continue
        if others and len(swapped) == len(others) and all(len(one) == 1 for one in swapped):
            instead = dict.fromkeys(other for one in swapped for other in sorted(one))
            lines.append(f"One of {listing([id_, *instead])} is needed; which one is open.")
        else:
            lines.append(f"{id_} is more likely absent than at work ({percent(share)}).")
    return lines
