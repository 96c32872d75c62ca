"""One step of the loop as a file: what was proposed, and how far it is; it survives a kill at any moment."""

import json
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from ..ground.errors import BadInput
from ..ground.files import write_text

STATES = ("proposed", "approved", "recorded", "diagnosed")
NAME, PROPOSED = "state.json", "proposed.json"


@dataclass(frozen=True)
class Step:
    """A step: step 0 is what was there, or the first recording; each further one is a run that was proposed.

    `run_dir` is the folder of the run, `proposal` what `proposed.json` has of it without curves; `ended` says how its
    recording ended where that was not by itself.
    """

    number: int
    state: str
    run_dir: str | None = None
    proposal: dict[str, Any] = field(default_factory=dict)
    approved_by: str | None = None
    ended: str | None = None
    used: bool = True
    verdict: str | None = None

    def at(self, state: str, **changes: Any) -> "Step":
        """The same step further on."""
        return replace(self, state=state, **changes)

    @property
    def legs(self) -> list[dict[str, Any]]:
        """Legs of the proposal."""
        found: list[dict[str, Any]] = self.proposal.get("legs", [])
        return found

    @property
    def seconds(self) -> float:
        """How long its motion takes."""
        return float(sum(leg["seconds"] for leg in self.legs))

    @property
    def strokes(self) -> int:
        """How often its motion winds."""
        ways = [leg["motor_turns"] for leg in self.legs]
        before = [self.proposal.get("from", 0.0), *ways]
        return sum(to > at for at, to in zip(before, ways, strict=False))


def without_curves(entry: dict[str, Any]) -> dict[str, Any]:
    """A run that could be made, without what is foretold of it."""
    return {key: value for key, value in entry.items() if key != "curves"}


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
        found: list[Step] = []
        while (path := self.folder(len(found)) / NAME).is_file():
            try:
                step = Step(**json.loads(path.read_text(encoding="utf-8")))
                if step.number != len(found) or step.state not in STATES:
                    raise ValueError("is no step of this folder")
            except (ValueError, TypeError) as error:
                mend = "restore it, or name another --out to begin anew"
                raise BadInput(path, "state", f"cannot be read ({error})", mend) from None
            found.append(step)
        return found

    def write_run(self, number: int, entry: dict[str, Any]) -> None:
        """Write the run that a step proposes, with what is foretold of it."""
        write_text(self.folder(number) / PROPOSED, json.dumps(entry, ensure_ascii=False) + "\n")

    def proposed_run(self, number: int) -> dict[str, Any]:
        """The run that a step proposes, with what is foretold of it."""
        found: dict[str, Any] = json.loads((self.folder(number) / PROPOSED).read_text(encoding="utf-8"))
        return found

    def diagnosis(self, number: int) -> dict[str, Any]:
        """What the diagnosis of a step says."""
        found: dict[str, Any] = json.loads((self.folder(number) / "diagnosis.json").read_text(encoding="utf-8"))
        return found

    def next_runs(self, number: int) -> list[dict[str, Any]]:
        """Runs that could be made after a step, the best first."""
        found: list[dict[str, Any]] = json.loads((self.folder(number) / "next_runs.json").read_text(encoding="utf-8"))
        return found
