"""A proposed run as a sheet for a person, where the rig cannot be commanded."""

import shlex
from pathlib import Path

from ..ground.command import command
from .motion_table import speed
from .step import STANDS, Step


def sheet(step: Step, like: Path, why: str) -> str:
    """What to do, leg by leg, and how to record it; `why` says why the rig is not moved by this program."""
    folder = Path(step.run_dir or "")
    lines = [f"Run {folder.name}: {step.proposal['title']}", f"By hand, since {why}.", ""]
    lines += [*before(step), "What the motor does:"] if step.legs else []
    at, hangs = step.proposal.get("from", 0.0), step.loads_n[0] if len(step.loads_n) == 1 else None
    for number, leg in enumerate(step.legs, 1):
        to, load = leg["motor_turns"], leg.get("load_n")
        moves = abs(to - at) > STANDS
        does = f"go from {at:.2f} to {to:.2f} turns in" if moves else f"stand at {to:.2f} turns for"
        pace = f", at {speed(to - at, leg['seconds'], None):.2f} turns/s" if moves else ""
        weight = f", under {load:g} N" if load is not None and load != hangs and len(step.loads_n) != 1 else ""
        lines.append(f"  {number}. {does} {leg['seconds']:.1f} s{pace}{weight}")
        at, hangs = to, load if load is not None else hangs
    record = f"{command('capture')} PORT {shlex.quote(str(folder))}"
    lines += [
        *([""] if step.legs else []),
        f"Record all of it as one run: {record} (add --text where the rig prints lines of numbers),",
        f"or put recording.csv into {folder}; its run.yaml is there, and says the string of {like}.",
        "When the recording is there, this program goes on by itself.",
    ]
    return "\n".join(lines) + "\n"


def before(step: Step) -> list[str]:
    """What to hang before the motion begins, or that a recording needs a column of the load where that changes."""
    if len(step.loads_n) == 1:
        return [f"Before it, hang {step.loads_n[0]:g} N, and leave it there."]
    sentence = "The load changes on the way: record it as load_n too, for run.yaml can give one load only."
    return [sentence] if step.loads_n else []


def hung_before(step: Step) -> Step:
    """A step whose one load hangs from the beginning on: a person hangs it before the run, and not while it goes."""
    if len(step.loads_n) != 1:
        return step
    legs = [leg | {"load_n": step.loads_n[0]} for leg in step.legs]
    return step.at(step.state, proposal={**step.proposal, "legs": legs, "load": step.loads_n[0]})
