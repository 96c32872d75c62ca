"""The words of `simulate` on its simulator: what acts, whose dimensions, and warnings that it may not fit."""

import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import cast

from ..ground.command import command
from ..run.description import Run
from .document.content import Verdict
from .prediction.another_rig import other_dimensions, other_names
from .prediction.later_run import said_of
from .prediction.simulation import measured_since
from .prediction.without_a_name import said_of_no_name
from .recording.recorded_run import RecordedRun
from .simulator import Simulator
from .words.foretold.another_rig import warning as another_rig
from .words.language.quantity import listing
from .words.language.vocabulary import Vocabulary
from .words.measured.dimensions import name_of
from .words.pages.advice import contrary


def by(simulator: Simulator, dimensions: Path) -> str:
    """With what a motion was simulated: the acting effects, and the file of the dimensions."""
    adopted = simulator.content["parameters"] and simulator.given is None
    return f"with {simulator.acting} and the dimensions {'that fit with them, in' if adopted else 'of'} {dimensions}"


def of_simulator(simulator: Simulator, run: Run, before: Sequence[RecordedRun]) -> list[str]:
    """What a reader must know of the simulator: the runs before, that it is no name, advice against it."""
    content, called = simulator.content, Vocabulary.of(run.system)
    source = simulator.source if simulator.given is not None else f"what {simulator.source} has adopted"
    words = [*said_of(content, run.run, before, source), *said_of_no_name(content, called.ending)]
    advised = contrary(cast(Verdict, content), called) if simulator.given is not None and content["simulation"] else ""
    return words + [f"beware: the verdict advises against what is simulated: {advised.rstrip('.')}"] * bool(advised)


def of_another(simulator: Simulator, run: Run, folder: Path, at_hand: Sequence[Run] = ()) -> list[str]:
    """The warning that a run is of another string or rig than the runs that a given diagnosis was made of.

    Those `at_hand` are known; others are looked for beside `folder`.
    """
    content = simulator.content
    runs = content.get("run")
    runs = [str(name) for name in (runs if isinstance(runs, list) else [runs])]
    if simulator.given is None or run.run in runs:
        return []
    dimensions, names = other_dimensions(content, run), other_names(content, run, folder, at_hand)
    warning = another_rig(run.run, runs, dimensions, names, Vocabulary.of(run.system))
    return [warning] if warning else []


def of_dimensions(run: Run, folder: Path) -> list[str]:
    """The warning that a dimension of run.yaml changed since effects were adopted, so that these fit no more."""
    changed = measured_since(run)
    if not changed:
        return []
    names = listing([f"the {name_of(name)}" for name in changed])
    return [
        f"{names} in run.yaml changed since the effects were adopted. The dimensions of run.yaml are taken, and the "
        "effects may not fit them. Mend: take the effects out, diagnose again and adopt anew: "
        f"{command('adopt')} --remove {shlex.quote(str(folder))}"
    ]
