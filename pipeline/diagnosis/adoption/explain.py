"""What the adopted numbers in a run.yaml mean, for curious readers: nobody needs the meaning to predict."""

from pathlib import Path

import pandas as pd

from ...run.description import Run
from ...run.samples import read_strokes
from ..fit.problem import Problem
from ..prediction.simulation import of_run, state_of
from ..recording.recorded_run import RecordedRun
from ..study.own_rate import at_own_rate
from ..words.language.vocabulary import Vocabulary
from ..words.named import coefficients
from .adopted_effects import adopted_effects
from .block import KEY
from .number_sizes import sizes


def without_effects(run: Run, samples: pd.DataFrame, strokes: pd.DataFrame) -> Problem:
    """The problem of a recording as if its run.yaml had adopted nothing; one stroke is enough, nothing is fitted."""
    recorded = RecordedRun(run.model_copy(update={KEY: []}), samples, strokes)
    return at_own_rate([recorded], thin=run.system.differentiates, to_fit=False)


def explained(folder: Path) -> list[str]:
    """What the adopted numbers of a run's `run.yaml` mean, after what each effect does. Raises BadInput."""
    (run, samples, strokes), path = read_strokes(folder), folder / "run.yaml"
    if not run.simulation:
        return [f"{path} holds nothing that was adopted"]
    problem, words = without_effects(run, samples, strokes), Vocabulary.of(run.system)
    state = state_of(of_run(run), problem, path, run.run)
    does = {entry["id"]: entry["sentence"] for entry in adopted_effects(problem, run, words.ending)}
    dimensions = {
        parameter.name: (float(value), parameter.nominal)
        for parameter, value in zip(problem.parameters, state.values, strict=True)
    }
    return coefficients.lines(state.acts, problem.drivers, words, sizes(problem, state), does, dimensions)
