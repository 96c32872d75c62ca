"""What a verdict without a name is worth, in words: the sizes from which effects would have been seen."""

from typing import Any

from ..interface import physics
from ..library import mechanisms
from . import sight, unseen
from .headline import UNNAMED
from .places import EVERYWHERE, place
from .quantity import listing, size, times
from .rivals import NOISY, called, entries, left
from .vocabulary import Vocabulary

STAND_IN = " (x_ marks a stand-in: it fits the data, but is no physics of the library)"
LESS = 0.98  # times what calibration alone leaves: who leaves more is not worth a word


def pattern(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """How large a pattern is left without a name, where, and what it follows; nothing where none is left."""
    rms, evidence = content["mismatch"][f"rms_{words.ending}"], content["evidence"]
    if not rms:
        return []
    ratio = times(rms / evidence[f"floor_{words.ending}"])
    least = min(content["fit"][f"detectable_{words.ending}"].values(), default=0.0)
    if unseen.left_over(content, words):  # how much is said once, below
        said = "A pattern is left that no effect is named for."
    else:
        beyond = f"{size(rms, words.unit)} rms is more than noise ({ratio} times the noise)"
        said = f"Of the calibrated error in the table below, {beyond}, and no effect is named for it."
        if rms > least > 0.0:
            more = " Some effects would have been seen even if they were smaller (listed below)"
            said += f"{more}: what is left looks like none of them."
    found = evidence.get("pattern")
    closest = nearest(content, words)
    if not found:
        return [said, *closest]
    where = place(found["location"], evidence, words)
    follows = listing([words.follows(driver, evidence["loaded"]) for driver in found["driver"]])
    if where == EVERYWHERE:
        return [said, f"What is systematic in it is spread over the whole recording. It follows {follows}.", *closest]
    share = f"{100.0 * found['location']['share']:.0f} % of the energy of what is systematic in it"
    return [said, f"{share} lies {where}. It follows {follows}.", *closest]


def remains(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """Where the pattern lies that the best explanation leaves, and what it follows; nothing where it leaves noise."""
    found, evidence = content["evidence"].get("pattern"), content["evidence"]
    floor, best = evidence[f"floor_{words.ending}"], next(iter(entries(content, "named")), None)
    if not found or best is None or best[f"left_{words.ending}"] <= NOISY * floor:
        return []
    where = place(found["location"], evidence, words)
    half = place(found["half"], evidence, words) if "half" in found else EVERYWHERE
    lies = "is spread over the whole recording" if where == EVERYWHERE else f"lies mostly {where}"
    lies += f", half of its energy {half}" if half not in (EVERYWHERE, where) else ""
    follows = listing([words.follows(driver, evidence["loaded"]) for driver in found["driver"]])
    rms = size(found[f"rms_{words.ending}"], words.unit)
    return [f"What is left holds a pattern of {rms} rms beside the noise. It {lies}, and follows {follows}."]


def nearest(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """The one effect that would leave least, where it would leave a little less; it is not named."""
    shown = [one for one in content["evidence"]["explanations"] if one["ids"]]
    best = min(shown, key=lambda one: one[f"left_{words.ending}"], default=None)
    alone = content["evidence"].get(f"calibrated_{words.ending}")
    if best is None or not alone or best[f"left_{words.ending}"] > LESS * alone:
        return []
    kind = "one more effect" if sight.included(content) else "an effect"
    before = size(alone, words.unit)
    return [
        f"The best that {kind} could do: with {called(best['ids'])}{stand_in(best['ids'])} "
        f"{left(best, content, words)} would be left instead of {before}. That gain is too small to name it."
    ]


def stand_in(ids: list[str]) -> str:
    """What a name that begins with x_ means, where one does."""
    return STAND_IN if any(id_.startswith("x_") for id_ in ids) else ""


def lines(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """The smallest effect of each kind that would have been seen; none smaller than what is left unexplained."""
    there = content["fit"][f"detectable_{words.ending}"]
    held = [id_ for id_ in sight.included(content) if id_ in there]
    if content["verdict"] not in UNNAMED or not there:
        return []
    said = sizes(content, words, held)
    if held:
        said.append(f"Not listed, for run.yaml has adopted {'it' if len(held) == 1 else 'them'}: {listing(held)}.")
    unseen_here = [id_ for id_, one in mechanisms().items() if physics((id_,)) and not one.helper and id_ not in there]
    if words.twisted and unseen_here:
        cannot = "this recording cannot show them, or calibration takes them up"
        said.append(
            f"Not listed, for {cannot if len(unseen_here) > 1 else cannot.replace('them', 'it')}: "
            f"{listing(unseen_here)}."
        )
    return said


def sizes(content: dict[str, Any], words: Vocabulary, held: list[str]) -> list[str]:
    """The smallest effect of each kind but those `held`, the smallest first."""
    there = content["fit"][f"detectable_{words.ending}"]
    sizes = sorted(((id_, least) for id_, least in there.items() if id_ not in held), key=lambda item: item[1])
    if not sizes:
        return []
    left = unseen.left_over(content, words)
    larger = [f"{id_} {size(least, words.unit)}" for id_, least in sizes if least > left]
    if not left:
        if any(one["tied"] for one in content.get("adopted", [])):
            beside = "Beside what was adopted, one more effect would have been seen from this size on (rms). That does "
            return [f"{beside}not exclude it in place of an adopted one:", f"{listing(larger)}."]
        return ["An effect would have been seen from this size on (rms):", f"{listing(larger)}."]
    more = f"Of the errors in the table above, {size(left, words.unit)} rms is more than noise"
    said = f"{more}: effects of that size and less may hide in it."
    if not larger:
        return [said, "A larger one would have been seen."]
    if len(larger) == len(sizes):
        return [said, "A larger one would have been seen from this size on (rms):", f"{listing(larger)}."]
    return [
        said,
        "A larger one would have been seen, but these only from their own size on (rms):",
        f"{listing(larger)}.",
    ]
