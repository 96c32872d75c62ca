"""What a proposed run is expected to tell, and whether it is worth making, in words."""

from ....ground.command import command
from ...document.content import Verdict, proposal
from ...document.expected import NextRun
from ...document.made_keys import amount, extent
from ...fit.adopt import NO_USE
from ...proposal import design
from ...proposal.design import PLAIN, deviations
from ..explanations import probability, rivals
from ..held_out import in_vain
from ..language.quantity import number, place_near, size, times, to_tell
from ..language.vocabulary import Vocabulary
from . import parting, recorded_so_far

COMPARED = 4  # explanations that a proposed run is to part
CARE = {
    "twice the speed": "Only if the motor can go so fast.",
    "twice the load": "Only if the rig bears so much.",
    "another load": "Only if the rig bears so much.",
}  # by what a title says
TESTED = "in tests such runs settled 30 of 50 ties rightly and 5 wrongly, and left 15 open"  # docs/settle.md
MEANT = (
    "Standard deviations say how far apart the two predictions of the run are, in the noise of the recording. They "
    f"promise too much: {TESTED}."
)
FOLLOWS = "It shows whether what is missing follows {}, as here, or what went along with it."
WRONG = "Against the noise alone they are far apart, but a formula that is wrong by 10 % could make the same difference"


def first(run: NextRun) -> list[str]:
    """The remark before the steps of a run that decides nothing."""
    return [] if "parts" not in run or raises(run) else [f"{NO_USE}: you can skip it."]


def purpose(content: Verdict, words: Vocabulary) -> str:
    """Whether the run is worth making, which two explanations it parts, how probable each is, and how far."""
    run = proposal(content)
    if "parts" not in run:
        return FOLLOWS.format(words.follows(run["follows"])) if "follows" in run else ""
    worth = "Worth making" if decides(run) else "Worth a try"
    advice = f"{worth} if you need to know {question(content)}; otherwise {otherwise(content, words)}."
    value = advice if raises(run) else first(run)[0]
    explanation, other = (probable(ids, content) for ids in run["parts"])
    count = min(COMPARED, 1 + len(content["alternatives"]))
    closest = f", the closest two of the {count} likeliest explanations" if count > 2 else ""
    sentences = (
        f"{value} It is to tell {explanation} from {other}{closest}.{aside(content)}",
        parting.sentence(content),
        readings(content, run, words),
        gaps(run),
    )
    return " ".join(part for part in sentences if part)


def gaps(run: NextRun) -> str:
    """How far the closest two predictions are apart without the run and with it, and what that is worth."""
    now, then = deviations(run["gap_now"]), deviations(run["gap_then"])
    so_far = f"So far the closest two predictions differ by {number(now)} standard deviations"
    if not decides(run):
        who = "A formula that is wrong by a few per cent" if then > PLAIN else "Noise alone"
        best = "No other run that was tried in simulation does better"
        end = f"{best}, so none decides."
        if raises(run):
            end = "So it need not decide."
        if now > PLAIN:
            return (
                f"{WRONG}, so this recording does not decide. {so_far}; with the run by {number(then)}. {end} {MEANT}"
            )
        return f"{so_far}; with the run by {number(then)}. {who} can make as much. {end} {MEANT}"
    if now <= PLAIN:
        return f"{so_far}; with the run it should be {number(then)}. {MEANT}"
    more = f"{times(then / now)} times as much"
    with_it = f"With the run it should be {number(then)}, {more}: a formula would have to be wrong by {more}"
    return (
        f"{WRONG}, so this recording does not decide. {so_far}. {with_it} to make that. So the run can decide. {MEANT}"
    )


def readings(content: Verdict, run: NextRun, words: Vocabulary) -> str:
    """By how much the two readings should differ in the run; nothing where an older file does not say it."""
    readings_apart = run.get("apart")
    if not readings_apart:
        return ""
    low, high = extent(content["evidence"], words.driver)
    most = size(amount(readings_apart, f"by_{words.ending}"), words.unit)
    near = place_near(amount(readings_apart, words.driver), words.motion_unit, high - low)
    names = [rivals.called(ids) for ids in run["parts"]]
    differ = amount(readings_apart, f"by_{words.ending}")
    both = to_tell(
        [amount(readings_apart, f"{which}_{words.ending}") for which in ("first", "second")], differ, words.unit
    )
    return (
        f"In it, if it follows this recording at once, the two predicted readings differ by up to {most}, most near "
        f"{near}: {both[0]} if it is {names[0]}, {both[1]} if it is {names[1]}."
    )


def probable(ids: list[str], content: Verdict) -> str:
    """An explanation by its name with its probability, if it has one."""
    likely = probability.said(share(ids, content))
    return f"{rivals.called(ids)}{f' ({likely})' if likely else ''}"


def share(ids: list[str], content: Verdict) -> float | None:
    """The probability of an explanation; None where it has none."""
    shown = (explanation for explanation in content["evidence"]["explanations"] if set(explanation["ids"]) == set(ids))
    own_probability = next((explanation.get("probability") for explanation in shown), None)
    return None if own_probability is None else float(own_probability)


def question(content: Verdict) -> str:
    """The question that the run answers: the difference of the two explanations that it parts."""
    first_ids, other_ids = proposal(content)["parts"]
    pairs = ((first_ids, other_ids), (other_ids, first_ids))
    rests = [rivals.called([id_ for id_ in ids if id_ not in both]) for ids, both in pairs if set(ids) - set(both)]
    if len(rests) < 2:
        return f"whether {''.join(rests)} is at work"
    return f"which is at work: {' or '.join(rests)}"


def differing(content: Verdict) -> set[str]:
    """The effects that only one of the run's two explanations has."""
    first_ids, other_ids = proposal(content)["parts"]
    return set(first_ids) ^ set(other_ids)


def aside(content: Verdict) -> str:
    """The remark that the best explanation differs at least as much from the two that the run was chosen for."""
    best = {entry["id"] for entry in content["mechanisms"]}
    concerned = best in [set(ids) for ids in proposal(content)["parts"]]
    return "" if concerned else " The best explanation is neither of the two: it differs from both by at least as much."


def otherwise(content: Verdict, words: Vocabulary) -> str:
    """What to do with tied explanations without the run."""
    count = 1 + len(content["alternatives"])
    if in_vain.harmful(content, words):
        return f"report all {count} explanations and adopt none"
    return f"report the best explanation as one of {count}"


def decides(run: NextRun) -> bool:
    """Whether a run is expected to part two explanations far enough to decide."""
    return design.decides(run["gap_now"], run["gap_then"])


def raises(run: NextRun) -> bool:
    """Whether a run is expected to part two explanations further, so far that it can be seen at all."""
    return design.raises(run["gap_now"], run["gap_then"])


def under_this_load(run: NextRun, words: Vocabulary) -> str:
    """The command that looks for a run without another load; nothing where no run of such a rig is looked for."""
    load = run.get("load")
    if words.driver != "motor_turns" or not run.get("fixed_load") or not load:
        return ""
    hangs = f"{load:.4g}"
    look = f"{command('settle')} RUN --limits '{{load_n: [{hangs}, {hangs}]}}'"
    return f" `{look}` looks for one under this load; it says where none does."


def care(content: Verdict, words: Vocabulary) -> str:
    """What to check before the rig is driven in a new way, and what to do if it cannot be."""
    run = proposal(content)
    new = {"speed": recorded_so_far.asks_speed(content, words), "load": recorded_so_far.asks_load(content, words)}
    changes = {change: text for change, text in CARE.items() if all(new[what] or what not in change for what in new)}
    caution = next((text for change, text in changes.items() if change in run["title"]), "")
    if "load" in run["title"] and words.load:
        cannot = "If your rig cannot change its load, "
    elif caution:
        cannot = "If your rig cannot go so fast, "
    else:
        return ""
    if "parts" in run:
        lost = "the likelier explanations stay tied" if decides(run) else "less is learnt"
        cannot += f"leave this run out: {lost}."
        if "load" in run["title"] and words.load:
            cannot += under_this_load(run, words)
    else:
        cannot += (
            "make the run at the other speed alone: it shows less." if "speed" in run["title"] else "leave it out."
        )
    return " ".join(part for part in (caution, cannot) if part)
