"""The noise of single samples on a rig that is compared in averages."""

from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.fit import calibrate
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem
from pipeline.diagnosis.study.own_rate import to_score
from pipeline.diagnosis.study.single_floor import single_floor
from pipeline.rig.others import cases
from pipeline.rig.others.made import write_run
from pipeline.run.samples import read_strokes


@pytest.mark.parametrize(("case", "ending", "step_s"), [("cable-nothing", "deg", 0.02), ("mass-nothing", "n", 0.01)])
def test_a_drive_tells_the_noise_of_single_samples_and_over_how_long_it_averages(tmp_path, case, ending, step_s):
    write_run(cases.make(case, 3), tmp_path / "a-01")
    recorded = [RecordedRun(*read_strokes(tmp_path / "a-01"))]
    problem, fine = make_problem(recorded), to_score(recorded)
    state = calibrate.base(problem)
    averages = float(np.std(fine.measured - fine.simulate(state)))
    study = SimpleNamespace(problem=problem, best=state)
    noise_facts = single_floor(study, fine, recorded, averages)
    assert noise_facts["scored_step_s"] == pytest.approx(step_s, rel=0.05)
    if problem.system.differentiates:  # simulate and adopt count averages there too
        assert f"single_floor_{ending}" not in noise_facts
    else:
        assert noise_facts[f"single_floor_{ending}"] > 1.05 * averages
    assert single_floor(study, make_problem(recorded, most=10**9, thin=False), recorded, averages) == {}
