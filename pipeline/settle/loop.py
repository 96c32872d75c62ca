"""The loop: each turn advances the last step by one state, so that it can go on after a kill at any point."""

from dataclasses import dataclass, field, replace
from pathlib import Path

from ..capture.motion_program import as_legs
from ..ground.errors import BadInput
from ..notebook.of_folders import Options, diagnose, once_read
from ..run.folder import read_run
from . import move
from .answers import Answers
from .approve import approved, told
from .choose import Budget, chosen, firm
from .ending import settled
from .first import first_run
from .foretold_figure import draw
from .limits import beyond
from .motor import Motor
from .proposed import ProposedRun, retimed, without_curves
from .sheet import MAKES, hand_out, hung_before
from .step import Place, Step
from .tie import so_far

DONE, FAULT, STOPPED = 0, 1, 130


@dataclass(frozen=True)
class Loop:
    """The arguments of the loop: the folder of its steps, the motor's limits, and the budget.

    By its `options` each recording is read once, however many steps are diagnosed with it.
    """

    runs: list[Path]
    place: Place
    motor: Motor
    way: str
    budget: Budget
    answers: Answers = field(init=False)
    options: Options = field(default_factory=lambda: Options(rivals=True, reader=once_read()))

    def __post_init__(self) -> None:
        object.__setattr__(self, "answers", Answers(self.place.out))

    def go(self) -> int:
        """Go on until it is settled; an exit status."""
        self.answers.begin()
        steps = self.place.steps() or [self._begun()]
        before = steps[0].proposal.get("runs")
        if before != [str(run) for run in self.runs]:
            mend = "name another --out, or the runs with which it was begun"
            raise BadInput(self.place.out, "step-0", f"is of {' and '.join(before or [])}", mend)
        self.place.check(steps)
        if move.waits_for_a_person(steps[-1], MAKES):  # who may have other limits now, or a rig at a port
            steps[-1] = self.place.write(steps[-1].at("proposed", approved_by=None))
        while not self.answers.stopped():
            step = steps[-1]
            if step.state == "recorded":
                steps[-1] = self._diagnosed(steps)
            elif step.state == "diagnosed":
                proposed = self._proposed(steps)
                if proposed is None:
                    return DONE
                steps.append(proposed)
            elif step.state == "proposed":
                if (why := self._anew(steps)) is not None:
                    print(f"step {step.number}: what was proposed is proposed anew: {why}", flush=True)
                    steps.pop()
                    steps = steps or [self._begun()]
                    continue
                approved_step = self._approved(step)
                if approved_step is not None:
                    steps[-1] = approved_step
                elif not self.answers.stopped():
                    end = "not approved: nothing was moved; started again it asks again"
                    print("; ".join(filter(None, (f"step {step.number}: {end}", so_far(step, self.place)))))
                    return DONE
            else:
                steps[-1], status = self._recorded(step)
                if status:
                    return status
        print("stopped by somebody at the page: nothing moves; started again it goes on from here", flush=True)
        return STOPPED

    def _begun(self) -> Step:
        """Step 0: the existing runs, or a proposed first recording."""
        begun: ProposedRun = {"runs": [str(run) for run in self.runs]}
        if len(self.runs) > 1 or move.begun(self.runs[0]):
            return self.place.write(Step(0, "recorded", proposal=begun))
        run_dir = self.runs[0]
        proposed = first_run(read_run(run_dir), self.motor.limits(), self.budget)
        return self._written(Step(0, "proposed", str(run_dir), {**without_curves(proposed), **begun}), proposed)

    def _written(self, step: Step, proposed: ProposedRun) -> Step:
        """A proposed step with its run, drawn before it is made, and the limits at that time."""
        step = step.at("proposed", proposal={**step.proposal, "limits": {**self.motor.allowed.given}})
        self.place.write_run(step.number, proposed)
        if "curves" in proposed:
            self._draw(step)
        return self.place.write(step)

    def _all_runs(self, steps: list[Step]) -> list[Path]:
        return [*self.runs, *(Path(step.run_dir or "") for step in steps[1:] if step.run_dir and step.used)]

    def _diagnosed(self, steps: list[Step]) -> Step:
        """All runs so far in one diagnosis, with the new samples drawn over their prediction."""
        step, folders = steps[-1], self._all_runs(steps)
        if step.number == 0 and not step.used:
            mend = "make another run's folder with new_run, and start settle with that one"
            raise BadInput(step.run_dir or "", "first recording", f"is too short to be used ({step.ended})", mend)
        out = self.place.folder(step.number)
        if step.legs and step.used:
            self._draw(step, Path(step.run_dir or ""))
        diagnose(folders, out, replace(self.options, together=len(folders) > 1))
        verdict = self.place.diagnosis(step.number)["verdict"]
        print(
            f"step {step.number}: the verdict of {len(folders)} run{'s' * (len(folders) > 1)} is {verdict}", flush=True
        )
        return self.place.write(step.at("diagnosed", verdict=verdict))

    def _draw(self, step: Step, came: Path | None = None) -> None:
        path = self.place.folder(step.number) / ("came" if came else "proposed")
        who = "each explanation" if step.number else "the simulator of run.yaml"
        what = f"what {who} foretold, and what came" if came else f"what {who} foretells"
        title = f"Step {step.number}, {Path(step.run_dir or '').name}, {step.proposal['title']}: {what}"
        draw(self.place.proposed_run(step.number), path, title, self.options.reader(came).table if came else None)

    def _proposed(self, steps: list[Step]) -> Step | None:
        """The next run, drawn before it is made; None, and settled.json, where there is none."""
        last = steps[-1]
        options = self.place.next_runs(last.number)
        verdicts = [self.place.diagnosis(step.number) for step in steps[-2:]]
        if firm(
            [(verdict["verdict"], [each["id"] for each in verdict["mechanisms"]]) for verdict in verdicts],
            bool(options),
        ):
            self._settled(steps, "verdict", f"the verdict is {last.verdict}")
            return None
        budget_left = self.budget.left(steps)
        step, why = chosen(options, last.number + 1, self.motor.bounds(), budget_left)
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
        step = step.at("proposed", run_dir=str(move.free_dir(self.runs[0], self.runs[-1])))
        option = next(option for option in options if option["title"] == step.proposal["title"])
        return self._written(step, retimed(option, step.legs))

    def _settled(self, steps: list[Step], why: str, sentence: str) -> None:
        settled(self.place, steps, self._all_runs(steps), self.budget, why, sentence)

    def _anew(self, steps: list[Step]) -> str | None:
        """Why an earlier proposal is not asked about: limits changed, or it exceeds them."""
        step, budget_left = steps[-1], self.budget.left(steps[:-1])
        if step.proposal.get("limits", self.motor.allowed.given) != self.motor.allowed.given:
            return "--limits are others now"
        return (beyond(as_legs(step.legs), self.motor.bounds()) if step.legs else None) or budget_left.lacks(step)

    def _approved(self, step: Step) -> Step | None:
        by_hand = self.motor.takes() is None
        step = hung_before(step) if by_hand else step
        print(told(step, self.place), flush=True)
        yes = step.at("approved", approved_by=MAKES) if by_hand else approved(step, self.way, self.answers)
        return self.place.write(yes) if yes else None

    def _recorded(self, step: Step) -> tuple[Step, int]:
        """Make the run; returns the step, and an exit status where the loop must end here."""
        folder = Path(step.run_dir or "")
        move.describe(folder, self.runs[-1], step)
        if move.begun(folder) and self.motor.port:
            if move.mended(folder):
                return self.place.write(move.came(step)[0]), DONE
            if step.number == 0:
                mend = "remove that empty file and start again"
                raise BadInput(folder, "recording.frames", "is empty: nothing was recorded", mend)
            # it was approved, and nothing moved
            return self.place.write(step.at("approved", run_dir=str(move.free_dir(self.runs[0], self.runs[-1])))), DONE
        if self.motor.takes() is not None:
            self.motor.follow(step, self.place, self.answers.stopped)
        else:
            why = "the rig's HELLO declares no limits of a program" if self.motor.port else "no --port was given"
            print(hand_out(step, self.place, self.runs[-1], why), flush=True)
            if not move.wait_for(folder, self.answers.stopped):
                return step, DONE
        recorded_step, by_person = move.came(step)
        self.place.write(recorded_step)
        if recorded_step.ended is None:
            return recorded_step, DONE
        ending = f"{recorded_step.ended}; what came is kept. Started again it goes on from here"
        print(f"step {step.number}: {folder}: {ending}")
        return recorded_step, STOPPED if by_person else FAULT
