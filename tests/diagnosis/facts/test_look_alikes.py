"""What moved dimensions leave of an effect: the part of it that only the effect can do."""

import numpy as np
import pytest

from pipeline.diagnosis.choice.outcome import rms
from pipeline.diagnosis.choice.recalibration import beyond
from pipeline.diagnosis.facts.look_alikes import look_alikes
from pipeline.diagnosis.fit.linear import Linear
from pipeline.diagnosis.numerics.noise import white
from pipeline.diagnosis.study.engine import study


def test_of_an_effect_only_what_no_dimension_does_is_left(problem) -> None:
    dimensions = Linear(problem, problem.nominal(), white(1.0), {})
    radius = dimensions.table[1] * dimensions.high[1]
    ripple = 0.1 * np.std(radius) * np.sin(40.0 * problem.drivers.time_s)
    remainder = beyond(radius + ripple, dimensions)
    assert rms(remainder) == pytest.approx(rms(ripple), rel=0.1) and rms(remainder) < 0.2 * rms(radius)


def test_a_study_says_what_is_left_of_each_named_effect_and_nothing_of_none(one_load) -> None:
    studied = study(one_load[0])
    evidence = look_alikes(studied, "mm")
    assert set(evidence["beyond_dimensions_mm"]) == set(studied.best_ids) and studied.best_ids
    assert all(beyond_mm > 0.0 for beyond_mm in evidence["beyond_dimensions_mm"].values())
    assert set(evidence["moved_alone_sigma"]) == {studied.problem.parameters[i].name for i in studied.problem.movable}
    radius = studied.problem.movable[0]
    known_dimension = studied.problem.parameters[radius]
    alone = known_dimension.nominal + evidence["moved_alone_sigma"][known_dimension.name] * known_dimension.sigma
    assert alone == pytest.approx(float(studied.base.values[radius])) and alone != known_dimension.nominal
