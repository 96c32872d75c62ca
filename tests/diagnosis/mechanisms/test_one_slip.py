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
def test_two_slips_within_a_second_are_one(problem, id_) -> None:
    at_once, at_90 = mechanisms()[id_].at_once, {"at_s": 90.0, "within_s": 0.0}
    for at_s, is_one in ((89.0, False), (89.1, True), (90.0, True), (90.9, True), (91.0, False), (-1.0, False)):
        assert at_once(problem.drivers, at_90, {"at_s": at_s, "within_s": 0.4}) is is_one
    options = [{"at_s": at_s, "within_s": 0.0} for at_s in (20.0, 20.9, 30.0, 31.5, 40.0)]
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
