"""A proposed run as a sheet for a person, where the rig cannot be commanded."""

import shlex
from collections.abc import Sequence
from pathlib import Path

from ..ground.command import command
from ..ground.stored.files import write_text
from .expected_loop import expected_loops
from .motion_table import speed
from .step import Place, Step

MAKES = "the person who makes it"  # who approves a run that this program does not move
LEAST_TOLD_S = 1.0  # a person stands no shorter than that on purpose
SAME_LOAD = 0.01  # share: less is no other load


def hand_out(step: Step, place: Place, like: Path, why: str) -> str:
    """Write the sheet of a run into its step's folder, with each explanation's predicted loop; returns its text."""
    proposed = place.proposed_run(step.number)
    loops = expected_loops(step, proposed["curves"]) if "curves" in proposed else []
    text = sheet(step, like, why, loops)
    write_text(place.folder(step.number) / "sheet.txt", text)
    return text


def sheet(step: Step, like: Path, why: str, loops: Sequence[str] = ()) -> str:
    """What to do, leg by leg, and how to record it; `why` says why the rig is not moved by this program.

    `loops` are sentences of what each explanation foretells.
    """
    folder = Path(step.run_dir or "")
    lines = [f"Run {folder.name}: {step.proposal['title']}", f"By hand, since {why}.", ""]
    if step.legs:
        motion = [f"  {number}. {does}" for number, does in enumerate(steps(step), 1)]
        lines += [*before(step), "What the motor does:", *motion, *loops, ""]
    load = f" and load_n: {step.loads_n[0]:g}, where no channel records it" if len(step.loads_n) == 1 else ""
    record = f"{command('capture')} PORT {shlex.quote(str(folder))}"
    lines += [
        f"Record all of it as one run: {record} (add --text where the rig prints lines of numbers),",
        f"or put recording.csv into {folder}; its run.yaml is there, and says the string of {like}{load}.",
        "When the recording is there, this program goes on by itself.",
    ]
    return "\n".join(lines) + "\n"


def steps(step: Step) -> list[str]:
    """The steps for a person, in words: invisible ways and pauses are left out, and there is time to hang loads."""
    loads, at, stood_s = step.loads_n, step.proposal.get("from", 0.0), 0.0
    hangs_n = _first_load(step)
    lines = list[str]()

    def stand() -> None:
        nonlocal stood_s
        if stood_s >= LEAST_TOLD_S:
            lines.append(f"stand at {at:.2f} turns for {stood_s:.1f} s")
        stood_s = 0.0

    for leg in step.legs:
        to, load_n = leg["motor_turns"], leg.get("load_n")
        if load_n is not None and len(loads) > 1 and _other(load_n, hangs_n):
            stand()
            place = "" if hangs_n is None else f" in place of {hangs_n:g} N"
            lines.append(f"hang {load_n:g} N{place} at {at:.2f} turns, in your own time")
            hangs_n = load_n
        if abs(to - at) > step.still_turns:
            stand()
            pace = f"{speed(to - at, leg['seconds'], None):.2f} turns/s"
            lines.append(f"go from {at:.2f} to {to:.2f} turns in {leg['seconds']:.1f} s, at {pace}")
        else:
            stood_s += leg["seconds"]
        at = to
    stand()
    return lines


def before(step: Step) -> list[str]:
    """What to hang before the motion begins, or that a changing load needs a column in the recording."""
    if len(step.loads_n) == 1:
        return [f"Before it, hang {step.loads_n[0]:g} N, and leave it there."]
    if not step.loads_n:
        hangs_n = step.proposal.get("load")
        return [f"Leave the load as it hangs{'' if hangs_n is None else f', {hangs_n:g} N'}."]
    first = _first_load(step)
    sentence = "The load changes on the way: record it as load_n too, for run.yaml can give one load only."
    return [sentence, *([] if first is None else [f"Before it, hang {first:g} N."])]


def hung_before(step: Step) -> Step:
    """A step for a person: it starts where the run begins, and a single load hangs from the beginning."""
    legs, stands = step.legs, step.proposal.get("from", 0.0)
    if legs and abs(legs[0]["motor_turns"] - stands) <= step.still_turns:
        step = step.at(step.state, proposal={**step.proposal, "from": legs[0]["motor_turns"]})
    if len(step.loads_n) != 1:
        return step
    legs = [leg | {"load_n": step.loads_n[0]} for leg in step.legs]
    return step.at(step.state, proposal={**step.proposal, "legs": legs, "load": step.loads_n[0]})


def _first_load(step: Step) -> float | None:
    return next((leg["load_n"] for leg in step.legs if leg.get("load_n") is not None), None)


def _other(load_n: float, hangs_n: float | None) -> bool:
    return hangs_n is None or abs(load_n - hangs_n) > SAME_LOAD * max(abs(load_n), abs(hangs_n))
