"""A later run of a joint diagnosis is simulated after the runs before it, since lasting effects do not begin anew."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any, cast

from ...ground.errors import BadInput
from ...ground.input.complaint import key_name
from ...ground.kinematics import Array
from ...ground.names import RUN_NAME
from ...run.description import Run
from ...run.folder import has_recording
from ...run.samples import read_strokes
from ..document.content import Simulated
from ..fit.problem import Problem
from ..recording.recorded_run import RecordedRun
from ..study.own_rate import at_own_rate
from .simulation import of_run, tared

KEEP = "keep the runs in one folder, and give a planned motion --after-recording"  # so that those before are at hand


def adopted_by(run: Run) -> Simulated:
    """What a run has adopted, in the form of a diagnosis: as `of_run`, after the runs that went before it in that.

    The motor's zero of each of these comes back: `of_run` has that of the run itself.
    """
    content, last = of_run(run), run.adopted[-1] if run.adopted and run.simulation else None
    together = (last and last.runs) or []
    if last is None or run.run not in together[1:]:
        return content
    number, parameters, homed = together.index(run.run) + 1, dict(content["parameters"]), run.system.homed
    for name, dimension in (last.dimensions or {}).items() if homed in parameters else []:
        if name.startswith(f"{homed}_"):
            parameters[name] = {"value": dimension.fitted}
    if own := parameters.get(f"{homed}_{number}"):
        parameters[str(homed)] = {"value": parameters[str(homed)]["value"] - own["value"]}
    return {**content, "run": together, "parameters": parameters}


def names_before(content: Simulated, run: str) -> list[str]:
    """The runs before one in the diagnosis of several, in their order."""
    together = content.get("run")
    return together[: together.index(run)] if isinstance(together, list) and run in together else []


def places_beside(folder: Path, names: Sequence[Any]) -> list[Path]:
    """The folders of other runs that lie beside a run's folder and hold a recording, in the order of their names."""
    beside = (folder.resolve().parent / name for name in names if isinstance(name, str) and RUN_NAME.fullmatch(name))
    return [place for place in beside if has_recording(place)]


def simulated_before(content: Simulated, run: str, folder: Path) -> list[RecordedRun]:
    """The runs before one in its joint diagnosis, as they lie beside its folder; none unless all of them do.

    Raises BadInput for a recording that cannot be read.
    """
    names = names_before(content, run)
    places = places_beside(folder, names)
    return [RecordedRun(*read_strokes(place), place) for place in places] if len(places) == len(names) else []


def before_of(content: Simulated, run: str, beside: Sequence[RecordedRun]) -> list[RecordedRun]:
    """As `simulated_before`, with the recordings of the joint diagnosis that were read `beside` it."""
    recorded_by_run = {each.run.run: each for each in beside}
    names = names_before(content, run)
    return [recorded_by_run[name] for name in names] if all(name in recorded_by_run for name in names) else []


def predicted_after(
    before: Sequence[RecordedRun], recorded: RecordedRun, problem: Problem, content: Simulated, source: Path,
    thin: bool = False,
) -> Array:  # fmt: skip
    """The simulation of a run after the runs before it; `problem` is the run's own, at its own rate.

    `thin`: that is at most the system's working rate. A dimension that `content` lacks is that of the run's own
    run.yaml. Shape (samples,) of the run, in the channel's unit; raises BadInput as `tared` does, and for a run before
    it that is of another kind of rig.
    """
    if not before:
        return tared(problem, content, source, recorded.run.run)
    for each in before:
        if each.run.actuator != recorded.run.actuator:
            another = f"is {each.run.actuator}, and {recorded.run.run}, which was diagnosed after it, is not"
            raise BadInput(each.place, "actuator", another, "put the run back that the diagnosis was made of")
    own = {parameter.name: {"value": parameter.nominal} for parameter in problem.parameters}
    complete = cast(Simulated, {**content, "parameters": {**own, **content["parameters"]}})
    whole = at_own_rate([*before, recorded], thin=thin, to_fit=False)
    return tared(whole, complete, source, recorded.run.run)[-len(problem.record) :]


def said_of(
    content: Simulated, run: str, before: Sequence[RecordedRun], source: Path | str, mend: str = KEEP
) -> list[str]:
    """The remark on the runs before one in the joint diagnosis `source`; nothing where there are none."""
    names = [key_name(name) for name in names_before(content, run)]
    if not names:
        return []
    listed, goes = " and ".join(names), "does" if len(names) == 1 else "do"
    if before:
        return [f"it is simulated after {listed}, as they were diagnosed together"]
    return [
        f"beware: {source} was made of {listed} and {run} together, and here {listed} {goes} not go before. What goes "
        f"on over time or strokes begins anew, so the reading may be far off. Mend: {mend}"
    ]
