"""One step of the loop as a file: its proposal and its progress; it survives a kill at any moment."""

import json
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from ..ground.errors import BadInput
from ..ground.stored.files import write_text
from .proposed import LegJson, ProposedRun, StepVerdict

STATES = ("proposed", "approved", "recorded", "diagnosed")
STANDS = 5e-3  # turns: a leg that goes less far stands
STILL = 5e-3  # of the run's range: a way so short is no stroke, and nobody sees it
NAME, PROPOSED = "state.json", "proposed.json"


@dataclass(frozen=True)
class Step:
    """A step: step 0 is the existing runs or the first recording; each further one is a proposed run.

    `run_dir` is the folder of the run, `proposal` what `proposed.json` has of it without curves; `ended` says how its
    recording ended where that was not by itself.
    """

    number: int
    state: str
    run_dir: str | None = None
    proposal: ProposedRun = field(default_factory=lambda: ProposedRun())
    approved_by: str | None = None
    ended: str | None = None
    used: bool = True
    verdict: str | None = None

    def at(self, state: str, **changes: Any) -> "Step":
        """The same step in a later state."""
        return replace(self, state=state, **changes)

    @property
    def legs(self) -> list[LegJson]:
        """Legs of the proposal."""
        return self.proposal.get("legs", [])

    @property
    def seconds(self) -> float:
        """How long its motion takes."""
        return float(sum(leg["seconds"] for leg in self.legs))

    @property
    def still_turns(self) -> float:
        """A way that is short enough for the motor to count as standing."""
        places = [self.proposal.get("from", 0.0), *(leg["motor_turns"] for leg in self.legs)]
        return max(STANDS, STILL * (max(places) - min(places)))

    @property
    def strokes(self) -> int:
        """How often its motion winds."""
        ways = [leg["motor_turns"] for leg in self.legs]
        before = [self.proposal.get("from", 0.0), *ways]
        return sum(to - at > self.still_turns for at, to in zip(before, ways, strict=False))

    @property
    def loads_n(self) -> list[float]:
        """The loads during its motion, in N, each once and in order; none if the run names no load."""
        before = [self.proposal.get("from", 0.0), *(leg["motor_turns"] for leg in self.legs)]
        moves = [
            leg for at, leg in zip(before, self.legs, strict=False) if abs(leg["motor_turns"] - at) > self.still_turns
        ]
        loads = [leg.get("load_n") for leg in moves]
        return list(dict.fromkeys(float(load) for load in loads if load is not None))


@dataclass(frozen=True)
class Place:
    """The folder in which the steps of one loop lie."""

    out: Path

    def folder(self, number: int) -> Path:
        """Folder of a step."""
        return self.out / f"step-{number}"

    def write(self, step: Step) -> Step:
        """Write a step's state, whole or not at all."""
        write_text(self.folder(step.number) / NAME, json.dumps(asdict(step), indent=1, ensure_ascii=False) + "\n")
        return step

    def steps(self) -> list[Step]:
        """All steps so far, in order; raises BadInput for a state that cannot be read."""
        steps: list[Step] = []
        while (path := self.folder(len(steps)) / NAME).is_file():
            try:
                step = Step(**json.loads(path.read_text(encoding="utf-8")))
                if step.number != len(steps) or step.state not in STATES:
                    raise ValueError("is no step of this folder")
            except (ValueError, TypeError) as error:
                mend = "restore it, or name another --out to begin anew"
                raise BadInput(path, "state", f"cannot be read ({error})", mend) from None
            steps.append(step)
        return steps

    def write_run(self, number: int, run: ProposedRun) -> None:
        """Write the run that a step proposes, with its prediction."""
        write_text(self.folder(number) / PROPOSED, json.dumps(run, ensure_ascii=False) + "\n")

    def proposed_run(self, number: int) -> ProposedRun:
        """The run that a step proposes, with its prediction."""
        run: ProposedRun = json.loads((self.folder(number) / PROPOSED).read_text(encoding="utf-8"))
        return run

    def diagnosis(self, number: int) -> StepVerdict:
        """The diagnosis of a step."""
        verdict: StepVerdict = json.loads((self.folder(number) / "diagnosis.json").read_text(encoding="utf-8"))
        return verdict

    def next_runs(self, number: int) -> list[ProposedRun]:
        """The possible runs after a step, the best first."""
        runs: list[ProposedRun] = json.loads((self.folder(number) / "next_runs.json").read_text(encoding="utf-8"))
        return runs
