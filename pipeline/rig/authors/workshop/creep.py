"""Creep: the answer of the length to a step of tension, measured once and convolved with the tension's history."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.workshop.bench import Bench, Law, Part, added
from pipeline.rig.authors.workshop.curves import drawn_curve
from pipeline.rig.authors.workshop.kernels import Response, after_steps

LONGEST_MM = 8.0


def _crept(bench: Bench, rng: np.random.Generator, response: Response, **parameters: float) -> Part:
    """Creep of a string that hung from its weight a while before the recording; it recovers by the same response."""
    hung_s, power = rng.uniform(5.0, 60.0), rng.uniform(1.0, 2.0)
    crept = after_steps(bench.tension**power, response, bench.time_s, hung_s)
    shape = -(crept - crept[0])
    return added("length", "compliance_mm", LONGEST_MM, shape, hung_s=hung_s, tension_power=power, **parameters)


def creep_sheet(bench: Bench, rng: np.random.Generator) -> Part:
    """The step's answer through points drawn over the logarithm of time, from a tenth of a second to a long day."""
    first_s, last_s = rng.uniform(0.3, 3.0), rng.uniform(600.0, 4000.0)
    sheet = drawn_curve(rng, rng.uniform(-1.0, 1.0), 7)
    decades = np.log10(last_s / first_s)

    def response(time_s: Array) -> Array:
        return sheet(np.log10(1.0 + time_s / first_s) / decades)

    return _crept(bench, rng, response, first_s=first_s, last_s=last_s)


def even_decades(bench: Bench, rng: np.random.Generator) -> Part:
    """So much for each tenfold of time."""
    first_s = rng.uniform(0.5, 8.0)
    return _crept(bench, rng, lambda time_s: np.log10(1.0 + time_s / first_s), first_s=first_s)


def straight_on_log_paper(bench: Bench, rng: np.random.Generator) -> Part:
    """A straight line where both time and elongation stand on logarithmic paper."""
    slope = rng.uniform(0.12, 0.4)
    return _crept(bench, rng, lambda time_s: (time_s / 100.0) ** slope, slope=slope)


def one_long_dwell(bench: Bench, rng: np.random.Generator) -> Part:
    """A dwell that ends: a stretched approach to a last value."""
    time_constant_s, stretch = rng.uniform(12.0, 90.0), rng.uniform(0.55, 1.0)
    return _crept(
        bench,
        rng,
        lambda time_s: 1.0 - np.exp(-((time_s / time_constant_s) ** stretch)),
        tau_s=time_constant_s,
        stretch=stretch,
    )


CREEP: tuple[Law, ...] = (creep_sheet, even_decades, straight_on_log_paper, one_long_dwell)
