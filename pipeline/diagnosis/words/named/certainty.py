"""Which effects are sure, probable or open, by the probability of each over all explanations; in words."""

from collections.abc import Sequence

from ...document.bounds import at_bound
from ...document.content import Verdict, mismatch_of
from ...document.made_keys import Interval, amount, interval
from ...document.time_constants import time_constants_s
from ...mechanisms.library import mechanisms
from ..explanations import not_named, probability, rivals
from ..held_out import holdout, in_vain, unseen
from ..held_out.much_left import much_left
from ..language.explained_words import tells
from ..language.quantity import duration, first_upper, listing, percent, reaches
from ..language.vocabulary import Vocabulary
from ..measured import other_load
from ..measured.dimensions import far_moved, name_of
from . import coarse
from .missing_signs import missing

SURE, PROBABLE = 0.8, 0.5
EVEN = 0.45  # probability below which an effect is more likely absent than at work
NOT_RECORDED, AND = "a second {} {} not recorded", "and a second"
ALSO_ELSEWHERE = "{} the sum over all explanations with {}; the best explanation alone has {}."
NOT_OF_LEFT_OUT = "{} the share of explanations with {}, of all that are not left out; the best one alone has {}."
NO_PROMISE = "Sure is that {} {}, not that the simulator predicts: something is still missing."
COMPARES = "The percentages compare explanations of the library in which a dimension may move by three tolerances"
TEMPERATURE = "temperature"  # the driver of what follows it
SURER = 0.03  # by which an effect is surer than its explanation: less needs no word
WIDE = 2.0  # times its lower end: where the upper end of an interval is more, the size is poorly known


def _is_slow(id_: str, content: Verdict) -> bool:
    """Whether an effect goes on over a whole recording; an unlogged temperature counts as slow."""
    covered = content["evidence"].get("covered")
    calculated = covered is not None and "temperature_c" not in covered
    return mechanisms()[id_].slow or (calculated and mechanisms()[id_].driver == TEMPERATURE)


def slow_others(content: Verdict, slow: list[str]) -> list[str]:
    """The other slow effects of the library."""
    return [id_ for id_ in mechanisms() if _is_slow(id_, content) and id_ not in slow]


def is_likely(content: Verdict, id_: str) -> bool:
    """Whether a named effect is likely enough to be called sure, if nothing holds that back."""
    return reaches(known(content).get(id_, 0.0), SURE)


def is_sure(content: Verdict, words: Vocabulary, id_: str) -> bool:
    """Whether a named effect is called sure: it is likely enough, and nothing holds that back."""
    return is_likely(content, id_) and not held_back(content, words, id_)


def held_back(content: Verdict, words: Vocabulary, id_: str) -> str:
    """Why a likely effect is still not called sure; ends a phrase with `since`."""
    lacks = dict.fromkeys([*(["load"] if id_ in slow_alike(content, words) else []), *missing(content, words, id_)])
    not_recorded = _not_recorded(list(lacks), other_load.only_in(content))
    vain = in_vain.doubt(content, words)
    return (
        at_limit(content)
        or coarse.too_small(content, words, id_)
        or vain
        or holdout.not_lasting(content, id_)
        or much_left(content, words, id_)
        or not_recorded
    )


def _not_recorded(lacks: list[str], few: str) -> str:
    """Which second load and speed were not recorded; of a load that `few` strokes had, that only these had it."""
    only = f"a second load was recorded only in {few}" if few and "load" in lacks else ""
    none = [what for what in lacks if not (only and what == "load")]
    were = "were" if len(none) > 1 else "was"
    return listing([*([only] if only else []), *([NOT_RECORDED.format(listing(none, AND), were)] if none else [])])


def slow_alike(content: Verdict, words: Vocabulary) -> list[str]:
    """The named slow effects, if a recording under one load cannot tell them from other slow effects.

    A second load in a few strokes alone counts as one load: no fit asked what follows the load.
    """
    if content["evidence"]["loaded"] or words.load is None:
        return []
    return [entry["id"] for entry in content["mechanisms"] if _is_slow(entry["id"], content)]


def asks(content: Verdict, words: Vocabulary, open_ones: Sequence[str] = ()) -> list[str]:
    """The test at the rig that tells slow effects apart, with its least time; nothing where none is named.

    `open_ones` are effects whose tests stand before it.
    """
    slow = slow_alike(content, words)
    if not slow:
        return []
    tests = "; ".join(dict.fromkeys(tells(id_, words) for id_ in slow))
    named = [entry for entry in content["mechanisms"] if entry["id"] in slow]
    longest_s = max((seconds for entry in named for seconds in time_constants_s(entry)), default=0.0)
    enough = f"Hold and rest for {duration(2.0 * longest_s)} or longer each: twice its time constant."
    least = f" {enough}" if longest_s else ""
    run = " The run to make next is not this test." if content.get("next_run") else ""
    if set(slow) <= set(open_ones):
        return [f"That of {listing(slow)} also tells it from what looks like it.{least}{run}"]
    return [f"What tells {listing(slow)} from what looks like it: {tests}.{least}{run}"]


def limits(content: Verdict) -> str:
    """What the percentages depend on, and which dimensions stand at their limit."""
    at_limit = [name_of(name) for name in at_bound(content["evidence"]["moved_sigma"]) if name in content["parameters"]]
    if not at_limit:
        return f"{COMPARES}."
    stand = f"The {listing(at_limit)} {'stand' if len(at_limit) > 1 else 'stands'} at that limit"
    return f"{COMPARES}. {stand}: measured better, {'they' if len(at_limit) > 1 else 'it'} can change the percentages."


def at_limit(content: Verdict) -> str:
    """The dimensions at their limit that are to be measured again; until then names are provisional."""
    limited = [f"the {name_of(name)}" for name in at_bound(far_moved(content)) if name in content["parameters"]]
    return f"{listing(limited)} {'stand at their' if len(limited) > 1 else 'stands at its'} limit" if limited else ""


def known(content: Verdict) -> dict[str, float]:
    """How likely each named effect is at work; nothing where no probability is known."""
    if content["verdict"] not in ("explained", "ambiguous") or not probability.known(content):
        return {}
    return {entry["id"]: entry["confidence"] for entry in content["mechanisms"] if "confidence" in entry}


def to_write(content: Verdict, words: Vocabulary, short: bool = False) -> list[str]:
    """Why effects are only probable whose percentage alone would make them sure.

    `short`: nothing where the first line of the page says it of all that is named.
    """
    shares = known(content)
    reasons: dict[str, list[str]] = {}
    for id_ in shares:
        reason = held_back(content, words, id_)
        if reason and is_likely(content, id_):
            reasons.setdefault(reason, []).append(f"{id_} has {percent(shares[id_])}")
    if short and content["verdict"] == "explained" and list(reasons) == [holdout.settled_otherwise(content)]:
        reasons = {reason: each for reason, each in reasons.items() if len(each) < len(shares)}
    return [f"{listing(each)}, but {_only(len(each))}probable: {reason}." for reason, each in reasons.items()]


def _only(count: int) -> str:
    return "is only " if count == 1 else "both are only " if count == 2 else "all are only "


def than_the_explanation(content: Verdict) -> list[str]:
    """Why an effect is surer than the one explanation; nothing where the difference is small."""
    share = next((best.get("probability") for best in rivals.entries(content, "named")), None)
    if share is None:
        return []
    shares = {id_: its for id_, its in known(content).items() if its - share >= SURER}
    sums = [f"the {percent(its)} of {id_}" for id_, its in shares.items()]
    each = "it" if len(sums) == 1 else "each"
    are = "is" if len(sums) == 1 else "are"
    what = NOT_OF_LEFT_OUT if not_named.together(content) else ALSO_ELSEWHERE
    return [first_upper(what.format(f"{listing(sums)} {are}", each, percent(share)))] if sums else []


def no_promise(content: Verdict, words: Vocabulary) -> list[str]:
    """The remark that a sure name is no good prediction, where unseen strokes are poorly predicted."""
    sure = [id_ for id_ in known(content) if is_sure(content, words, id_)]
    act = "acts" if len(sure) == 1 else "act"
    return [NO_PROMISE.format(listing(sure), act)] if sure and unseen.partly(content, words) else []


def poorly_known(content: Verdict, words: Vocabulary) -> dict[str, tuple[float, float]]:
    """The effects whose size the recording leaves open, each with its interval."""
    sizes_of = {entry["id"]: interval(entry, f"rms_{words.ending}") for entry in content["mechanisms"]}
    return {
        id_: (size["low"], size["high"])
        for id_, size in sizes_of.items()
        if wide(size) or hidden(size["value"], content, words)
    }


def partly_hidden(content: Verdict, words: Vocabulary) -> list[str]:
    """The effects larger than the mismatch: moved dimensions must take back a part of each."""
    key = f"rms_{words.ending}"
    limit = rivals.MORE * amount(mismatch_of(content), key) if content["mismatch"] else float("inf")
    return [entry["id"] for entry in content["mechanisms"] if interval(entry, key)["value"] > limit]


def wide(size: Interval) -> bool:
    """Whether the interval of a size is wide."""
    return size["high"] > max(WIDE * size["low"], size["low"])


def hidden(own: float, content: Verdict, words: Vocabulary) -> bool:
    """Whether an effect is far larger than the mismatch, so that moved dimensions must take back most of it."""
    return bool(own > rivals.LARGER * amount(mismatch_of(content), f"rms_{words.ending}"))
