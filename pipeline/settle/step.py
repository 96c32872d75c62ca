"""One step of the loop as a file: its proposal and its progress; it survives a kill at any moment."""

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from ..ground.errors import BadInput
from ..ground.stored.checked_json import read_checked
from ..ground.stored.files import write_text
from .proposed import LegJson, ProposedRun, StepVerdict
from .stored_step import ANEW, Options, Proposed, State, Verdict, check_form, read_formed

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
            content = read_checked(path, ANEW)
            check_form(path, State, content)
            if content["number"] != len(steps):
                raise BadInput(path, "number", "is no step of this folder", ANEW)
            steps.append(Step(**content))
        return steps

    def write_run(self, number: int, run: ProposedRun) -> None:
        """Write the run that a step proposes, with its prediction."""
        write_text(self.folder(number) / PROPOSED, json.dumps(run, ensure_ascii=False) + "\n")

    def proposed_run(self, number: int) -> ProposedRun:
        """The run that a step proposes, with its prediction; raises BadInput where it cannot be read."""
        run: ProposedRun = read_formed(self.folder(number) / PROPOSED, Proposed)
        return run

    def diagnosis(self, number: int) -> StepVerdict:
        """The diagnosis of a step; raises BadInput where it cannot be read."""
        verdict: StepVerdict = read_formed(self.folder(number) / "diagnosis.json", Verdict, self._again(number))
        return verdict

    def next_runs(self, number: int) -> list[ProposedRun]:
        """The possible runs after a step, the best first; raises BadInput where they cannot be read."""
        runs: list[ProposedRun] = read_formed(self.folder(number) / "next_runs.json", Options, self._again(number))
        return runs

    def check(self, steps: Sequence[Step]) -> None:
        """Read what the loop goes on with, before anything moves; raises BadInput where it cannot be read."""
        last = steps[-1]
        if (last.legs or last.state in ("proposed", "approved")) and "title" not in last.proposal:
            raise BadInput(self.folder(last.number) / NAME, "proposal.title", "is missing", ANEW)
        for step in steps[-2:]:
            if step.state == "diagnosed":
                self.diagnosis(step.number)
        if last.state == "diagnosed":
            self.next_runs(last.number)
        elif (self.folder(last.number) / PROPOSED).is_file():
            self.proposed_run(last.number)

    def _again(self, number: int) -> str:
        """How a damaged diagnosis of a step is mended: of the last step it can be made once more."""
        state = self.folder(number) / NAME
        if (self.folder(number + 1) / NAME).is_file():
            return ANEW
        return f'set "state" in {state} to "recorded", and start again: its runs are diagnosed once more'
