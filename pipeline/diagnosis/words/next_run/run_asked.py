"""The run that a verdict asks for without steps, or why it asks for none: for page and details."""

from ...document.bounds import at_bound
from ...document.content import Verdict
from ..explanations import explanation_table, less_likely, probability
from ..held_out import holdout, in_vain, unseen
from ..held_out.without_name import UNNAMED, moved_in_vain
from ..language.quantity import listing, quantity
from ..language.vocabulary import Vocabulary
from . import recorded_so_far

NONE_NEEDED = {
    "consistent": "None is needed: nothing is missing that this recording could show. Other speeds, loads and pauses "
    "would show more.",
    "parameters": "None is needed: the dimensions alone explain this recording. To make sure, measure them again.",
    "explained": "None is needed: no other explanation of the library is as likely.",
}
PROVISIONAL = (
    "None is needed before dimensions are measured again: no other explanation of the library is as likely, but names "
    "are provisional while a dimension stands at its limit."
)
MAKES_SURE = " What makes sure of a name stands above, under What to do."
TO_CHOOSE = "None is needed to choose between explanations: no other explanation of the library is as likely."
MISSING_ALONE = " What shows what is still missing stands above, under What to do."
MISSING_TOO = " What makes sure of the name, and what shows what is still missing, stands above, under What to do."
BY_THE_RUN = ": by the run that stands above, under What to do"
COMES_FIRST = " What comes first stands above, under What to do."
BOTH = " What comes first, and what then makes sure of a name, stands above, under What to do."
NONE_WITH_ADOPTED = "None is proposed: beside what was adopted, this recording shows nothing further that can be named."
NONE_PROPOSED = (
    "None can be proposed: what is left follows no effect that could be named. Record the rig {other}, and diagnose "
    "the runs together (`--together`): more of what is left shows there."
)
MORE_STROKES = "Record the rig once more, with at least {strokes} strokes{first}, and diagnose all runs together."
ENOUGH = 8  # strokes: a diagnosis needs so many (docs/record.md)
TO_MAKE_SURE = (
    "No other explanation of the library is as likely, but make sure of the name before you adopt or report it{}."
)


def no_run(content: Verdict, words: Vocabulary, sure: bool, first: bool) -> list[str]:
    """The run that the page asks for, if none is proposed with steps; else why there is none.

    `sure`: the page's steps say how to confirm a name. `first`: the page has steps.
    """
    return [_without_probability(line, content) for line in _no_run(content, words, sure, first)]


def _without_probability(line: str, content: Verdict) -> str:
    """A line on likely explanations, reworded for a rig where no probability is known."""
    return line if probability.known(content) else line.replace("of the library is as likely", "fits as well")


def _no_run(content: Verdict, words: Vocabulary, sure: bool, first: bool) -> list[str]:
    verdict = content["verdict"]
    if in_vain.harmful(content, words):
        return [more_strokes(content, words)]
    if verdict in UNNAMED and unseen.left_over(content, words):
        return [NONE_PROPOSED.format(other=recorded_so_far.not_yet(content, words))]
    if verdict in UNNAMED and holdout.included(content):
        advised = [adoption.get("against_advice", [])[1:] for adoption in content.get("adopted", [])]
        recordings = " ".join(dict.fromkeys(recording for each in advised for recording in each))
        return [f"{recordings} The commands stand above, under What to do." if recordings else NONE_WITH_ADOPTED]
    if verdict == "parameters" and moved_in_vain(content, words):
        verdict = "consistent"
    if as_many := to_settle(content, words):
        return [PROVISIONAL + COMES_FIRST] * bool(at_bound(content["evidence"]["moved_sigma"])) + [as_many]
    if verdict == "explained" and at_bound(content["evidence"]["moved_sigma"]):
        return [PROVISIONAL + (BOTH if sure else COMES_FIRST * first)]
    if verdict == "explained" and in_vain.doubt(content, words):
        return [TO_MAKE_SURE.format(BY_THE_RUN * sure)]
    if verdict == "explained" and unseen.partly(content, words):
        return [TO_CHOOSE + (MISSING_TOO if sure else MISSING_ALONE)]
    above = MAKES_SURE * (sure and verdict == "explained")
    near = less_likely.only_if_wrong(content, explanation_table.numbered(content), words)
    if verdict == "explained" and near:
        above = f" Only if formulas err by 10 %, no. {less_likely.numbers(near)} would.{above}"
    return [NONE_NEEDED[verdict] + above] if verdict in NONE_NEEDED else []


def to_settle(content: Verdict, words: Vocabulary) -> str:
    """The recording that settles the name, if other effects are named without the last strokes; else nothing."""
    if content["verdict"] != "explained" or not holdout.of_other(content) or in_vain.doubt(content, words):
        return ""
    return f"To settle the name, record {as_many_again(content, words)}, and diagnose the runs together."


def as_many_again(content: Verdict, words: Vocabulary) -> str:
    """The recipe for as many strokes as recorded, with the ends of load and motion for the first of them."""
    first, last = content["evidence"]["strokes"]
    strokes = last - first + 1
    wider = beyond_the_first(content, words, by_name=True)
    begin = f"; begin with {listing(wider)}, which only the last strokes had" if wider else " in the same way"
    return f"{strokes} stroke{'s' * (strokes > 1)} again{begin}"


def more_strokes(content: Verdict, words: Vocabulary) -> str:
    """The recording to make where names change with the last strokes, and what its first strokes need."""
    first, last = content["evidence"]["strokes"]
    wider = beyond_the_first(content, words)
    among = f" ({listing(wider)} among the first)" if wider else ""
    return MORE_STROKES.format(strokes=max(ENOUGH, last - first + 1), first=among)


def beyond_the_first(content: Verdict, words: Vocabulary, by_name: bool = False) -> list[str]:
    """The ends of loads and motion that only the last strokes reached, each with its unit.

    `by_name`: each called low or high too.
    """
    units = {"load": words.load_unit, "motion": words.motion_unit}
    called = {"load": "load", "motion": words.motion}
    return [
        f"the {'low' if end < seen[0] else 'high'} {called[name]}, " * by_name + quantity(end, units[name])
        for name, (seen, later) in (content["evidence"].get("beyond_seen") or {}).items()
        for end in (later[0] if later[0] < seen[0] else None, later[1] if later[1] > seen[1] else None)
        if end is not None and quantity(end, units[name]) not in [quantity(seen_end, units[name]) for seen_end in seen]
    ]
