"""A drive's transmission errs by place, whichever way the motion comes: pulleys off centre, cables around a wrist."""

import numpy as np

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .plain_drag import leaves
from .shared_laws import share_of_travel, travelled

KNOTS = 12  # of the curve along the travel
STOPS = (0.01, 0.05, 0.2)  # of the range: half-widths of the plain friction that is taken off first
LEAST_SHARE = 0.57  # of the plain effects' residual: a smaller part may be stretch by a load that follows the place


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """None before a recording suggests one."""
    return []


def geared(drivers: Drivers) -> bool:
    """Whether a motor drives through a gear and the reading is of what it moves."""
    return not drivers.levered and drivers.velocity is None and drivers.turn is not None and drivers.free_zero


def beside(drivers: Drivers) -> list[Nonlinear]:
    """The whole travel of a geared drive: named effects may leave an error by place anywhere in it."""
    return [travelled(drivers)] if geared(drivers) else []


def suggest(drivers: Drivers, residual: Array, predicted: Array) -> list[Nonlinear]:
    """A curve over the travel, where a motor drives through a gear and much of the residual follows the place alone.

    It has the shape (samples,), in the reading's unit.
    """
    if not geared(drivers):
        return []
    travel, plain_columns = travelled(drivers), plain(drivers)
    without, beside = leaves(residual, plain_columns), leaves(residual, [*plain_columns, *curve(drivers, travel)])
    return [travel] if without - beside >= LEAST_SHARE * without else []


def plain(drivers: Drivers) -> list[Array]:
    """Plain columns of friction that grows with the load and along the travel, of stretch, drift and loss by the rate.

    Each of shape (samples,), in the unit of what drives it.
    """
    place, load = (drivers.motion - drivers.motion.min()) / drivers.span, drivers.load
    sides = [drivers.directed(share * drivers.span) for share in STOPS]
    loops = [side * size for side in sides for size in (np.ones_like(place), np.abs(load), place, np.square(place))]
    slow = [np.ones_like(place), place, drivers.elapsed_s, np.square(drivers.elapsed_s), drivers.rate]
    return [*loops, *slow, *([load, np.square(load), load * place] if drivers.loaded else [])]


def curve(drivers: Drivers, nonlinear: Nonlinear) -> list[Array]:
    """Piecewise linear bumps inside the travel, each less a straight line, which gear and zero can take up.

    Each of shape (samples,), without a unit.
    """
    knots = np.linspace(0.0, 1.0, KNOTS)
    bent = np.eye(KNOTS) - np.array([np.polyval(np.polyfit(knots, bump, 1), knots) for bump in np.eye(KNOTS)])
    share = share_of_travel(drivers, nonlinear)
    return [np.interp(share, knots, heights) for heights in bent[1:-1]]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """The curve, of any shape."""
    bumps = enumerate(curve(drivers, nonlinear), start=1)
    return [Term(f"knot_{knot}_mm", "sensor", bump, "mm", -np.inf) for knot, bump in bumps]


MECHANISM = Mechanism(
    id="x_transmission",
    driver="place",
    equation="x_m = x + e(theta), e: any piecewise linear curve",
    letters={
        "e": "the error at each place",
    },
    source="Smith, Gear Noise and Vibration, 2003 (transmission error)",
    confused_with="eccentricity, end_stop, slack (which act at one end, or once a turn)",
    told_apart_by="one slow stroke to and fro over all of the travel: the error is the same at one place both ways",
    meaning="an error that follows the place, the same both ways; a stand-in, no physics of the library.",
    sentence="The transmission errs by the place, the same both ways: {span} in all ({size}).",
    candidates=candidates,
    helper=True,
    units={"from_turns": "turns", "span_turns": "turns"},
    terms=terms,
    suggest=suggest,
    beside=beside,
)
