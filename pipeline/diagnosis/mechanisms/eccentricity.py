"""A ripple once per turn: the motor's axis, the sensor wheel's, or a screw's is off centre, or a motor cogs."""

import numpy as np
from scipy.ndimage import median_filter

from ...ground.kinematics import Array
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import pulled_in

WAVES = {"sine": np.sin, "cosine": np.cos}
HARMONICS = (2, 3)  # of the motor's turn; those of a wheel that turns a few times would copy any curve
LEAST_WHEEL_MM = 8.0  # circumference: no sensor has a smaller wheel
FEWEST, MOST = 4.0, 250.0  # periods in the range of a motion without turns: fewer are any curve, more are not sought
SAMPLES = 3.0  # least samples in a period at the fastest motion: with fewer, another period is seen
APART = 0.25  # of a wave number: the spectrum over the place has four bins a period in the range
SMOOTH = 6  # degree of the curve along the range that is no ripple
AROUND = 61  # bins that make the background of a line
LINE = 25.0  # times the background: by chance once in some 10^8 bins
NEAR = np.linspace(-0.4, 0.4, 5)  # bins beside a line at which its pitch is tried
MOVES = 0.05  # of the highest rate: a slower motion stays at one place


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """On the motor's turn (0), where the motion makes one; or on a sensor wheel by its circumference in mm."""
    reach = float(np.ptp(drivers.contraction))
    seen = drivers.levered and 0.8 * reach > LEAST_WHEEL_MM
    wheels = np.geomspace(LEAST_WHEEL_MM, 0.8 * reach, 10) if seen else np.zeros(0)
    turns = drivers.turn is not None and drivers.span > drivers.turn
    return [
        *([{"wheel_mm": 0.0}] if turns else []), *({"wheel_mm": float(f"{mm:.6g}")} for mm in wheels)
    ]  # fmt: skip


def suggest(drivers: Drivers, residual: Array, predicted: Array) -> list[Nonlinear]:
    """Pitches at the strongest line of a residual's spectrum over the place, where nothing is known to turn.

    It has the shape (samples,), in the reading's unit.
    """
    if drivers.turn is not None or drivers.levered:
        return []
    count = len(residual)
    place, rate = drivers.motion[:count] / drivers.span, np.abs(drivers.rate[:count])
    fastest = float(np.percentile(rate, 99))
    finest = min(MOST, drivers.span / (SAMPLES * fastest * drivers.step_s))
    if finest < 2.0 * FEWEST:
        return []
    moves = rate > MOVES * fastest
    ways = np.sign(drivers.rate[:count][moves])
    numbers, height = lines(place[moves], ways, pulled_in(residual, 6.0)[moves], finest)
    peak = int(np.argmax(height))
    if height[peak] < LINE:
        return []
    return [{"pitch_turns": float(f"{drivers.span / (numbers[peak] + APART * step):.7g}")} for step in NEAR]


def lines(place: Array, ways: Array, signal: Array, finest: float) -> tuple[Array, Array]:
    """Wave numbers (periods in the range) up to the finest, and a signal's power at each, over its background.

    What changes slowly along the range is taken off, of each way by itself. All given have the shape (samples,): the
    place as a share of the range, the ways as 1 or -1. Both answers have the shape (bins,).
    """
    numbers = np.arange(FEWEST, finest, APART)
    smooth = np.polynomial.chebyshev.chebvander(2.0 * place - 1.0, SMOOTH)
    smooth = np.hstack([smooth, ways[:, None] * smooth])
    quick = signal - smooth @ np.linalg.lstsq(smooth, signal, rcond=None)[0]
    step = np.exp(-2j * np.pi * APART * place)
    wave, power = quick * np.exp(-2j * np.pi * FEWEST * place), np.empty(len(numbers))
    for number in range(len(numbers)):
        power[number] = np.square(np.abs(wave.sum()))
        wave = wave * step
    return numbers, power / (median_filter(power, AROUND, mode="nearest") / np.log(2.0) + 1e-300)


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Sine and cosine of the turn and its harmonics: on the reading, and on the twist, unless a gear is constant."""
    if "pitch_turns" in nonlinear:
        turn = 2.0 * np.pi * drivers.motion / nonlinear["pitch_turns"]
        return [
            Term(f"{name}{'' if harmonic == 1 else f'_{harmonic}'}_mm", "sensor", wave(harmonic * turn), "mm", -np.inf)
            for harmonic in (1, 2)
            for name, wave in WAVES.items()
        ]
    angle = (
        drivers.contraction / nonlinear["wheel_mm"] if nonlinear["wheel_mm"] else drivers.motion / (drivers.turn or 1.0)
    )
    within = np.gradient(angle)  # turns in one sample, over which its reading is a mean
    waves = {name: wave(2.0 * np.pi * angle) * np.sinc(within) for name, wave in WAVES.items()}
    all_terms = [Term(f"{name}_mm", "sensor", wave, "mm", -np.inf) for name, wave in waves.items()]
    if not nonlinear["wheel_mm"] and drivers.levered:
        all_terms += [Term(f"{name}_turns", "twist", wave, "turns", -np.inf) for name, wave in waves.items()]
    for harmonic in HARMONICS if drivers.levered and not nonlinear["wheel_mm"] else ():
        for name, wave in WAVES.items():
            signal = wave(2.0 * np.pi * harmonic * angle) * np.sinc(harmonic * within)
            all_terms.append(Term(f"{name}_{harmonic}_mm", "sensor", signal, "mm", -np.inf))
    return all_terms


MECHANISM = Mechanism(
    id="eccentricity",
    driver="angle within the turn",
    columns=("sine of the turn", "cosine of the turn"),
    equation="x_m = x + sum A_n sin(n theta + p_n), or theta_s = theta + A_n sin(n theta + p_n)",
    letters={
        "A_n": "the height of each ripple: the root of sine squared and cosine squared",
        "n": "how often it comes in a turn | 1, or the number in the name",
        "p_n": "where in the turn each ripple begins: by sine against cosine",
        "theta": "the angle of what turns: the motor's, or 2 pi for each pitch_turns or wheel_mm of the way",
    },
    strengths=("A_n", "p_n"),
    meanings={
        "pitch_turns": "how far the {motion} goes from one ripple to the next",
        "wheel_mm": "the circumference of the sensor's wheel; 0: it follows the motor's own turn",
    },
    source="Slocum, Precision Machine Design, 1992 (error motion once a turn)",
    confused_with="stick_slip, load_swing",
    told_apart_by="one slow stroke: the ripple follows the turn, not the time",
    meaning="a ripple once a turn.",
    sentence="The {reading} ripples once per turn, {size}.",
    details=(
        "once in every {wheel_mm} that the sensor reads, as a wheel of that circumference turns",
        "once in every {pitch_turns}",
    ),
    candidates=candidates,
    units={"wheel_mm": "mm", "pitch_turns": "turns"},
    terms=terms,
    suggest=suggest,
)
