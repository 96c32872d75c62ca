"""Slow effects that look like a named one under one load: whether the recording excludes each, in words."""

from ...document.content import Verdict
from ...document.made_keys import amount, amount_or_none
from ..explanations import other_effects
from ..language.explained_words import tells
from ..language.quantity import listing, size, times
from ..language.vocabulary import Vocabulary
from ..measured.other_load import single, under_single
from . import certainty

EXCLUDED = (
    "Measured: with one of these in the place of {named} what is left changes while the motor stands, by more than the "
    "noise: {out}. Each was tried by the library's formula, where it leaves least ({heading} says where). "
    "You may write that in a paper. Beside {named} each may still act, but too little to be named."
)


def excluded(content: Verdict, words: Vocabulary) -> list[str]:
    """The look-alikes that this recording excludes: they contradict the stands of the motor by more than the noise.

    One that is wrong there by less is open: an effect too small to be named, such as the stretch under a load that
    swings by a hundredth, bends the fit of the right one as much. Nothing where the motor never stood long enough, or
    where a file lacks `not_kept`.
    """
    if not content["evidence"].get("not_kept"):
        return []
    first, *others = content["evidence"]["not_kept"]
    alike, floor = _all(content, words), amount(content["evidence"], f"floor_{words.ending}")
    return [
        entry["id"] for entry in others
        if entry["id"] in alike and other_effects.excludes(entry, first, floor)
    ]  # fmt: skip


def _by_how_much(content: Verdict, ids: list[str], words: Vocabulary) -> list[str]:
    """Excluded look-alikes, each with its error in holds and in rests."""
    first, *others = content["evidence"]["not_kept"]
    entries, floor = {entry["id"]: entry for entry in others}, amount(content["evidence"], f"floor_{words.ending}")
    wrong_by_id = {id_: other_effects.wrong_by(entries[id_], first, floor, words) for id_ in ids}
    stands = other_effects.STANDS
    return [
        f"{id_} ({listing([f'by {wrong} {stands[phase]}' for phase, wrong in wrong_by_id[id_].items()])})"
        for id_ in ids
    ]


def still_open(content: Verdict, words: Vocabulary) -> list[str]:
    """The look-alikes that this recording does not exclude."""
    out = excluded(content, words)
    return [id_ for id_ in _all(content, words) if id_ not in out]


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """The excluded look-alikes, then a sentence for each open one; nothing without a named slow effect."""
    slow = certainty.slow_alike(content, words)
    if not slow:
        return []
    named, out, may_be = listing(slow), excluded(content, words), still_open(content, words)
    head = f"{under_single(content)} slow effects look alike.{f' {_how_sure(content, slow)}' if may_be else ''}"
    by = listing(_by_how_much(content, out, words)) if out else ""
    meant = f" {EXCLUDED.format(named=named, out=by, heading=other_effects.HEADING)}" if out else ""
    could = f" What {named} could be instead:" if may_be else ""
    return [f"{head}{meant}{could}", *(f"- {id_}{_why_open(content, id_, words)}" for id_ in may_be)]


def unsettled(content: Verdict, words: Vocabulary) -> str:
    """The remark that one load cannot settle a slow effect's name, to stand before its percentage; else empty."""
    slow = certainty.slow_alike(content, words)
    if not slow or not still_open(content, words):
        return ""
    acts = "is surely at work" if _surely(content, slow) else "is likely at work"
    by = f"By {'the probability of ' * bool(certainty.known(content))}the library's formulas"
    return f"something slow {acts}, but {single(content)} cannot settle its name. {by}: "


def doubts(content: Verdict, words: Vocabulary) -> list[str]:
    """The page's first remark on open look-alikes; nothing where none is open."""
    slow, may_be = certainty.slow_alike(content, words), still_open(content, words)
    if not slow or not may_be:
        return []
    return [f"{under_single(content)} what is called {listing(slow)} can be {listing(may_be, 'or')}."]


def _how_sure(content: Verdict, slow: list[str]) -> str:
    """How sure it is that any one of the `slow` effects acts."""
    return f"That something slow acts is {'sure' if _surely(content, slow) else 'likely'}; its name is not sure."


def _surely(content: Verdict, slow: list[str]) -> bool:
    """Whether it is sure that any one of the `slow` effects acts."""
    return not certainty.at_limit(content) and any(certainty.is_likely(content, id_) for id_ in slow)


def remark(content: Verdict, words: Vocabulary, sure: list[str]) -> str:
    """What a report must add to the slow effects among the `sure` ones; ends a statement."""
    slow = [id_ for id_ in certainty.slow_alike(content, words) if id_ in sure]
    may_be, out = still_open(content, words), excluded(content, words)
    if not slow:
        return ""
    if may_be:
        rest = f"{single(content)} cannot tell it from {listing(may_be, 'or')}"
        return f" ({listing(slow)} as the library's name for a slow effect: {rest})"
    return f"; not {listing(out, 'or')} in its place, whose formulas are wrong while the motor stands"


def _all(content: Verdict, words: Vocabulary) -> list[str]:
    slow = certainty.slow_alike(content, words)
    return certainty.slow_others(content, slow) if slow else []


def _why_open(content: Verdict, id_: str, words: Vocabulary) -> str:
    """Why a look-alike is open, and which recording would tell it from the named effect."""
    test = f"A recording tells: {tells(id_, words)}."
    if any(id_ in ids for ids in content["alternatives"]):
        return f": another likely explanation has it. {test}"
    entries = [entry for entry in content["evidence"].get("not_kept", []) if entry["id"] == id_]
    left_rms = amount_or_none(entries[0], f"left_{words.ending}") if entries else None
    if left_rms is None:
        return f": this recording does not show it. {test}"
    ratio = times(left_rms / amount(content["evidence"], f"floor_{words.ending}"))
    leaves = f"the library's formula of it leaves {size(left_rms, words.unit)} ({ratio} times the noise)"
    return f": {leaves}, but another law of it could do what is seen. {test}"
