"""Concealed recordings by another hand (`otherhand.py`), made once a session."""

import otherhand
import pytest

from pipeline.diagnosis.engine import make_problem
from pipeline.diagnosis.recorded_run import RecordedRun
from pipeline.run.samples import read_samples


@pytest.fixture(scope="session")
def conceal(tmp_path_factory: pytest.TempPathFactory):
    """Make (once) a run with the given effects: `conceal("creep", kappa=1.5)` → its folder and the truth."""
    root, made = tmp_path_factory.mktemp("raw"), {}

    def make(*kinds: str, kappa: float = 1.5, seed: int = 7, rich: bool = True, nuisance: str = "plain"):
        key = (kinds, kappa, seed, rich, nuisance)
        if key not in made:
            name = f"run-{len(made)}"
            truth = otherhand.recording(root, name, [(kind, kappa) for kind in kinds], seed, rich, nuisance)
            made[key] = (root / name, truth)
        return made[key]

    return make


@pytest.fixture(scope="session")
def problem(conceal):
    """A problem with nothing concealed in it."""
    run, samples = read_samples(conceal()[0])
    return make_problem([RecordedRun(run, samples)])


@pytest.fixture(scope="session")
def one_load(conceal):
    """A problem recorded under one load at one speed without pauses, and its run."""
    run, samples = read_samples(conceal("creep", rich=False)[0])
    return make_problem([RecordedRun(run, samples)]), run
