"""The run to make next, in words: the protocol, what it is expected to tell, and how its recording is diagnosed."""

import math
from typing import Any

from pipeline.diagnosis.words.quantity import listing, number, times
from pipeline.diagnosis.words.technician import Part, lasting, parts
from pipeline.diagnosis.words.vocabulary import Vocabulary

PLAIN = 5.0  # standard deviations, from which chance alone makes no tie
CARE = {
    "twice the speed": "Only if the motor can go so fast.",
    "twice the load": "Only if the rig bears so much.",
    "another load": "Only if the rig bears so much.",
}  # by what a title says
CANNOT = "If your rig cannot do this run, the likelier explanations stay tied."
LITTLE = 2.0  # times further apart, expected: less may not decide


def title(run: dict[str, Any], words: Vocabulary) -> str:
    """What the run is called."""
    said = run["title"] if words.twisted else run["title"].replace("twist", words.motion)
    return f"{said[0].upper()}{said[1:]}"


def steps(run: dict[str, Any], words: Vocabulary, whole: float) -> list[str]:
    """The protocol, a line each step, numbered; a line before each run where it takes several or another load."""
    found, lines = parts(run, words, whole), []
    for number_, part in enumerate(found, start=1):
        head = heading(part, run, words, number_ if len(found) > 1 else None)
        lines += ([head] if head else []) + [f"{place}. {line}" for place, line in enumerate(part.steps, start=1)]
    return lines


def heading(part: Part, run: dict[str, Any], words: Vocabulary, number_: int | None) -> str:
    """What must be changed before a run, if anything."""
    run_word = f"Run {number_}" if number_ else "Before it"
    usual = run.get("load")
    if not run.get("fixed_load") or not part.load or usual is None:
        return f"{run_word}:" if number_ else ""
    value = float(part.load.split()[0].replace(",", ""))
    if abs(value - usual) <= 0.03 * abs(usual):
        return f"{run_word}, under {part.load} as recorded:" if number_ else ""
    change = f"change the load from {number(usual)} to {part.load}"
    said = f"{change}, and say so in run.yaml (`{words.load}: {number(value)}`) unless a channel records it"
    return f"{run_word}: {said}:" if number_ else f"Before it, {said}."


def tried(one: list[str], other: list[str]) -> str:
    """What two explanations differ in."""
    rests = [listing([id_ for id_ in ids if id_ not in both]) for ids, both in ((one, other), (other, one))]
    rests = [f"({rest})" if " and " in rest else rest for rest in rests]
    return f"{rests[0]} from {rests[1]}" if all(rests) else f"whether {''.join(rests)} is at work"


def purpose(run: dict[str, Any], words: Vocabulary) -> str:
    """What the run is expected to tell."""
    if "parts" not in run:
        return f"It shows whether what is missing follows {words.follows(run['follows'])}." if "follows" in run else ""
    now, then = (math.sqrt(max(run[key], 0.0)) for key in ("gap_now", "gap_then"))
    said = f"This run is to tell {tried(*run['parts'])}."
    noise = "standard deviations"
    if now <= PLAIN:
        return (
            f"{said} So far the two predictions differ by {number(now)} {noise}; with the run it should be "
            f"{number(then)}."
        )
    formula = "That is no noise, but a formula that is wrong by a few per cent can make it too, so it does not decide."
    said = f"{said} So far the two predictions differ by {number(now)} {noise}. {formula}"
    if decides(run):
        more = f"{times(then / now)} times as much"
        return (
            f"{said} With the run they should differ by {number(then)}, {more}: a formula would have to be wrong "
            f"by {more} to make that. So the run can decide."
        )
    best = f"with the run it should be {number(then)}, and no other run that was tried in simulation does better"
    return f"{said} The run may not decide either: {best}. Make it only if the answer matters."


def care(run: dict[str, Any]) -> str:
    """What to mind before the rig is driven harder than it was."""
    said = next((said for words, said in CARE.items() if words in run["title"]), "")
    return f"{said} {CANNOT}" if said and "parts" in run and decides(run) else said


def decides(run: dict[str, Any]) -> bool:
    """Whether a run parts two explanations by so much more that it can be expected to decide."""
    return math.sqrt(max(run["gap_then"], 0.0)) >= LITTLE * math.sqrt(max(run["gap_now"], 0.0))


def numbers(run: dict[str, Any], words: Vocabulary) -> list[str]:
    """Endings that part the names of the runs to record: none for one alone."""
    count = len(parts(run, words, 1.0))
    return [f"-{number_}" for number_ in range(1, count + 1)] if count > 1 else [""]


def together(run: dict[str, Any], words: Vocabulary) -> str:
    """How the new recording is diagnosed."""
    several = len(numbers(run, words)) > 1
    of = "of the same string, with the same `string.id`" if words.twisted else "of the same rig"
    record = f"Record {'each' if several else 'it'} as a new run {of}"
    return f"{record}, and diagnose {'them' if several else 'it'} together with this one (`--together`)."


def in_one_line(run: dict[str, Any], words: Vocabulary, whole: float) -> str:
    """All of it as one string, as `next_experiment` holds it."""
    said = [f"{title(run, words)}: {lasting(run)} in all.", *steps(run, words, whole), care(run), purpose(run, words)]
    return " ".join([line for line in said if line] + [together(run, words)])
