"""The next run in words: the protocol, what it is expected to tell, and how to diagnose its recording."""

from ...document.content import Verdict, proposal
from ...document.expected import NextRun
from ...proposal.design import AS_BEFORE
from ..language.quantity import number
from ..language.vocabulary import Vocabulary
from . import tells, worth
from .technician import Part, lasting, parts


def title(run: NextRun, words: Vocabulary) -> str:
    """What the run is called."""
    name = run["title"].removeprefix(", then ") or AS_BEFORE  # of an older file: nothing came before
    name = name if words.twisted else name.replace("twist", words.motion)
    return f"{name[0].upper()}{name[1:]}"


def brief(content: Verdict, words: Vocabulary) -> list[str]:
    """A run that decides nothing, in a few lines."""
    run = proposal(content)
    called = title(run, words)
    summary = f"{worth.first(run)[0]} It would be {called[0].lower()}{called[1:]}, {lasting(run)} in all"
    return [f"{summary}; its steps are `next_run` in diagnosis.json.", tells.in_short(content, words)]


def steps(run: NextRun, words: Vocabulary, whole: float) -> list[str]:
    """The protocol, a numbered line for each step; several runs, or another load, have a line before each run."""
    runs, lines = parts(run, words, whole), []
    for number_, part in enumerate(runs, start=1):
        head = heading(part, run, words, number_ if len(runs) > 1 else None)
        lines += ([head] if head else []) + [f"{place}. {line}" for place, line in enumerate(part.steps, start=1)]
    return lines


def heading(part: Part, run: NextRun, words: Vocabulary, number_: int | None) -> str:
    """What must be changed before a run, if anything."""
    run_word = f"Run {number_}" if number_ else "Before it"
    new = new_load(part, run)
    if not new:
        under_load = (
            f", under {part.load} as recorded" if run.get("fixed_load") and part.load and run.get("load") else ""
        )
        return f"{run_word}{under_load}:" if number_ else ""
    change = f"change the load from {number(run['load'])} to {part.load}"
    instruction = f"{change}, and say so in run.yaml (`{words.load}: {new}`) unless a channel records it"
    return f"{run_word}: {instruction}:" if number_ else f"Before it, {instruction}."


def loads(run: NextRun, words: Vocabulary) -> list[str]:
    """The load for new_run in each run to record: empty where it stays, and on a rig without a string."""
    values = [new_load(part, run) for part in parts(run, words, 1.0)]
    return [load.replace(",", "") if words.twisted else "" for load in values]


def new_load(part: Part, run: NextRun) -> str:
    """The load of a run, if the load is constant in a recording and must be changed before this one."""
    usual = run.get("load")
    if not run.get("fixed_load") or not part.load or usual is None:
        return ""
    value = part.value
    return "" if abs(value - usual) <= 0.03 * abs(usual) else number(value)


def together(run: NextRun, words: Vocabulary) -> str:
    """How the new recording is diagnosed."""
    several = len(parts(run, words, 1.0)) > 1
    of = "of the same string, with the same `string.id`" if words.twisted else "of the same rig"
    record = f"Record {'each' if several else 'it'} as a new run {of}"
    return f"{record}, and diagnose {'them' if several else 'it'} together with this one (`--together`)."


def in_one_line(content: Verdict, words: Vocabulary, whole: float) -> str:
    """All of it as one string, as `next_experiment` holds it."""
    run = proposal(content)
    sentences = [f"{title(run, words)}: {lasting(run)} in all.", *steps(run, words, whole)]
    sentences += [worth.care(content, words), worth.purpose(content, words), together(run, words)]
    return " ".join(line for line in sentences if line)
