"""What else spoils a bench: passers-by, the air conditioner, the mains, a leaning operator, a draw-wire's drum."""

import numpy as np
from scipy.interpolate import CubicSpline

from pipeline.ground.kinematics import RAD_PER_TURN, Array
from pipeline.rig.authors.workshop.bench import Bench, Law, Part, added
from pipeline.rig.authors.workshop.curves import eased
from pipeline.rig.authors.workshop.events import anywhen

LARGEST_MM = 4.0


def bursts_of_sway(bench: Bench, rng: np.random.Generator) -> Part:
    """People walk by, and the bench sways a while each time."""
    instants = anywhen(bench, rng, int(rng.integers(4, 13)))
    hertz, lasting_s = rng.uniform(0.8, 2.5), rng.uniform(2.0, 6.0)
    shape = np.zeros_like(bench.time_s)
    for at, strength in zip(instants, rng.uniform(0.4, 1.0, len(instants)), strict=True):
        since = (bench.time_s - at) / lasting_s
        envelope = np.where((since > 0.0) & (since < 1.0), np.sin(np.pi * np.clip(since, 0.0, 1.0)) ** 2, 0.0)
        shape += strength * envelope * np.sin(RAD_PER_TURN * hertz * (bench.time_s - at))
    return added("reading", "sway_mm", LARGEST_MM, shape, frequency_hz=hertz, lasting_s=lasting_s)


def compressor_cycle(bench: Bench, rng: np.random.Generator) -> Part:
    """The air conditioner switches on and off, and the moist string breathes with it."""
    period_s, on = rng.uniform(35.0, 90.0), rng.uniform(0.3, 0.6)
    phase = (bench.time_s / period_s + rng.random()) % 1.0
    saw = np.where(phase < on, phase / on, (1.0 - phase) / (1.0 - on)) - 0.5
    return added("length", "breath_mm", LARGEST_MM, saw - saw[0], period_s=period_s, on_share=on)


def beating_hum(bench: Bench, rng: np.random.Generator) -> Part:
    """The mains, seen through the sampling: a slow hum whose frequency wanders a little."""
    hertz = rng.uniform(0.4, 0.15 / bench.tick_s)
    knots = np.arange(0.0, bench.time_s[-1] + 40.0, 20.0)
    slip = CubicSpline(knots, np.cumsum(rng.normal(0.0, 0.3, len(knots))))(bench.time_s)
    shape = np.sin(RAD_PER_TURN * hertz * bench.time_s + slip)
    return added("reading", "hum_mm", LARGEST_MM, shape, frequency_hz=hertz)


def pressed_table(bench: Bench, rng: np.random.Generator) -> Part:
    """Somebody leans on the table now and then, and the frame gives until he stands up again."""
    shape = np.zeros_like(bench.time_s)
    instants = anywhen(bench, rng, int(rng.integers(2, 7)))
    for at, strength in zip(instants, rng.uniform(0.4, 1.0, len(instants)), strict=True):
        lasting = rng.uniform(4.0, 25.0)
        shape += strength * (eased(bench.time_s, at, 0.7) - eased(bench.time_s, at + lasting, 0.7))
    return added("length", "give_mm", LARGEST_MM, -shape, instants_s=instants.tolist())


def layered_drum(bench: Bench, rng: np.random.Generator) -> Part:
    """The draw-wire's drum is out of round: a ripple over the reading, not over the motor's turns."""
    around = float(np.ptp(bench.contraction_mm)) * rng.uniform(0.15, 0.4)
    second, phase = rng.uniform(0.0, 0.4), rng.uniform(0.0, RAD_PER_TURN)

    def act(amount: float, now: Array) -> Array:
        angle = RAD_PER_TURN * now / around + phase
        return now + amount * (np.sin(angle) + second * np.sin(2.0 * angle))

    return Part("reading", "ripple_mm", LARGEST_MM, act, {"around_mm": around, "second": second})


def linearity_sheet(bench: Bench, rng: np.random.Generator) -> Part:
    """The gauge's calibration sheet, left in the drawer: an error drawn at a dozen places of its range."""
    low, high = float(bench.contraction_mm.min()), float(bench.contraction_mm.max())
    places = np.linspace(low - 0.2 * (high - low), high + 0.2 * (high - low), 13)
    sheet = CubicSpline(places, rng.normal(0.0, 1.0, 13))

    def act(amount: float, now: Array) -> Array:
        return now + amount * np.asarray(sheet(np.clip(now, places[0], places[-1])))

    return Part("reading", "error_mm", LARGEST_MM, act)


PASSERS_BY: tuple[Law, ...] = (bursts_of_sway,)
AIR_CONDITIONER: tuple[Law, ...] = (compressor_cycle,)
MAINS_HUM: tuple[Law, ...] = (beating_hum,)
LEANING_OPERATOR: tuple[Law, ...] = (pressed_table,)
WIRE_DRUM: tuple[Law, ...] = (layered_drum,)
UNREAD_SHEET: tuple[Law, ...] = (linearity_sheet,)
