"""The ends of the range: slack, jam, overtwist, end stop."""

from collections.abc import Callable

import numpy as np
from scipy.interpolate import PchipInterpolator

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.workshop.bench import Bench, Law, Part
from pipeline.rig.authors.workshop.curves import drawn_curve, histogram_draws
from pipeline.rig.authors.workshop.memory import ceiling_play, relay


def lost_first_turns(bench: Bench, rng: np.random.Generator) -> Part:
    """The first turns only take up the loose string."""
    low, span = float(bench.turns.min()), float(np.ptp(bench.turns))

    def act(loose: float, now: Array) -> Array:
        return low + np.maximum(now - low - loose, 0.0)

    return Part("twist", "loose_turns", 0.5 * span, act)


def sagging_string(bench: Bench, rng: np.random.Generator) -> Part:
    """The loose string sags and tightens little by little: a dead zone with a soft end."""
    low, span, soft = float(bench.turns.min()), float(np.ptp(bench.turns)), rng.uniform(0.15, 0.5)

    def act(loose: float, now: Array) -> Array:
        width = soft * loose
        taut = width * np.logaddexp(0.0, (now - low - loose) / width)
        return low + taut - width * np.logaddexp(0.0, -1.0 / soft)

    return Part("twist", "loose_turns", 0.5 * span, act, {"softness": soft})


def rest_on_a_stop(bench: Bench, rng: np.random.Generator) -> Part:
    """The weight rests on a stop until the string has drawn in its loose length."""

    def act(loose: float, now: Array) -> Array:
        return np.maximum(now - loose, now.min())

    return Part("length", "loose_mm", 0.6 * float(np.ptp(bench.contraction_mm)), act)


def _critical_turns(bench: Bench, height: float) -> float:
    return float(bench.turns.min() + height * np.ptp(bench.turns))


def locked_coils(bench: Bench, rng: np.random.Generator) -> Part:
    """Past a critical twist each further turn shortens the string less."""
    begin = _critical_turns(bench, rng.uniform(0.55, 0.8))

    def act(lost: float, now: Array) -> Array:
        return now - lost * np.maximum(now - begin, 0.0)

    return Part("twist", "slope_lost", 0.97, act, {"critical_turns": begin})


def packing_sheet(bench: Bench, rng: np.random.Generator) -> Part:
    """The coils close one by one: past a critical twist the yield of a turn falls along a sheet."""
    begin, bend = _critical_turns(bench, rng.uniform(0.45, 0.7)), rng.uniform(-1.0, 1.0)
    sheet, top = drawn_curve(rng, bend), float(bench.turns.max())
    grid = np.linspace(begin, top, 200)
    lost = np.concatenate([[0.0], np.cumsum(sheet((grid[1:] - begin) / (top - begin))) * (grid[1] - grid[0])])
    table = PchipInterpolator(grid, lost)

    def act(most: float, now: Array) -> Array:
        return now - most * np.asarray(table(np.clip(now, begin, top)))

    return Part("twist", "slope_lost_at_top", 0.97, act, {"critical_turns": begin, "bend": bend})


def coil_by_coil(bench: Bench, rng: np.random.Generator) -> Part:
    """Coils jump in at twists off a histogram, and out again at lower ones; each shortens the string by its bite."""
    low, top = float(bench.turns.min()), float(bench.turns.max())
    begin, count = rng.uniform(0.55, 0.75), int(rng.integers(8, 25))
    ups = histogram_draws(rng, np.array([begin, 0.5 * (begin + 1.0), 0.99]), np.array([1.0, 1.6]), count)
    backs = histogram_draws(rng, np.array([0.04, 0.08, 0.16]), np.array([2.0, 1.0]), count)
    place = (bench.turns - low) / (top - low)
    bites = rng.uniform(0.6, 1.4, count)
    coils = zip(ups, backs, bites, strict=True)
    shape = np.asarray(sum(bite * relay(place, up, up - back) for up, back, bite in coils)) / bites.sum()
    ticks = max(1, round(0.12 / bench.tick_s))  # a coil needs this to jump
    eased = np.convolve(np.pad(shape, (ticks, 0)), np.full(ticks, 1.0 / ticks))[ticks : ticks + len(place)]
    numbers = {"critical_turns": low + begin * (top - low), "coils": count}
    return Part("length", "gain_mm", 12.0, lambda gain, now: now + gain * eased, numbers)


def two_branches(bench: Bench, rng: np.random.Generator) -> Part:
    """Past a critical twist the string runs ahead along one branch and comes back along a later one."""
    span = float(np.ptp(bench.turns))
    begin = float(bench.turns.min()) + rng.uniform(0.55, 0.75) * span
    gap, bend = rng.uniform(0.04, 0.12) * span, rng.uniform(-2.0, 0.0)
    late = ceiling_play(bench.turns, gap)
    shape = drawn_curve(rng, bend)((late - begin) / (bench.turns.max() - begin))
    numbers = {"critical_turns": begin, "late_turns": gap, "bend": bend}
    return Part("length", "gain_mm", 12.0, lambda gain, now: now + gain * shape, numbers)


def _stopped(bench: Bench, size: str, beyond: Callable[[Array], Array], **parameters: float) -> Part:
    def act(depth: float, now: Array) -> Array:
        contact = float(now.max()) - depth
        over = np.maximum(now - contact, 0.0)
        return np.minimum(now, contact) + beyond(over)

    return Part("length", size, 0.6 * float(np.ptp(bench.contraction_mm)), act, dict(parameters))


def iron_stop(bench: Bench, rng: np.random.Generator) -> Part:
    """An iron stop that gives next to nothing."""
    give = rng.uniform(0.0, 0.01)
    return _stopped(bench, "stopped_mm", lambda over: give * over, give=give)


def rubber_foot(bench: Bench, rng: np.random.Generator) -> Part:
    """A rubber foot that can be pressed in by so much at the most, less and less willingly."""
    most = rng.uniform(0.05, 0.4)
    return _stopped(bench, "stopped_mm", lambda over: most * over / (most + over), most_mm=most)


def dented_ball(bench: Bench, rng: np.random.Generator) -> Part:
    """A ball against a plate: the dent grows by the push to the power two thirds."""
    give = rng.uniform(0.05, 0.2)
    return _stopped(bench, "stopped_mm", lambda over: np.minimum(over, give * over ** (2.0 / 3.0)), give=give)


SLACK: tuple[Law, ...] = (lost_first_turns, sagging_string, rest_on_a_stop)
JAM: tuple[Law, ...] = (locked_coils, packing_sheet)
OVERTWIST: tuple[Law, ...] = (coil_by_coil, two_branches)
END_STOP: tuple[Law, ...] = (iron_stop, rubber_foot, dented_ball)
