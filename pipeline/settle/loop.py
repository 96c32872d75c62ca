"""The loop itself: each turn takes the last step one state further, so that it goes on wherever it was killed."""

import json
from dataclasses import dataclass
from pathlib import Path

from ..capture.motion import as_legs
from ..diagnose import diagnose
from ..ground.errors import BadInput
from ..ground.files import write_text
from ..wire.motion import Limits
from . import move
from .approve import approved, told
from .choose import Budget, chosen, firm
from .drawing import draw
from .limits import Allowed, beyond
from .sheet import sheet
from .step import Place, Step

DONE, FAULT, STOPPED = 0, 1, 130


@dataclass(frozen=True)
class Loop:
    """What the loop was asked for; `port` is None where a person moves the rig."""

    runs: list[Path]
    place: Place
    port: str | None
    baud: int
    way: str
    allowed: Allowed
    budget: Budget

    def go(self) -> int:
        """Go on until it is settled; an exit status."""
        steps = self.place.steps() or [self._begun()]
        before = steps[0].proposal.get("runs")
        if before != [str(run) for run in self.runs]:
            mend = "name another --out, or the runs with which it was begun"
            raise BadInput(self.place.out, "step-0", f"is of {' and '.join(before or [])}", mend)
        while True:
            step = steps[-1]
            if step.state == "recorded":
                steps[-1] = self._diagnosed(steps)
            elif step.state == "diagnosed":
                proposed = self._proposed(steps)
                if proposed is None:
                    return DONE
                steps.append(proposed)
            elif step.state == "proposed":
                if self._too_far(steps):
                    steps.pop()
                    continue
                found = self._approved(step)
                if found is None:
                    print(f"step {step.number}: not approved: nothing was moved; started again it asks again")
                    return DONE
                steps[-1] = found
            else:
                steps[-1], status = self._recorded(step)
                if status:
                    return status

    def _begun(self) -> Step:
        step = Step(0, "recorded", proposal={"runs": [str(run) for run in self.runs]})
        return self.place.write(step)

    def _all_runs(self, steps: list[Step]) -> list[Path]:
        return [*self.runs, *(Path(step.run_dir or "") for step in steps[1:] if step.run_dir and step.used)]

    def _diagnosed(self, steps: list[Step]) -> Step:
        """All runs so far in one diagnosis, and what came drawn over what was foretold."""
        step, folders = steps[-1], self._all_runs(steps)
        out = self.place.folder(step.number)
        diagnose(folders, out, together=len(folders) > 1, rivals=True)
        verdict = self.place.diagnosis(step.number)["verdict"]
        if step.number and step.used:
            self._draw(step, Path(step.run_dir or ""))
        print(
            f"step {step.number}: the verdict of {len(folders)} run{'s' * (len(folders) > 1)} is {verdict}", flush=True
        )
        return self.place.write(step.at("diagnosed", verdict=verdict))

    def _draw(self, step: Step, came: Path | None = None) -> None:
        entry = next(one for one in self.place.next_runs(step.number - 1) if one["title"] == step.proposal["title"])
        path = self.place.folder(step.number) / ("came" if came else "proposed")
        draw(entry, path, f"{step.proposal['title']}: what each explanation foretells", came)

    def _proposed(self, steps: list[Step]) -> Step | None:
        """The next run, drawn before it is made; None, and settled.json, where there is none."""
        last = steps[-1]
        options = self.place.next_runs(last.number)
        said = [self.place.diagnosis(step.number) for step in steps[-2:]]
        if firm([(one["verdict"], [each["id"] for each in one["mechanisms"]]) for one in said], bool(options)):
            self._settled(steps, "verdict", f"the verdict is {last.verdict}")
            return None
        left = self.budget.left(steps)
        step, why = chosen(options, last.number + 1, self._limits(), left)
        if step is None and last.verdict == "explained":
            self._settled(steps, "verdict", f"the verdict is explained; no other run confirms it: {why}")
            return None
        if step is None:
            self._settled(steps, "no run", why)
            return None
        if last.verdict == "explained":
            print(f"step {step.number}: is to confirm what is explained, but not surely")
        if why:
            print(f"step {step.number}: passed over: {why}")
        step = step.at("proposed", run_dir=str(move.free_dir(self.runs[0])))
        self._draw(step)
        return self.place.write(step)

    def _settled(self, steps: list[Step], why: str, sentence: str) -> None:
        found, left = self.place.diagnosis(steps[-1].number), self.budget.left(steps)
        spent = {"runs": self.budget.runs - left.runs, "strokes": self.budget.strokes - left.strokes}
        content = {
            "why": why,
            "sentence": sentence,
            "verdict": found["verdict"],
            "mechanisms": [entry["id"] for entry in found["mechanisms"]],
            "alternatives": found["alternatives"],
            "runs": [str(run) for run in self._all_runs(steps)],
            "spent": {**spent, "minutes": round(self.budget.minutes - left.minutes, 3)},
        }
        write_text(self.place.out / "settled.json", json.dumps(content, indent=1, ensure_ascii=False) + "\n")
        named = f": {' + '.join(content['mechanisms'])}" if content["mechanisms"] else ""
        print(f"settled: {sentence}{named if why == 'verdict' else ''}", flush=True)

    def _too_far(self, steps: list[Step]) -> bool:
        """Whether a run that was proposed earlier is beyond what is allowed now."""
        step, left = steps[-1], self.budget.left(steps[:-1])
        return (beyond(as_legs(step.legs), self._limits()) or left.lacks(step)) is not None

    def _approved(self, step: Step) -> Step | None:
        print(told(step, self.place), flush=True)
        if self._rig() is not None:
            found = approved(step, self.way)
        else:
            found = step.at("approved", approved_by="the person who makes it")
        return self.place.write(found) if found else None

    def _recorded(self, step: Step) -> tuple[Step, int]:
        """The run is made; the step, and an exit status where the loop is to end here."""
        folder = Path(step.run_dir or "")
        move.describe(folder, self.runs[-1])
        if move.begun(folder) and self.port:
            if not move.mended(folder):  # it was approved, and nothing moved
                return self.place.write(step.at("approved", run_dir=str(move.free_dir(self.runs[0])))), DONE
            return self.place.write(move.came(step)[0]), DONE
        rig = self._rig()
        if rig is not None:
            self._move(step, rig)
        else:
            why = "the rig's HELLO declares no limits of a program" if self.port else "no --port was given"
            text = sheet(step, self.runs[-1], why)
            write_text(self.place.folder(step.number) / "sheet.txt", text)
            print(text, flush=True)
            move.wait_for(folder)
        found, by_person = move.came(step)
        self.place.write(found)
        if found.ended is None:
            return found, DONE
        print(f"step {step.number}: {folder}: {found.ended}; what came is kept. Started again it goes on from here")
        return found, STOPPED if by_person else FAULT

    def _move(self, step: Step, rig: Limits) -> None:
        """Make an approved run; raises BadInput where the limits of now forbid it."""
        why = beyond(as_legs(step.legs), self.allowed.within(rig))
        if why is not None:
            mend = (
                f"widen --limits if that is safe, or remove {self.place.folder(step.number)} to have another proposed"
            )
            raise BadInput(step.run_dir or "", "approved run", why, mend)
        move.record(step, self.port or "", self.baud)

    def _rig(self) -> Limits | None:
        """What the rig takes of a program now; None where a person moves it. Raises BadInput for lack of limits."""
        found = move.limits_of(self.port, self.baud) if self.port else None
        if found is not None and self.way == "auto":
            self.allowed.check_unattended(found)
        return found

    def _limits(self) -> Limits | None:
        rig = self._rig()
        return self.allowed.within(rig) if rig else None
