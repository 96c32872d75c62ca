"""What a hold and a rest show of a slow effect that no row of the table has, in words; or that they show nothing."""

from dataclasses import dataclass

from ...document.content import Verdict
from ...document.expected import ExpectedExplanation
from ...document.made_keys import amount_or_none
from ...proposal import design
from ..language.quantity import duration, listing, size
from ..language.vocabulary import Vocabulary
from .foretold_numbers import Number, apart, of_explanation

STANDS = ("hold", "rest")
UNTELLING = "A hold and a rest of {} do not tell {} from {} {}."
WHOLE_RUN = "A single number does not decide. Only the fit of the whole run together with this one does."


@dataclass(frozen=True)
class _Sign:
    """Where the best explanation changes and a rival stands still: the stands, and the largest change of the rival.

    `firm`: the best explanation's own plus-minus leaves no doubt that it changes by more than that.
    """

    rival: ExpectedExplanation
    stands: tuple[str, ...]
    still: float
    firm: bool


def of_whole_run(content: Verdict) -> list[str]:
    """The sentence that the next run decides only as a whole; nothing where no run is expected to decide."""
    run = content["next_run"]
    decides = run is not None and "parts" in run and design.decides(run["gap_now"], run["gap_then"])
    return [WHOLE_RUN] if decides else []


def lines(content: Verdict, words: Vocabulary, compared: list[ExpectedExplanation]) -> list[str]:
    """The sentence that decides between the best explanation and a rival, or says that a hold and a rest do not.

    Empty where the best explanation foretells no hold or no rest. The rival is the explanation that differs from the
    best one in most stands of the motor (hold, rest).
    """
    if not compared:
        return []
    first, *others = compared
    own = {stand: of_explanation(first, stand, content, words) for stand in STANDS}
    if not others or any(cell is None for cell in own.values()):
        return []
    signs = [_sign(first, other, content, words) for other in others]
    best = max(signs, key=lambda sign: len(sign.stands))
    stand = duration(content["evidence"]["expected"]["stand_s"])
    if not best.stands:
        names = listing([apart(first, other)[1] for other in others], "or")
        where = "here" if content["evidence"]["loaded"] or words.load is None else "under one load"
        return [UNTELLING.format(stand, apart(first, others[0])[0], names, where)]
    named, rival = apart(first, best.rival)
    if not best.firm:
        return [_undecided(named, rival, best, stand, content, words)]
    return [_decision(named, rival, best, own, stand, words)]


def is_untelling(line: str) -> bool:
    """Whether a line says that a hold and a rest do not tell."""
    begin, tell, _ = UNTELLING.split("{}", 2)
    return line.startswith(begin) and tell in line


def _sign(first: ExpectedExplanation, other: ExpectedExplanation, content: Verdict, words: Vocabulary) -> _Sign:
    """Where the rival stands still within its interval, and the best explanation moves by more than that."""
    stands, still, firm = [], 0.0, True
    for stand in STANDS:
        own, cell = (of_explanation(each, stand, content, words) for each in (first, other))
        if own is None or cell is None or abs(cell.value) > cell.half_width:
            continue
        most = abs(cell.value) + cell.half_width
        if abs(own.value) > most:
            stands.append(stand)
            still = max(still, most)
            firm = firm and abs(own.value) - own.half_width > most
    return _Sign(other, tuple(stands), still, firm)


def _decision(named: str, rival: str, sign: _Sign, own: dict[str, Number | None], stand: str, words: Vocabulary) -> str:
    limit = size(sign.still, words.unit)
    if sign.stands == STANDS:
        hold, rest = (cell.value if cell else 0.0 for cell in own.values())
        then = "at least a part of that comes back" if hold * rest < 0.0 else "it goes on in the same way"
        return (
            f"In words: if it is {named}, the reading changes by more than {limit} in a hold of {stand}, and {then} in "
            f"a rest of {stand} after it; if it is {rival}, it changes by less than {limit} in both."
        )
    where = f"in a {sign.stands[0]} of {stand}"
    return f"In words: if it is {named}, the reading changes by more than {limit} {where}; if it is {rival}, by less."


def _undecided(named: str, rival: str, sign: _Sign, stand: str, content: Verdict, words: Vocabulary) -> str:
    """What the rival does alone, and why nobody can say by how much the best explanation changes there."""
    covered = content["evidence"].get("covered") or {}
    longest_s = {each: amount_or_none(covered, f"longest_{each}_s") for each in STANDS}
    longest = [f"{each}s of up to {duration(seconds)}" for each, seconds in longest_s.items() if seconds is not None]
    where = listing([f"in a {each} of {stand}" for each in sign.stands])
    short = f" (it has {listing(longest)})" if longest else ""
    return (
        f"In words: if it is {rival}, the reading changes by less than {size(sign.still, words.unit)} {where}. By how "
        f"much it changes if it is {named} cannot be said: this recording was too short for it{short}."
    )
