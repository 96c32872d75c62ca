"""Whether runs are of one string on one rig, so that they can be diagnosed together; if not, which fields differ."""

import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..ground.command import command
from ..ground.errors import BadInput
from ..run.description import Run
from .recording.recorded_run import RecordedRun
from .words.language.quantity import listing


def of_one_rig(recorded: list[RecordedRun]) -> None:
    """Raise BadInput unless all runs are of one string on one rig, with the same channels."""
    first = recorded[0]
    for each in recorded:
        if each.run.actuator != first.run.actuator:
            problem = f"is {each.run.actuator}, not {first.run.actuator}"
            raise BadInput(each.place, "actuator", problem, "diagnose them apart")
        for field in ("rig", "string", "tolerance"):
            if described(each.run, field) != described(first.run, field):
                mend = "diagnose the runs of each string on each rig apart"
                raise BadInput(each.place, field, f"is not that of {first.run.run}", mend)
        if each.run.simulation != first.run.simulation:
            raise adopted_apart(first, each)
    load = first.run.system.load
    for each in recorded:
        if load and (load in each.samples) != (load in first.samples):
            mend = "diagnose runs with and without it apart"
            raise BadInput(each.place, load, f"is in {'it' if load in each.samples else first.place} only", mend)


def adopted_apart(first: RecordedRun, other: RecordedRun) -> BadInput:
    """The sentence that two runs have adopted different effects: which run has some, and how to take them out."""
    names = [each.run.run for each in (first, other) if each.run.simulation]
    without = [each.run.run for each in (first, other) if not each.run.simulation]
    problem = f"{names[0]} has adopted effects, {listing(without) or names[-1]} has {'not' if without else 'others'}"
    commands = to_take_out([(each.run, each.place) for each in (first, other)])
    return BadInput(other.place, "simulation", problem, f"take them out first: {listing(commands)}")


def to_take_out(runs: Sequence[tuple[Run, Path]]) -> list[str]:
    """The commands that take adopted effects out of runs, so that these can be diagnosed together.

    Nothing where all have adopted the same.
    """
    if all(run.simulation == runs[0][0].simulation for run, _ in runs):
        return []
    return [f"{command('adopt')} --remove {shlex.quote(str(folder))}" for run, folder in runs if run.simulation]


def described(run: Run, field: str) -> Any:
    """The part of `run.yaml` that runs of one rig must share: all but load, strokes before and id."""
    value = getattr(run, field)
    if field == "rig":
        return {key: entry for key, entry in value.items() if key != "load_n"}
    return value.model_copy(update={"strokes_before": 0, "id": None}) if field == "string" and value else value
