"""A second load in few strokes: too little for what follows the load, but recorded."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.diagnosis.drawing import overview
from pipeline.diagnosis.facts.evidence import other_load
from pipeline.diagnosis.recording.drivers import Drivers, drivers_of

SHARE = 0.04  # of the samples before it: a stroke that so few samples make is no load that varies


@pytest.fixture(scope="module")
def under(one_load):
    """The drivers of a recording under 20 N whose last stroke is short, under a load of its own in N."""
    problem, run = one_load
    record = problem.record
    last, (begin, *_) = int(record.stroke.max()), np.flatnonzero(record.stroke == record.stroke.max())

    def drivers(short_n: float, noise: float) -> Drivers:
        columns = {name: getattr(record, name) for name in record.__dataclass_fields__}
        until = begin + int(SHARE * begin)
        cut = {name: None if values is None else values[:until] for name, values in columns.items()}
        load = np.where(cut["stroke"] == last, short_n, 20.0)
        load *= 1.0 + noise * np.random.default_rng(3).standard_normal(until)
        return drivers_of(problem.system, replace(record, **cut | {"load": load}), run)

    return drivers


def test_the_few_strokes_under_another_load_are_told_with_it(under) -> None:
    """A page said `one load ... no second load` of a recording whose last stroke had twice the load."""
    drivers = under(40.0, 0.012)
    assert not drivers.loaded
    facts = other_load(drivers)["other_load"]
    assert facts["strokes"] == [int(drivers.stroke.max())]
    assert facts["usual"] == pytest.approx(20.0, rel=0.01) and facts["load"] == pytest.approx([40.0, 40.0], rel=0.01)
    assert overview.has_load(drivers), "the figure had no panel of the load"


def test_noise_of_the_load_and_a_load_that_varies_are_no_few_strokes(under) -> None:
    still = under(20.0, 0.012)
    assert other_load(still) == {} and not overview.has_load(still)
    varied = replace(still, loaded=True)
    assert other_load(varied) == {} and overview.has_load(varied)
