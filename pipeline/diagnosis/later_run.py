"""A later run of a joint diagnosis: it is simulated after the runs before it, for what goes on does not begin anew."""

from collections.abc import Sequence
from pathlib import Path

from ..ground.complaint import key_name
from ..ground.kinematics import Array
from ..ground.names import RUN_NAME
from ..run.folder import has_recording
from ..run.samples import read_strokes
from .content import Simulated
from .own_rate import at_own_rate
from .problem import Problem
from .recorded_run import RecordedRun
from .simulation import tared


def names_before(content: Simulated, run: str) -> list[str]:
    """The runs before one in the diagnosis of several, in their order."""
    together = content.get("run")
    return together[: together.index(run)] if isinstance(together, list) and run in together else []


def simulated_before(content: Simulated, run: str, folder: Path) -> list[RecordedRun]:
    """The runs before one in its joint diagnosis, as they lie beside its folder; none unless all of them do.

    Raises BadInput for a recording that cannot be read.
    """
    names = names_before(content, run)
    beside = [folder.resolve().parent / name for name in names if RUN_NAME.fullmatch(str(name))]
    if len(beside) < len(names) or not all(has_recording(place) for place in beside):
        return []
    return [RecordedRun(*read_strokes(place)) for place in beside]


def predicted_after(
    before: Sequence[RecordedRun], recorded: RecordedRun, problem: Problem, content: Simulated, source: Path
) -> Array:
    """What a diagnosis simulates for a run after those before it; `problem` is the run's own, at its own rate.

    Shape (samples,) of the run, in the channel's unit; raises BadInput as `tared` does.
    """
    whole = at_own_rate([*before, recorded], thin=False, to_fit=False) if before else problem
    return tared(whole, content, source, recorded.run.run)[-len(problem.record) :]


def said_of(content: Simulated, run: str, before: Sequence[RecordedRun], source: Path) -> list[str]:
    """What a person must know of the runs before one in its joint diagnosis; nothing where there are none."""
    names = [key_name(name) for name in names_before(content, run)]
    if not names:
        return []
    listed = " and ".join(names)
    if before:
        return [f"it is simulated after {listed}, as they were diagnosed together"]
    return [
        f"beware: {source} was made of {listed} and {run} together, and here {listed} does not go before. What goes on "
        "over time or strokes begins anew, so the reading may be far off. Mend: keep the runs in one folder, and give "
        "a planned motion --after-recording"
    ]
