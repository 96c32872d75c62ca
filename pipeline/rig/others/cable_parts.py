"""The other parts of a cable drive between motor and jaw: stretch, play, creep, a kink, a slip, a late encoder."""

import math
from collections.abc import Sequence

import numpy as np

from ...ground.kinematics import Array
from ..effect import compiled

FULL_NM = 0.05  # the torque at which stretch and creep are told


def stretch_shape(torque_nm: Array, pretension_nm: float, power: float) -> Array:
    """Stretch of a jaw between two strands over that at 0.05 Nm; 0 at no torque.

    A strand's tension is a power of its stretch above 1, as its wires bed in, and nearly nothing when it hangs
    loose; the jaw turns until the strands' difference carries the torque, which is found by looking it up.
    Torque in Nm, the answer without a unit, both of shape (samples,).
    """

    def tension(stretched: Array) -> Array:
        taut = (stretched + np.hypot(stretched, 0.15)) / 2.0
        return pretension_nm * taut**power

    turned = np.linspace(-6.0, 6.0, 6001)  # in the stretch that the pretension makes
    carried_nm = tension(1.0 + turned) - tension(1.0 - turned)
    return np.asarray(np.interp(torque_nm, carried_nm, turned) / np.interp(FULL_NM, carried_nm, turned))


@compiled
def play_lost(motor_deg: Array, width_deg: float, soft: float) -> Array:
    """The motion that a coupling's play keeps from the jaw, within ± half its width, in deg.

    The contact takes hold over the last share `soft` of the half width. It starts in the middle. Shape (samples,).
    """
    half = width_deg / 2.0
    out = np.zeros(len(motor_deg))
    for k in range(1, len(motor_deg)):
        step = motor_deg[k] - motor_deg[k - 1]
        gap = out[k - 1]
        near = gap if step > 0.0 else -gap
        pressed = min(max((near - half * (1.0 - soft)) / (half * soft), 0.0), 1.0)
        gap += step * (1.0 - pressed * pressed * (3.0 - 2.0 * pressed))
        out[k] = min(max(gap, -half), half)
    return out


def crept(torque_nm: Array, step_s: float, power: float) -> Array:
    """Lengthening under load over time, 1 after 20 s under 0.05 Nm: six elements from 0.6 s to 60 s, all recover.

    Torque in Nm, the answer without a unit, both of shape (samples,).
    """
    taus_s = np.geomspace(0.6, 60.0, 6)
    target = np.sign(torque_nm) * np.abs(torque_nm / FULL_NM) ** power
    out = np.zeros(len(torque_nm))
    full = 0.0
    for tau_s in taus_s:
        out += followed(target, step_s, tau_s)
        full += -math.expm1(-20.0 / tau_s)
    return out / full


@compiled
def followed(target: Array, step_s: float, tau_s: float) -> Array:
    """A first-order element that starts at 0. Shape (samples,), in the unit of its input."""
    share = 1.0 - math.exp(-step_s / tau_s)
    out = np.zeros(len(target))
    for k in range(1, len(target)):
        out[k] = out[k - 1] + (target[k] - out[k - 1]) * share
    return out


def kinked(cable_deg: Array, at_deg: float, widths_deg: Sequence[float]) -> Array:
    """A kink that runs over a pulley: a hump of height 1 at one angle, steeper on one side, the same both ways.

    Shape (samples,); angles in deg.
    """
    away = cable_deg - at_deg
    width = np.where(away < 0, widths_deg[0], widths_deg[1])
    return np.asarray(1.0 / (1.0 + (away / width) ** 4))


def slipped(time_s: Array, at_s: float, within_s: float) -> Array:
    """A clamp that lets go once: from 0 to 1 within a few ms. Shape (samples,); time in s."""
    return np.asarray(np.clip((time_s - at_s) / within_s, 0.0, 1.0))


def late(values: Array, step_s: float, dead_s: float, poles_s: Sequence[float]) -> Array:
    """Values of a late sensor: after a dead time, through poles; at rest before the first sample.

    Shape (samples,), in the values' unit; times in s.
    """
    at = np.arange(len(values)) - dead_s / step_s
    out = np.interp(at, np.arange(len(values)), values)
    for pole_s in poles_s:
        out = values[0] + followed(out - values[0], step_s, pole_s)
    return np.asarray(out)
