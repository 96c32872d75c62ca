"""A string is worked stroke by stroke until it fails or the recording ends; the truth of every stroke is kept."""

from dataclasses import dataclass

import numpy as np
import pandas as pd

from ...ground.kinematics import Array
from ..campaign.specimen_samples import STEPS_PER_SAMPLE, sampled
from ..motion_commands import Commands, Motion, commands
from ..string_state import String
from .ageing import made
from .strings_to_wear_out import Planned

FIRST_REST_S = 3.0
ENOUGH_LOST = 0.25  # of the stroke
EARLY = slice(1, 6)  # the strokes with which the others are compared
GRID = np.linspace(0.05, 1.0, 39)  # of the top twist


@dataclass(frozen=True)
class Lifetime:
    """`samples` as recorded, one row a sample; `truth`, one row a stroke, without noise and with the samples' zero.

    truth: `stroke` from 1, `stroke_mm` (at the end of the hold less in the rest before), `rest_mm`, `top_mm`,
    `loop_mm` (winding less unwinding at half the twist), `drift_mm` (rms of the winding less that of stroke 2).
    """

    samples: pd.DataFrame
    truth: pd.DataFrame


def live(planned: Planned, rate_hz: float) -> Lifetime:
    """Work a planned string and record it at `rate_hz`; to be done once, for it uses the plan's noise up."""
    step_s = 1.0 / rate_hz / STEPS_PER_SAMPLE
    effects, bundle = made(planned.ageing)
    string = String(planned.specimen.true, effects, step_s)
    first = commands(Motion(rest_s=FIRST_REST_S, strokes=[planned.stroke]), step_s)
    later = commands(Motion(rest_s=0.0, strokes=[planned.stroke]), step_s)
    turns: list[Array] = []
    pulled: list[Array] = []
    rows: list[dict[str, float]] = []
    windings: list[Array] = []
    last, zero_mm = planned.strokes, 0.0
    while len(rows) < last:
        # a stroke begins at the step where the one before ended
        stroke_commands, start = (later, 1) if rows else (first, 0)
        contraction_mm = string.pull(stroke_commands.motor_turns[start:], stroke_commands.load_n[start:])
        if bundle is not None and bundle.broken:
            break  # the load falls, and nothing of this stroke is kept
        if rows:
            contraction_mm = np.append(pulled[-1][-1], contraction_mm)
        else:
            zero_mm = contraction_mm[0]
        row, winding_mm = _measured(stroke_commands, contraction_mm - zero_mm)
        rows.append(row)
        windings.append(winding_mm)
        turns.append(stroke_commands.motor_turns[start:])
        pulled.append(contraction_mm[start:])
        early_mm = np.median([row["stroke_mm"] for row in rows[EARLY]] or [row["stroke_mm"]])
        if row["stroke_mm"] < (1.0 - ENOUGH_LOST) * early_mm:
            last = min(last, len(rows) + planned.after)
    contraction_mm = np.concatenate(pulled)
    time_s: Array = step_s * np.arange(len(contraction_mm), dtype=np.float64)
    truth = pd.DataFrame(rows)
    truth.insert(0, "stroke", np.arange(1, len(rows) + 1, dtype=np.int32))
    drift_mm = np.array(windings) - windings[min(1, len(windings) - 1)]
    truth["drift_mm"] = np.sqrt((drift_mm**2).mean(axis=1))
    return Lifetime(sampled(time_s, np.concatenate(turns), contraction_mm, planned.noise), truth)


def _measured(commands: Commands, contraction_mm: Array) -> tuple[dict[str, float], Array]:
    """One stroke's truth, and its winding over GRID; the contraction in mm at the steps of `commands`."""
    start, wound, held_until, end = (np.searchsorted(commands.time_s, commands.strokes_s[0] - 1e-9)).tolist()
    top_turns = float(commands.motor_turns.max())
    up, down = slice(start, wound + 1), slice(end, held_until, -1)

    def over(part: slice, turns: Array) -> Array:
        return np.interp(turns, commands.motor_turns[part], contraction_mm[part])

    half = np.array([top_turns / 2.0])
    rest_mm, top_mm = float(contraction_mm[start]), float(contraction_mm[held_until])
    loop_mm = float((over(up, half) - over(down, half))[0])
    measured = {"stroke_mm": top_mm - rest_mm, "rest_mm": rest_mm, "top_mm": top_mm, "loop_mm": loop_mm}
    return measured, over(up, GRID * top_turns)
