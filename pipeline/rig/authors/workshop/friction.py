"""Friction as loops on the plotter: relays, reversal curves, rails; each grows with the load."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.workshop.bench import Bench, Law, Part, added
from pipeline.rig.authors.workshop.curves import drawn_curve, histogram_draws
from pipeline.rig.authors.workshop.memory import relay, reversal_curves

RELAYS = 200
WIDEST_TURNS, WIDEST_MM = 3.0, 4.0


def _held_back(bench: Bench, rng: np.random.Generator, loop: Array, **parameters: float) -> Part:
    """The string's twist stays behind the motor's by a loop times the load to a power."""
    power = rng.uniform(0.4, 1.2)
    shape = -loop * bench.load_ratio**power
    return added("twist", "held_back_turns", WIDEST_TURNS, shape, load_power=power, **parameters)


def preisach_board(bench: Bench, rng: np.random.Generator) -> Part:
    """A board of relays whose widths stand in a histogram and whose middles spread over the twist."""
    low, span = bench.turns.min(), np.ptp(bench.turns)
    edges = np.array([0.01, 0.05, 0.12, 0.25]) * rng.uniform(0.4, 0.9)
    halves = histogram_draws(rng, edges, rng.uniform(0.5, 2.0, 3), RELAYS) * span
    # the middles reach past both ends, so that no branch runs out of relays
    middles = low + span * np.linspace(-0.45, 1.45, RELAYS)
    slope = 1.0 / (middles[-1] - middles[0])
    closed = sum(relay(bench.turns, middle + half, middle - half) for middle, half in zip(middles, halves, strict=True))
    behind = (bench.turns - middles[0]) * slope - np.asarray(closed) / RELAYS
    # a board of relays steps; a short file over it takes the corners off
    loop = behind * (middles[-1] - middles[0]) / halves.mean()
    file = max(1, round(0.3 / bench.tick_s))
    smooth = np.convolve(np.pad(loop, file, mode="edge"), np.full(file, 1.0 / file), mode="same")[file:-file]
    return _held_back(bench, rng, smooth, mean_half_width_turns=float(halves.mean()))


def knee_card(bench: Bench, rng: np.random.Generator) -> Part:
    """After each reversal the loop crosses along one card, over a way that depends on nothing else."""
    span, bend = rng.uniform(0.06, 0.3) * np.ptp(bench.turns), rng.uniform(1.0, 5.0)
    loop = reversal_curves(bench.turns, np.full_like(bench.turns, span), drawn_curve(rng, bend))
    return _held_back(bench, rng, loop, span_turns=float(span), bend=bend)


def family_of_reversals(bench: Bench, rng: np.random.Generator) -> Part:
    """First-order reversal curves: the higher the reversal and the greater the lever, the longer and wider the loop."""
    span, grow, bend = rng.uniform(0.05, 0.15), rng.uniform(0.5, 2.0), rng.uniform(0.5, 4.0)
    lever = np.sin(bench.helix_rad) / np.sin(bench.helix_rad).max()
    spans = span * np.ptp(bench.turns) * (1.0 + grow * bench.height)
    loop = reversal_curves(bench.turns, spans, drawn_curve(rng, bend)) * lever**0.5
    return _held_back(bench, rng, loop, span=span, grows=grow, bend=bend)


def eyelet_sheet(bench: Bench, rng: np.random.Generator) -> Part:
    """Wrapped around its neighbour or its eyelet, the strand loses pull exponentially with the angle it leans."""
    rub, span = rng.uniform(0.2, 1.0), rng.uniform(0.04, 0.15) * np.ptp(bench.contraction_mm)
    wrap = np.expm1(rub * 2.0 * bench.helix_rad)
    loop = reversal_curves(bench.contraction_mm, np.full_like(wrap, span), drawn_curve(rng, 3.0))
    shape = -loop * bench.load_ratio * wrap / wrap.max()
    return added("length", "half_loop_mm", WIDEST_MM, shape, rub=rub, span_mm=float(span))


def loaded_rail(bench: Bench, rng: np.random.Generator) -> Part:
    """The carriage's rail: a loop with a breakaway, as high at every twist; load raises it, quick motion eases it."""
    span, power, ease = rng.uniform(0.2, 1.0), rng.uniform(0.5, 1.1), rng.uniform(0.0, 0.12)
    loop = reversal_curves(bench.contraction_mm, np.full_like(bench.turns, span), drawn_curve(rng, 3.0))
    quick = np.abs(bench.speed) / np.abs(bench.speed).max()
    shape = -loop * bench.load_ratio**power * (1.0 - ease * quick)
    return added("length", "half_loop_mm", WIDEST_MM, shape, breakaway_mm=span, load_power=power, eased=ease)


FRICTION: tuple[Law, ...] = (preisach_board, knee_card, family_of_reversals, eyelet_sheet, loaded_rail)
