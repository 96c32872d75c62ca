"""The run to make next, in words: the protocol, what it is expected to tell, and how its recording is diagnosed."""

from typing import Any

from . import worth
from .quantity import number
from .technician import Part, lasting, parts
from .vocabulary import Vocabulary


def title(run: dict[str, Any], words: Vocabulary) -> str:
    """What the run is called."""
    said = run["title"] if words.twisted else run["title"].replace("twist", words.motion)
    return f"{said[0].upper()}{said[1:]}"


def brief(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """A run that decides nothing, in as few lines as that is worth."""
    run = content["next_run"]
    called = title(run, words)
    said = f"{worth.first(run)[0]} It would be {called[0].lower()}{called[1:]}, {lasting(run)} in all"
    return [f"{said}; its steps are `next_run` in diagnosis.json.", worth.purpose(content, words, False)]


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
    new = new_load(part, run)
    if not new:
        known = f", under {part.load} as recorded" if run.get("fixed_load") and part.load and run.get("load") else ""
        return f"{run_word}{known}:" if number_ else ""
    change = f"change the load from {number(run['load'])} to {part.load}"
    said = f"{change}, and say so in run.yaml (`{words.load}: {new}`) unless a channel records it"
    return f"{run_word}: {said}:" if number_ else f"Before it, {said}."


def loads(run: dict[str, Any], words: Vocabulary) -> list[str]:
    """The load that new_run is given for each run to record: empty where it stays, and on a rig without a string."""
    found = [new_load(part, run) for part in parts(run, words, 1.0)]
    return [load.replace(",", "") if words.twisted else "" for load in found]


def new_load(part: Part, run: dict[str, Any]) -> str:
    """The load that a run is recorded under, where it stands still in a recording and must be changed before it."""
    usual = run.get("load")
    if not run.get("fixed_load") or not part.load or usual is None:
        return ""
    value = part.value
    return "" if abs(value - usual) <= 0.03 * abs(usual) else number(value)


def together(run: dict[str, Any], words: Vocabulary) -> str:
    """How the new recording is diagnosed."""
    several = len(parts(run, words, 1.0)) > 1
    of = "of the same string, with the same `string.id`" if words.twisted else "of the same rig"
    record = f"Record {'each' if several else 'it'} as a new run {of}"
    return f"{record}, and diagnose {'them' if several else 'it'} together with this one (`--together`)."


def in_one_line(content: dict[str, Any], words: Vocabulary, whole: float) -> str:
    """All of it as one string, as `next_experiment` holds it."""
    run = content["next_run"]
    said = [f"{title(run, words)}: {lasting(run)} in all.", *steps(run, words, whole)]
    said += [worth.care(content, words), worth.purpose(content, words), together(run, words)]
    return " ".join(line for line in said if line)
