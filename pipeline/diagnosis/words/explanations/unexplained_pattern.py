"""The unexplained residual, in words: how large its pattern is, where it lies and what it follows."""

from ....ground.outside_library import is_outside
from ...document.content import Verdict, mismatch_of
from ...document.made_keys import amount, amount_or_none, by_name
from ..held_out import holdout, level, unseen
from ..language.places import EVERYWHERE, place
from ..language.quantity import listing, size, times
from ..language.vocabulary import Vocabulary
from .closest import plainly
from .rivals import NOISY, called, entries, left

STAND_IN = " (a stand-in that fits the data and is no physics of the library{})"
TIME, ALONG = "time", ", as the load did, so either may be it"
LESS = 0.98  # times what calibration alone leaves: who leaves more is not worth a word


def pattern(content: Verdict, words: Vocabulary) -> list[str]:
    """How large the unnamed pattern is, where it lies, and what it follows; nothing where there is none."""
    rms, evidence = amount(mismatch_of(content), f"rms_{words.ending}"), content["evidence"]
    if not rms:
        return []
    ratio = times(rms / amount(evidence, f"floor_{words.ending}"))
    least = min(by_name(content["fit"], f"detectable_{words.ending}").values(), default=0.0)
    if unseen.left_over(content, words):  # how much is said once, below
        how_large = "A pattern is left that no effect is named for."
    else:
        beyond = f"{size(rms, words.unit)} rms is more than noise ({ratio} times the noise)"
        how_large = f"Of the calibrated error in the table below, {beyond}, and no effect is named for it."
        if rms > least > 0.0:
            more = " Some effects would have been seen even if they were smaller (listed below)"
            how_large += f"{more}: what is left looks like none of them."
    left_pattern = evidence.get("pattern")
    closest = nearest(content, words)
    if not left_pattern:
        return [how_large, *closest]
    where = place(left_pattern["location"], evidence, words)
    follows = listing([words.follows(driver, evidence["loaded"]) for driver in left_pattern["driver"]])
    if where == EVERYWHERE:
        return [
            how_large,
            f"What is systematic in it is spread over the whole recording. It follows {follows}.",
            *closest,
        ]
    share = f"{100.0 * left_pattern['location']['share']:.0f} % of the energy of what is systematic in it"
    return [how_large, f"{share} lies {where}. It follows {follows}.", *closest]


def remains(content: Verdict, words: Vocabulary, least: float = NOISY) -> list[str]:
    """Where the best explanation's residual lies and what it follows; nothing where that residual is noise.

    `least`: noise floors from which on it leaves more.
    """
    left_pattern, evidence = content["evidence"].get("pattern"), content["evidence"]
    floor, best = amount(evidence, f"floor_{words.ending}"), next(iter(entries(content, "named")), None)
    if not left_pattern or best is None or amount(best, f"left_{words.ending}") <= least * floor:
        return []
    where = place(left_pattern["location"], evidence, words)
    half = place(left_pattern["half"], evidence, words) if "half" in left_pattern else EVERYWHERE
    lies = "lies everywhere" if where == EVERYWHERE else f"lies mostly {where}"
    lies += f", half of its energy {half}" if half not in (EVERYWHERE, where) else ""
    follows = listing([words.follows(driver, evidence["loaded"]) for driver in left_pattern["driver"]])
    if TIME in left_pattern["driver"] and "load" in evidence.get("beyond_seen", {}):
        follows += ALONG
    rms = size(amount(left_pattern, f"rms_{words.ending}"), words.unit)
    fitted = " of all strokes" * bool(level.beaten(content, words))  # else than on unseen ones
    holds = f"What {called(best['ids'])} leaves{fitted} holds a pattern of {rms} rms beside the noise"
    if half != EVERYWHERE and (where == EVERYWHERE or half.startswith(f"{where}, ")):  # one range, said once
        return [f"{holds}. Half of its energy lies {half}; it follows {follows}."]
    return [f"{holds}. It {lies}, and follows {follows}."]


def nearest(content: Verdict, words: Vocabulary) -> list[str]:
    """The one effect that would reduce the residual most, if only a little; it is not named."""
    shown = [explanation for explanation in content["evidence"]["explanations"] if explanation["ids"]]
    best = min(shown, key=lambda explanation: amount(explanation, f"left_{words.ending}"), default=None)
    alone = amount_or_none(content["evidence"], f"calibrated_{words.ending}")
    if best is None or not alone or amount(best, f"left_{words.ending}") > LESS * alone:
        return []
    kind = "one more effect" if holdout.included(content) else "an effect"
    before = size(alone, words.unit)
    return [
        f"The best that {kind} could do: with {called(best['ids'])}{stand_in(best['ids'])} "
        f"{left(best, content, words)} would be left instead of {before}. That gain is too small to name it."
    ]


def stand_in(ids: list[str]) -> str:
    """What a name that begins with x_ means, where one does."""
    does = "; ".join(filter(None, map(plainly, ids)))
    return STAND_IN.format(f": {does}" * bool(does)) if any(map(is_outside, ids)) else ""
