"""Which part of a diagnosis holds in a recording that it was not made of: tried on that recording's first stroke.

An effect may belong to one recording alone, such as a string that was still stretching. Dimensions that calibration
moved may hold what the library lacks. So a diagnosis of one recording can foretell another one worse than the
dimensions of run.yaml do. The first stroke, on which the motor is homed where it has a zero, shows that.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import cast

from ...ground.errors import BadInput
from ..document.content import Simulated
from ..fit.problem import Problem
from .motor_zero import HOME, Home, homed, left_of_first

CLEARLY = 0.8  # of the whole diagnosis' residual on the first stroke: a part of it that leaves less is taken instead


@dataclass(frozen=True)
class CarriedOver:
    """The part of a diagnosis that is used for another recording: all, some of it, or the motor's zero alone.

    `content` is the simulator, its motor homed; `home` is None for a rig without a zero of the motor. `effects`,
    `dimensions`: whether those of the diagnosis are in it. `left` is what each part that was tried leaves of the first
    stroke, rms, in the reading's unit, by whether effects and dimensions of the diagnosis are in it.
    """

    content: Simulated
    home: Home | None
    effects: bool
    dimensions: bool
    left: dict[tuple[bool, bool], float]

    @property
    def whole(self) -> bool:
        """Whether all of the diagnosis is taken."""
        return self.effects and self.dimensions


def carried_over(
    problem: Problem, content: Simulated, path: Path, run: str, coarse: Problem | None = None
) -> CarriedOver:
    """The part of a diagnosis that simulates another run, homed on its first stroke: all, or a clearly better one.

    `coarse` is the same recording in averages. Nothing after that stroke is read for the choice. Raises BadInput for a
    run that the diagnosis was made of, and where the simulator gives no number.
    """
    runs = content.get("run")
    if run == runs or (isinstance(runs, list) and run in runs):
        why = "is one that the diagnosis was made of: all of it holds there, and so does its motor's zero"
        raise BadInput(HOME, run, why, "leave it out")
    parts: dict[tuple[bool, bool], Simulated] = {(True, True): content}
    if content["parameters"]:
        parts[True, False] = cast(Simulated, {**content, "parameters": {}})
    if content["simulation"]:
        parts |= {(False, took): cast(Simulated, {**part, "simulation": []}) for (_, took), part in parts.items()}
    homes = problem.system.homed is not None
    tried: dict[tuple[bool, bool], tuple[Simulated, Home | None]] = {
        kept: homed(problem, part, path, run, coarse) if homes else (part, None) for kept, part in parts.items()
    }
    error_by_part = {
        kept: home.left if home else left_of_first(problem, part, path, run) for kept, (part, home) in tried.items()
    }
    best = min(error_by_part, key=lambda kept: error_by_part[kept])
    if error_by_part[best] >= CLEARLY * error_by_part[True, True]:
        best = True, True
    return CarriedOver(*tried[best], *best, error_by_part)
