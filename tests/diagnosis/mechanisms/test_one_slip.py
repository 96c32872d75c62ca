"""One slip is one event: beside it, a second one with the other sign is no event of its own."""

import numpy as np
import pandas as pd
import pytest
from made_recording import BASE, content, motion

from pipeline.diagnosis.fit.linear import Linear
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.numerics.noise import white
from pipeline.notebook.diagnosis import Diagnosis
from pipeline.notebook.recording import Recording


@pytest.mark.parametrize("id_", ["clamp_slip", "count_slip"])
def test_two_slips_within_a_few_samples_are_one(problem, id_) -> None:
    """A jump is seen by four samples on either side: slips that share some of them are seen together."""
    at_once, at_90, step_s = mechanisms()[id_].at_once, {"at_s": 90.0, "within_s": 0.0}, problem.drivers.step_s
    for steps, is_one in ((-8.1, False), (-7.9, True), (0.0, True), (0.2, True), (7.9, True), (8.1, False)):
        assert at_once(problem.drivers, at_90, {"at_s": 90.0 + steps * step_s, "within_s": 0.4}) is is_one
    assert not at_once(problem.drivers, at_90, {"at_s": -1.0, "within_s": 0.0}), "a little at every stroke"
    at_s = (20.0, 20.0 + 7 * step_s, 30.0, 30.0 + 9 * step_s, 40.0)
    options = [{"at_s": each_s, "within_s": 0.0} for each_s in at_s]
    linear = Linear(problem, problem.nominal(), white(1.0), {id_: options})
    assert linear.taken(id_, [0, 2]).tolist() == [True, True, True, False, False]
    assert not linear.taken(id_, []).any()


@pytest.mark.long
@pytest.mark.parametrize("slip_s", [100.013, 131.007])
def test_a_slip_between_two_samples_is_named_once(slip_s) -> None:
    """A slip of 0.8 mm was named as one of 1.82 and one of -1.02 mm, 7 ms apart."""
    corners = motion(9, top=18.0, rest_s=4.0, hold_s=4.0)
    time_s = np.arange(0.0, corners[-1, 0], 0.01)
    turns, rng = np.interp(time_s, corners[:, 0], corners[:, 1]), np.random.default_rng(1)
    x = BASE.contraction_mm(turns, 20.0) - 0.8 * (time_s >= slip_s) + 0.02 * rng.standard_normal(len(turns))
    table = pd.DataFrame({"time_s": time_s, "motor_turns": turns, "displacement_mm": x, "load_n": 20.0})
    (slip,) = Diagnosis.of(Recording.of(table, content("slip"))).content["simulation"]
    assert slip["id"] == "clamp_slip"
    assert slip["parameters"]["mm"] == pytest.approx(0.8, abs=0.03)
    assert slip["parameters"]["at_s"] == pytest.approx(slip_s, abs=0.05)
