"""What is at work foresees stretches that it was not fitted to."""

from pipeline.diagnosis import order
from pipeline.diagnosis.engine import make_problem, study
from pipeline.ingest import read_samples
from pipeline.rig.others import cases
from pipeline.rig.others.made import write_run


def test_what_is_there_foresees_stretches_that_what_is_not_does_not(tmp_path):
    write_run(cases.make("mass-two", 312), tmp_path / "a-01")
    run, samples = read_samples(tmp_path / "a-01")
    search = study(make_problem([run], [samples])).search
    both = search.explain(("friction_hysteresis", "viscous_loss"))
    tried = [both, search.explain(("sensor_drift",)), search.nothing]
    true, false, nothing = order.left_out_errors(search.linear, tried)
    assert true < 0.3 * false and true < 0.3 * nothing
