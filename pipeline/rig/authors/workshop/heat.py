"""Heat: what the thermometer says, or what the motor's and the string's warming were measured to be."""

import numpy as np
from scipy.signal import lfilter

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.interface import OutOfReach
from pipeline.rig.authors.workshop.bench import Bench, Law, Part, added
from pipeline.rig.authors.workshop.curves import drawn_curve, unit
from pipeline.rig.authors.workshop.kernels import after_impulses

LARGEST_MM = 5.0


def _warmed(bench: Bench, rng: np.random.Generator, shape: Array, **parameters: float) -> Part:
    sign = float(rng.choice([-1.0, 1.0]))
    return added("length", "amplitude_mm", LARGEST_MM, sign * unit(shape), sign=sign, **parameters)


def thermometer_line(bench: Bench, rng: np.random.Generator) -> Part:
    """Length in proportion to the thermometer's reading, as slow as a thin string."""
    if not bench.thermometer:
        raise OutOfReach("no thermometer hangs on this rig")
    slow_s = rng.uniform(0.5, 4.0)
    memory = np.exp(-bench.tick_s / slow_s)
    start = bench.temperature_c[0]
    felt = lfilter([1.0 - memory], [1.0, -memory], bench.temperature_c - start)
    return _warmed(bench, rng, felt, slow_s=slow_s)


def thermometer_sheet(bench: Bench, rng: np.random.Generator) -> Part:
    """Length read off a bent sheet over the thermometer's reading."""
    if not bench.thermometer:
        raise OutOfReach("no thermometer hangs on this rig")
    bend = rng.uniform(-1.5, 1.5)
    sheet = drawn_curve(rng, bend)
    over = (bench.temperature_c - bench.temperature_c.min()) / np.ptp(bench.temperature_c)
    return _warmed(bench, rng, sheet(over), bend=bend)


def motor_warming(bench: Bench, rng: np.random.Generator) -> Part:
    """The mount warms while the motor runs; its cooling after a minute's run was recorded and is convolved."""
    cooling_s = rng.uniform(50.0, 220.0)
    running = np.where(np.abs(bench.speed) > 1e-3, 1.0, rng.uniform(0.0, 0.15))
    recorded = np.exp(-bench.time_s / cooling_s) * bench.tick_s / cooling_s
    return _warmed(bench, rng, after_impulses(running, recorded), cooling_s=cooling_s)


def rubbing_warmth(bench: Bench, rng: np.random.Generator) -> Part:
    """Torque times speed warms the string, and the string its clamps: a quick and a slow cooling."""
    quick_s, slow_s, share = rng.uniform(15.0, 40.0), rng.uniform(120.0, 350.0), rng.uniform(0.3, 0.7)
    power = bench.torque * np.abs(bench.speed)
    quick = np.exp(-bench.time_s / quick_s) / quick_s
    slow = np.exp(-bench.time_s / slow_s) / slow_s
    warmth = after_impulses(power, (share * quick + (1.0 - share) * slow) * bench.tick_s)
    return _warmed(bench, rng, warmth, quick_s=quick_s, slow_s=slow_s, quick_share=share)


THERMAL: tuple[Law, ...] = (thermometer_line, thermometer_sheet, motor_warming, rubbing_warmth)
