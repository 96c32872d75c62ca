"""Whether the channels of a string can be what their names say: their direction, their units, and the place of 0."""

from pathlib import Path

import numpy as np

from ...ground.errors import BadInput
from ...ground.kinematics import Geometry
from ...ground.numbers.too_short import MOST_STRETCH
from ...ground.stored.rows import Rows
from ...ground.units import conversion
from ..description import Channel, Run
from .exchanged_columns import LEAST_TURNS, exchange, exchanged
from .plausible_load import DOUBT_STRETCH, check_load, load_mistake, small_load
from .plausible_temperature import temperature_mistake
from .recorded_curve import AS_LIKELY, DOUBT_RATIO, Curve, Guess, bound
from .wrong_sign import FALLS, turned_sign

# A simulated span this many times larger or smaller than the recorded one is a unit, not physics.
SPAN_RATIO = 4.0
ELSEWHERE = 0.35  # of its span: a curve so far off the model's is hardly one over the twist (0.5 and more by chance)
ANGLES, LENGTHS = ("turns", "rad", "deg"), ("mm", "cm", "m", "um", "in")
IN_WORDS = {"in": "inches"}


def _others(channel: Channel, column: str, units: tuple[str, ...]) -> list[tuple[float, str]]:
    """Other units of a channel: by which factor its values would change, and the mend."""
    if channel.unit not in (None, *units):
        return []  # counts and volts: their scale may be anything
    now = conversion(column, channel.unit)[0]
    others = [unit for unit in units if unit != (channel.unit or units[0])]
    return [
        (
            conversion(column, unit)[0] / now,
            f"it looks like {IN_WORDS.get(unit, unit)}: set channels.{column}.unit to {unit}",
        )
        for unit in others
    ]


def _guesses(run: Run) -> list[list[Guess]]:
    """Possible mistakes in one channel, then in both."""
    angle, length = (run.channels.get(name, Channel.model_validate({})) for name in ("motor_turns", "displacement_mm"))
    angles = [Guess(by, 1.0, "motor_turns", mend) for by, mend in _others(angle, "motor_turns", ANGLES)]
    lengths = [Guess(1.0, by, "displacement_mm", mend) for by, mend in _others(length, "displacement_mm", LENGTHS)]
    both = [Guess(a.turns, b.length, a.field, f"{a.mend}, and {b.mend}") for a in angles for b in lengths]
    return [[*angles, *lengths], both]


def _freely(curve: Curve) -> list[tuple[float, str]]:
    """The factor of one channel with which the recording would fit: the misfit, and the factor in words."""
    factors = np.geomspace(1e-3, 1e3, 601)
    off = np.array([abs(np.log(curve.ratio(turns=factor))) for factor in factors])
    fitting = []
    if np.isfinite(off).any() and np.nanmin(off) < 0.1:
        by = float(factors[np.nanargmin(off)])
        fitting.append((curve.misfit(turns=by), f"with motor_turns, or radius_mm, {by:.2g} times as large"))
    by = float(np.divide(1.0, curve.ratio() or np.inf))
    if np.isfinite(by) and by > 0:
        fitting.append((curve.misfit(length=by), f"with displacement_mm {by:.2g} times as large"))
    return fitting


def _span(run: Run, curve: Curve, path: Path) -> BadInput:
    """The message that the string should contract by another length, with the mends that would fit."""
    freely = _freely(curve)
    best = min((misfit for misfit, _ in freely), default=np.inf)
    single, both = _guesses(run)
    likely = curve.likely(single, best) or curve.likely(both, best)
    field = likely[0].field if likely else "motor_turns"
    mend = ", or ".join(guess.mend for guess in likely)
    if len(likely) > 1:
        mend = f"find out which: {mend}"
    shifted = 1.0 / DOUBT_RATIO <= curve.ratio(offset_turns=-curve.low) <= DOUBT_RATIO
    if curve.far and shifted and curve.misfit(offset_turns=-curve.low) <= bound(best):
        field, mend = "motor_turns", _home(run, curve)
    elif not likely:
        mend = "check the units of motor_turns and displacement_mm, counts_per_turn, gears and the string's dimensions"
        fitting = [words for misfit, words in freely if misfit <= bound(best)]
        mend += f"; it would fit {' or '.join(fitting)}" if fitting else ""
    ratio = curve.ratio()
    expected = f"{curve.span_mm / ratio:.3g} mm" if np.isfinite(ratio) and ratio else "more than the string is long"
    expected = "0 mm" if np.isinf(ratio) else expected
    ends = f"{curve.low:.3g} to {curve.high:.3g} turns"
    problem = f"{ends} should contract the string by {expected}, recorded are {curve.span_mm:.3g} mm"
    return BadInput(path, field, problem, mend)


def check_string(run: Run, samples: Rows, base: Geometry, path: Path) -> None:
    """Raise BadInput where a channel cannot be what its name says: frozen, reversed, or in another unit."""
    check_load(samples, path)
    curve = Curve(samples, base)
    if mistake := load_mistake(run, samples, base, path, MOST_STRETCH):
        raise mistake
    if pair := exchanged(run, samples, base):
        raise BadInput(path, "displacement_mm", "does not follow the twist as this string would", exchange(pair))
    if curve.high - curve.low < LEAST_TURNS:
        return  # no stroke in it: the segmentation says so
    if curve.high <= 0:
        mend = "winding is positive: set channels.motor_turns.scale to -1"
        raise BadInput(path, "motor_turns", "is negative throughout", mend)
    if curve.span_mm == 0:
        raise BadInput(path, "displacement_mm", "never changes while the motor turns", "check the sensor and its cable")
    if samples.correlation("motor_turns", "displacement_mm") < -0.5:
        raise BadInput(path, "displacement_mm", FALLS, turned_sign(run))
    if not 1.0 / SPAN_RATIO <= curve.ratio() <= SPAN_RATIO:
        raise _span(run, curve, path)


def doubts(run: Run, samples: Rows, base: Geometry, path: Path) -> list[BadInput]:
    """Oddities of a string's checked samples that are likely mistakes: a far 0 of the twist, an odd span or curve.

    Two more are a load that a string would hardly bear, or that is next to none, and a temperature that no room has.
    """
    curve = Curve(samples, base)
    questions = []
    if curve.far:
        begins = float(np.median(samples.read("motor_turns", 0, 5)))
        problem = f"begins at {begins:.3g} turns and its lowest is {curve.low:.3g}, but 0 must be the untwisted string"
        questions.append(BadInput(path, "motor_turns", problem, _home(run, curve)))
    elif not 1.0 / DOUBT_RATIO <= curve.ratio() <= DOUBT_RATIO:
        questions.append(_span(run, curve, path))
    elif curve.high - curve.low >= LEAST_TURNS and (misfit := curve.misfit()) > ELSEWHERE:
        problem = f"hardly follows the twist: it differs from the curve of such a string by {misfit:.0%} of its span"
        mend = "check which columns motor_turns and displacement_mm are read from"
        questions.append(BadInput(path, "displacement_mm", problem, mend))
    if mistake := load_mistake(run, samples, base, path, DOUBT_STRETCH):
        questions.append(mistake)
    if small := small_load(run, samples, base, path):
        questions.append(small)
    if odd := temperature_mistake(samples, path):
        questions.append(odd)
    return questions


def _home(run: Run, curve: Curve) -> str:
    """Where the twist's 0 is, by the recorded curve."""
    channel = run.channels.get("motor_turns", Channel.model_validate({}))
    offset = channel.offset - curve.low / conversion("motor_turns", channel.unit, channel.counts_per_turn)[0]
    misfit_as_is, shifted = curve.misfit(), curve.misfit(offset_turns=-curve.low)
    if AS_LIKELY * shifted < misfit_as_is:
        return f"its curve fits 0 at that lowest twist: set channels.motor_turns.offset to {offset:.6g}"
    if AS_LIKELY * misfit_as_is < shifted:
        return "its curve fits 0 where it is; check that it is right"
    return (
        f"set channels.motor_turns.offset ({offset:.6g} if the string was untwisted there), or check that it is right"
    )
