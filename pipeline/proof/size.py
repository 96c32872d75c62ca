"""The size of an effect: the part that calibration cannot absorb, in noise floors, and the strength with that size."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..ground.kinematics import Array
from ..rig.concealed import Parameters
from .bench import Bench
from .calibration import Calibrated, calibrate
from .draws import Strength
from .perform import Performed, perform
from .protocol import Protocol
from .sealed import SizeJson

CLOSE = 0.01  # relative: how near to the wanted size is near enough
CLOSE_ENOUGH = 0.05  # for effects that change by leaps when they grow, as stick-slip does
MOST_OF_STROKE = 0.25  # an effect of more than this share of the stroke is none that a rig would be used with
PASSES = 30


class OutOfReach(ValueError):
    """Raised if no strength that a rig can have leaves so much."""


@dataclass(frozen=True)
class Size:
    """How large an effect is."""

    kappa: float  # rms of what calibration leaves, in noise floors
    raw_mm: float  # rms of what it does, from the recording's first sample on
    varies_mm: float  # rms of what it does, without its mean
    hidden_share: float  # of the energy of what varies, taken up by calibration

    def told(self) -> SizeJson:
        """All of it, for the answer."""
        return {
            "kappa": float(f"{self.kappa:.5g}"),
            "raw_mm": float(f"{self.raw_mm:.5g}"),
            "varies_mm": float(f"{self.varies_mm:.5g}"),
            "hidden_share": float(f"{self.hidden_share:.5g}"),
        }


def rms(values: Array) -> float:
    """Root of the mean square. Values of any shape, in their unit."""
    return float(np.sqrt(np.square(values).mean()))


def calibrated(bench: Bench, performed: Performed, floor_mm: float) -> Calibrated:
    """The calibration of a noise-free performance, from the measured dimensions."""
    return calibrate(bench.measured, performed.motor_turns, performed.load_n, performed.displacement_mm, floor_mm)


def measure(
    bench: Bench, protocol: Protocol, hidden: Mapping[str, Parameters], floor_mm: float, bare: Performed | None = None
) -> tuple[Size, Performed, Calibrated]:
    """Size of the effects together, the noise-free performance and its calibration; `bare` is without any effect."""
    bare = bare or perform(bench, protocol, {})
    performed = perform(bench, protocol, hidden)
    fit = calibrated(bench, performed, floor_mm)
    does_mm = (performed.displacement_mm - bare.displacement_mm) / bench.scale
    varies_mm, left_mm = float(does_mm.std()), rms(fit.residual_mm)
    hides = 1.0 - (left_mm / varies_mm) ** 2 if varies_mm > 0.0 else 0.0
    return Size(left_mm / floor_mm, rms(does_mm - does_mm[0]), varies_mm, hides), performed, fit


def strength_for(
    name: str, of: Strength, bench: Bench, protocol: Protocol, floor_mm: float, kappa: float
) -> tuple[float, Size]:
    """The strength at which an effect is kappa noise floors large after calibration; raises OutOfReach.

    Doubles until the size is passed, then bisects between the strengths on either side.
    """

    bare = perform(bench, protocol, {})

    def size(strength: float) -> Size:
        return measure(bench, protocol, {name: of(strength)}, floor_mm, bare)[0]

    low, high, strength = 0.0, np.inf, 1.0
    nearest: tuple[float, float, Size] | None = None
    for _ in range(PASSES):
        reached = size(strength)
        miss = abs(reached.kappa / kappa - 1.0)
        if nearest is None or miss < nearest[0]:
            nearest = (miss, strength, reached)
        if miss < CLOSE:
            return strength, reached
        if not np.isfinite(reached.kappa) or reached.kappa > kappa:
            high = strength
        elif reached.varies_mm > MOST_OF_STROKE * bench.stroke_mm or strength > 1e4:
            break
        else:
            low = strength
        guess = strength * kappa / reached.kappa if reached.kappa > 0.0 else np.inf  # most effects grow in proportion
        guess = float(np.clip(guess, strength / 16.0, strength * 16.0))
        inside = low + 0.02 * (min(high, 1e9) - low) < guess < high - 0.02 * (high - low if np.isfinite(high) else 0.0)
        strength = guess if inside or not np.isfinite(high) else (low + high) / 2.0
    if nearest is not None and nearest[0] < CLOSE_ENOUGH:
        return nearest[1:]
    raise OutOfReach(f"{name} leaves no {kappa:g} noise floors after calibration on this bench and protocol")
