"""Two clocks part: the displacement comes ever later, or now later and now earlier."""

from collections.abc import Callable

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_wander import half_waves, passed, wandering

MOST_S = 2.0  # largest delay that comes or goes


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Parting, or wandering by so many `half_waves`, over the `whole_s` that a fit sees. None where nothing winds."""
    law = {"whole_s": drivers.seen_s}
    return [law, *wandering(drivers, law)] if drivers.levered else []


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """A delay that grows with time, or wanders; one that stays is a lag."""
    share = passed(drivers, nonlinear)

    def late(delay: Array) -> Callable[[Array], Array]:
        return lambda reading: np.asarray(-delay * drivers.slope(reading))

    all_terms = [Term("parting_s", "sensor", late(share), "s", -MOST_S, MOST_S)]
    for count, wave in half_waves(share, nonlinear, 1).items():
        all_terms.append(Term(f"wandering_{count}_s", "sensor", late(wave), "s", -MOST_S, MOST_S))
    return all_terms


MECHANISM = Mechanism(
    id="x_clock",
    driver="displacement rate and time",
    equation="x_m(t) = x(t - d(t))",
    letters={
        "d": "how late the reading is by then",
    },
    source="Mills and others, Network Time Protocol Version 4, RFC 5905, 2010 (offset and skew of clocks)",
    confused_with="sensor_lag, whose delay stays what it is",
    told_apart_by="fast strokes at the beginning and at the end: a lag is the same in both",
    meaning="the clocks of motor and displacement run apart; a stand-in, no physics of the library.",
    sentence="The clocks of motor and displacement run apart, which is worth {size} at these speeds.",
    candidates=candidates,
    terms=terms,
    helper=True,
)
