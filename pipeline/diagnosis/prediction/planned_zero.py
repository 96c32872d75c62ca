"""The zero of a planned reading: a plan has no measured first second that could set it, as a recording has."""

import re
from pathlib import Path

import numpy as np

from ...ground.kinematics import Array
from ...systems import System
from ..document.content import Simulated
from ..fit.problem import Problem
from ..recording.recorded_run import RecordedRun
from ..study.own_rate import at_own_rate
from .simulation import TARE_S, simulated, tare

COVERED = 0.5  # of the range of a recorded motion


def own_zero(content: Simulated, system: System, run: str) -> str:
    """The name of the zero of a run's reading in the simulator; empty where it holds none.

    Of several runs each has its own. A run that adopted the diagnosis of several holds its own one alone.
    """
    together, unit = content.get("run"), system.channel.rpartition("_")[2]
    if isinstance(together, list):
        names = [f"zero_{together.index(run) + 1}_{unit}"] if run in together else []
    else:
        numbered = [name for name in content["parameters"] if re.fullmatch(rf"zero_\d+_{unit}", name)]
        names = [f"zero_{unit}", *numbered] if together == run else []
    return next((name for name in names if name in content["parameters"]), "")


def beginning(recorded: RecordedRun | None) -> Problem | None:
    """The beginning of a recording: its first second sets a zero that is otherwise unknown; None without a recording.

    It goes on until the motion has covered `COVERED` of its range: a motion that stands cannot be simulated.
    """
    if recorded is None:
        return None
    samples, driver = recorded.samples, recorded.run.system.driver
    motion, time_s = samples[driver].to_numpy(float), samples["time_s"].to_numpy(float)
    span = np.maximum.accumulate(motion) - np.minimum.accumulate(motion)
    kept = int(np.searchsorted(span, COVERED * span[-1], side="right"))
    kept = max(kept + 1, int(np.searchsorted(time_s, time_s[0] + TARE_S, side="right")))
    return at_own_rate([recorded.begun(kept)], thin=False, to_fit=False)


def set_by(begun: Problem, content: Simulated, path: Path, run: str) -> float:
    """The offset from a simulator's reading to a recording's first second, in the channel's unit.

    Raises BadInput as `simulated` does.
    """
    return tare(simulated(begun, content, path, run), begun.measured, begun.record.time_s)


def set_where_it_begins(predicted: Array) -> Array:
    """A reading that is 0 in its first row; of shape (samples,), in the channel's unit."""
    return predicted - predicted[0]
