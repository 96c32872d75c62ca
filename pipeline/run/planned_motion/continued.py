"""A planned motion after a recorded one: recorded rows, the way from their end to the plan, the plan's rows."""

import numpy as np
import pandas as pd
from scipy.ndimage import gaussian_filter1d

from ...systems import System

SMOOTH_S = 0.12  # over which the noise of a recorded motion is smoothed, where it is given another rate
SOFTLY, LEAST_S = 15.0 / 8.0, 0.2  # times as long as at one speed, to pass no higher one; the shortest such way
SAME = 0.01  # of a step, or of the recorded range: less is no other step, and no way to go


def continued(system: System, samples: pd.DataFrame, recorded: pd.DataFrame, drawn: bool) -> pd.DataFrame:
    """Rows of a recording, then those of a plan at the end; both have `time_s` and their channels.

    A plan that begins elsewhere than the recording ended is reached on a straight line at the speed that the recording
    usually moved with; where the reading follows derivatives of the motion the way starts and ends softly, and takes
    `LEAST_S` at least, since a kink would add a force of its own. `drawn`: whether corners drew the plan; then the
    recorded motion is smoothed, for nothing smooths its speed later. Channels that the plan lacks are left out.
    """
    names = [name for name in samples.columns if name in recorded]
    step_s = float(np.median(np.diff(samples["time_s"])))
    before = _at_step(recorded[names], step_s, system.channel, drawn)
    last, first = before.iloc[-1], samples.iloc[0]
    way = abs(float(first[system.driver] - last[system.driver]))
    speed = np.abs(np.diff(before[system.driver])) / np.diff(before["time_s"])
    gap_s = step_s
    if way > SAME * float(np.ptp(before[system.driver])) or system.differentiates:
        gap_s = max(way / max(float(np.median(speed[speed > 0.5 * np.percentile(speed, 99.0)])), 1e-9), step_s)
    if system.differentiates:
        gap_s = max(SOFTLY * gap_s, LEAST_S)
    shift_s = float(last["time_s"] - first["time_s"]) + gap_s
    after = samples[names].assign(time_s=samples["time_s"] + shift_s)
    count = round(gap_s / step_s)
    share = (np.arange(1, count) / count)[:, None]
    start, end = before.to_numpy(float)[-1], after.to_numpy(float)[0]
    bridge = pd.DataFrame(start + share * (end - start), columns=names)
    if system.differentiates:
        soft = share[:, 0] ** 3 * (10.0 - 15.0 * share[:, 0] + 6.0 * share[:, 0] ** 2)
        bridge[system.driver] = last[system.driver] + soft * (first[system.driver] - last[system.driver])
    return pd.concat([before, bridge, after], ignore_index=True)


def _at_step(recorded: pd.DataFrame, step_s: float, channel: str, drawn: bool) -> pd.DataFrame:
    """A recording at another time step, its inputs smoothed; unchanged where it has that step already."""
    time_s = recorded["time_s"].to_numpy(float)
    own_s = float(np.median(np.diff(time_s)))
    if not drawn and abs(own_s - step_s) <= SAME * step_s:
        return recorded
    width, at_s = max(SMOOTH_S, step_s) / own_s, np.arange(time_s[0], time_s[-1], step_s)
    resampled = pd.DataFrame({"time_s": at_s})
    for name in recorded.columns.drop("time_s"):
        values = recorded[name].to_numpy(float)
        resampled[name] = np.interp(at_s, time_s, values if name == channel else gaussian_filter1d(values, width))
    return resampled[list(recorded.columns)]
