"""Of tied explanations, the smallest that predicts about as well as the best stands first."""

from types import SimpleNamespace

import pytest

from pipeline.diagnosis.choice import cross_validation
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem, study
from pipeline.rig.others import cases
from pipeline.rig.others.made import write_run
from pipeline.run.samples import read_samples


def sets(*names):
    """Explanations by their ids."""
    return [SimpleNamespace(ids=tuple(name.split())) for name in names]


@pytest.mark.parametrize(
    ("errors", "first"),
    [
        ([1.0, 1.3, 2.0], "creep jam"),  # a third worse at most is as well, and smaller
        ([1.0, 1.5, 2.0], "creep jam wear"),
        ([1.0, 1.2, 1.1], "thermal"),
    ],
)
def test_the_smallest_that_foresees_as_well_stands_first_and_the_rest_stay(monkeypatch, errors, first):
    tied = sets("creep jam wear", "creep jam", "thermal")
    monkeypatch.setattr(cross_validation, "left_out_errors", lambda linear, sets: errors)
    ordered = [" ".join(one.ids) for one in cross_validation.by_prediction(None, tied)]
    assert ordered == [first, *(" ".join(one.ids) for one in tied if " ".join(one.ids) != first)]


def test_true_mechanisms_predict_left_out_stretches_and_others_do_not(tmp_path):
    write_run(cases.make("mass-two", 312), tmp_path / "a-01")
    run, samples = read_samples(tmp_path / "a-01")
    search = study(make_problem([RecordedRun.cut(run, samples)])).search
    both = search.explain(("friction_hysteresis", "viscous_loss"))
    tried = [both, search.explain(("sensor_drift",)), search.nothing]
    true, false, nothing = cross_validation.left_out_errors(search.linear, tried)
    assert true < 0.3 * false and true < 0.3 * nothing
