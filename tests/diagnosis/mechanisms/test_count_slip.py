"""Twist that is lost: what was lost before the string was wound is a zero of the motor, and no slip."""

import numpy as np

from pipeline.diagnosis.mechanisms.count_slip import LEAST_WOUND
from pipeline.diagnosis.mechanisms.library import mechanisms


def test_no_twist_is_lost_before_the_string_is_wound(problem) -> None:
    """A slip of 0.64 turns was named 0.2 s before the motor first moved."""
    drivers, count_slip = problem.drivers, mechanisms()["count_slip"]
    turned = np.maximum.accumulate(drivers.motion) - np.minimum.accumulate(drivers.motion)
    wound_s = float(drivers.elapsed_s[np.argmax(turned >= LEAST_WOUND * drivers.span)])
    early, late = drivers.elapsed_s < wound_s / 2, drivers.elapsed_s >= wound_s + 10.0
    noise = 0.01 * np.random.default_rng(0).standard_normal(len(early))
    for jumped in (early, late):
        step = np.where(jumped, 0.0, 5.0) if jumped is early else np.where(jumped, 5.0, 0.0)
        suggested = count_slip.suggest(drivers, step + noise, np.zeros(len(step)))
        near_s = np.abs(np.array([each["at_s"] for each in suggested]) - drivers.elapsed_s[np.argmax(step > 0)])
        assert (near_s.min() < 0.5) == (jumped is late)
    at_s = [each["at_s"] for each in count_slip.candidates(drivers)]
    assert -1.0 in at_s and min(each for each in at_s if each >= 0) >= wound_s
    assert not count_slip.tells(drivers, {"at_s": wound_s / 2, "within_s": 0.0})
    assert count_slip.tells(drivers, {"at_s": -1.0, "within_s": 0.0})
