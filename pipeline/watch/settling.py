"""The loop that settles this run's tie, from its folder: the step, its proposal, and its question."""

from pathlib import Path

from ..ground.errors import BadInput
from ..run.description import RUN_NAME
from ..settle.answers import Answers
from ..settle.choose import apart
from ..settle.ending import NAME as SETTLED
from ..settle.loop_lock import at_work
from ..settle.motion_table import HEAD, begins, size, table, winds
from ..settle.step import Place, Step
from .page_content import Came, Foretold, Loop, Moves

MOVES = ("proposed", "approved", "recorded")  # while what moves is of interest
RIVALS = 6
CAME = "came"  # the drawing of what came, without its ending


def moves(step: Step) -> Moves | None:
    """The motion of a run, leg by leg in numbers, and its purpose; None without a complete proposal."""
    if step.state not in MOVES or not step.legs:
        return None
    try:
        winding = winds(step) if step.state != "proposed" else None
        return {
            "begins": begins(step),
            "head": HEAD,
            "legs": table(step),
            "apart": apart(step.proposal),
            "winds": winding,
        }
    except (ValueError, KeyError, TypeError, AttributeError, ZeroDivisionError):
        return None


class Settling:
    """The folder of one loop, read anew at each look."""

    def __init__(self, out: Path, run_dir: Path) -> None:
        self.place, self.answers, self._first = Place(out), Answers(out), run_dir

    def step(self) -> Step | None:
        """The last step; None where there is no loop, or its state cannot be read."""
        try:
            steps = self.place.steps()
        except (BadInput, OSError):
            return None
        return steps[-1] if steps else None

    def run_dir(self, step: Step | None) -> Path:
        """The folder that is recorded now: that of the last step's run, beside the first run."""
        name = Path(step.run_dir).name if step and step.run_dir else ""
        folder = self._first.parent / name
        return folder if RUN_NAME.fullmatch(name) and (folder / "run.yaml").is_file() else self._first

    def told(self, step: Step | None) -> Loop | None:
        """The content for the page, or None where there is no loop."""
        if step is None:
            return None
        question = self.answers.question()  # before the proposal: of one that was replaced since nothing is approved
        working = at_work(self.place.out)
        return {
            "at_work": working,
            "stopping": working and self.answers.stopped(),
            "settled": (self.place.out / SETTLED).is_file(),
            "first": self._first.name,
            "step": step.number,
            "state": step.state,
            "title": str(step.proposal.get("title", "")),
            "size": size(step) if step.legs else "",
            "moves": moves(step),
            "verdict": step.verdict,
            "approved_by": step.approved_by,
            "question": question["question"] if working and question and question["step"] == step.number else None,
            "foretold": self._foretold(step),
            "came": self._came(step),
        }

    def _came(self, step: Step) -> Came | None:
        """The newest drawing of recorded samples over their prediction: its step, and its file; None without one."""
        for number in range(step.number, -1, -1):
            path = self.place.folder(number) / f"{CAME}.png"
            if path.is_file():
                return {"step": number, "file": str(path)}
        return None

    def _foretold(self, step: Step) -> Foretold | None:
        try:
            curves = self.place.proposed_run(step.number)["curves"]
            rivals = curves["rivals"] or {"the simulator of run.yaml": curves["calibrated"]}
            return {
                "alone": not curves["rivals"],
                "time_s": curves["time_s"],
                "motor_turns": curves["motor_turns"],
                "load": curves["load"],
                "calibrated": curves["calibrated"],
                "rivals": dict([*rivals.items()][:RIVALS]),
            }
        except (BadInput, OSError, KeyError):
            return None
