"""How probable each explanation is, and by which rule the likely ones are kept, in words."""

from ...choice.judged import HELD
from ...document.content import Verdict
from ...document.explanations import ExplanationEntry, share_of
from ...mechanisms.interface import physics
from ...mechanisms.library import mechanisms
from ..language.quantity import percent
from . import not_named

HELD_STANDINGS = ("named", "tied")
LARGER_LEAVES_LESS = "the same effects with one more leave less of the recording"  # of a probability of 0
NO_MARK, ENOUGH_OTHERS = "no percentage: its sign is missing", "no percentage: others fit better"
SEEN = 0.005  # a probability that is worth a word
WORTH = 0.05  # a share of physics that the library lacks, from which on a reader asks why
OF_NONE = (
    "The share of physics that the library lacks was learnt on simulated recordings that looked like this one: more "
    "strokes of the same kind need not lower it."
)
WITHOUT = (
    "No probabilities are known on this rig: they were learnt on strings. An explanation is left out where it fits "
    "the recording worse than the best one by about as much as it should if the best one were true."
)


def known(content: Verdict) -> bool:
    """Whether the explanations were weighed by their probability."""
    return any(explanation.get("probability") is not None for explanation in content["evidence"]["explanations"])


def said(share: float | None) -> str:
    """An explanation's probability as `probability 26 %`; nothing where it has none."""
    if share is None:
        return ""
    if share == 0.0:
        return f"probability less than 1 % ({LARGER_LEAVES_LESS})"
    return f"probability {percent(share)}"


def at_work(content: Verdict, id_: str) -> float:
    """How probable it is that an effect acts, whatever is beside it: the sum over the explanations that have it.

    Explanations that are left out say nothing of it: their share is that of the others.
    """
    shown = content["evidence"]["explanations"]
    every = float(sum(share_of(explanation) for explanation in shown))
    with_it = float(sum(share_of(explanation) for explanation in shown if id_ in explanation["ids"]))
    return with_it * (every + not_named.together(content)) / every if every else 0.0


def rule(content: Verdict) -> list[str]:
    """Which explanations are kept, with the numbers of this verdict."""
    if content["verdict"] not in ("explained", "ambiguous"):
        return []
    if not known(content):
        return [WITHOUT] if "probability_of_none" in content["evidence"] else []
    shown = content["evidence"]["explanations"]
    kept_ones = [explanation for explanation in shown if explanation["standing"] in HELD_STANDINGS]
    together = sum(share_of(explanation) for explanation in kept_ones)
    none = content["evidence"].get("probability_of_none") or 0.0
    several = content["verdict"] == "ambiguous"
    count = f"{1 + len(content['alternatives'])} explanations" if several else "1 explanation"
    which = f": the likeliest, until they have {percent(HELD)} of what the library's have together" * several
    kept = f"Kept: {count}, {percent(together)}{' together' * several}{which}."
    return [f"{kept} {_left_out(content)}None of the others is impossible.{f' {OF_NONE}' * (none >= WORTH)}"]


def likeliest(explanations: list[ExplanationEntry]) -> list[ExplanationEntry]:
    """Explanations by falling probability; those without one as they came, last."""
    return sorted(explanations, key=lambda explanation: -share_of(explanation))


def stand_ins(kept: list[list[str]]) -> str:
    """A remark that the shares of some explanations are no physics of the library, and count for none of it."""
    return ", stand-ins included" if any(ids and not physics(tuple(ids)) for ids in kept) else ""


def _left_out(content: Verdict) -> str:
    """How much of the kept probability is left out; nothing where none is."""
    out = content["evidence"].get("left_out", [])
    which = "One likely explanation is" if len(out) == 1 else f"{len(out)} likely explanations are"
    share, them = not_named.together(content), "it" if len(out) == 1 else "them"
    uncounted = f"the percentages of effects do not count {them}"
    return f"{which} left out ({percent(share)}), so less than {percent(HELD)} is kept; {uncounted}. " if share else ""


def not_weighed(ids: list[str]) -> str:
    """Why an explanation has no probability while others do; empty for calibration alone, which never has one."""
    library = mechanisms()
    marked = any(library[id_].least_mark for id_ in ids if id_ in library)
    return "" if not ids else NO_MARK if marked else ENOUGH_OTHERS
