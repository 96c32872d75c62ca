"""What a recording covers: loads, speeds, holds and rests, as they were made."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pipeline.diagnosis.recording.covered import covered, pauses
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.recording.working_samples import PHASES, Record
from pipeline.run.description import parse_run
from pipeline.run.planned_motion.motion_course import Recorded
from pipeline.run.planned_motion.outside import outside

RIG = {"actuator": "twisted_pair", "rig": {"load_n": 20.0}}
STRING = {"material": "Z", "radius_mm": 0.4, "length_mm": 300.0, "stiffness_n_per_mm": 50.0}
RUN = parse_run({"run": "a-1", **RIG, "string": STRING}, Path("a-1") / "run.yaml")


def record() -> Record:
    """Two strokes at 2 and 4 turns a second under 10 and 20 N, with a hold of 3 s and rests of 5 and 1 s."""
    legs = [("rest", 0, 5.0, 0.0, 10.0), ("winding", 1, 4.0, 2.0, 10.0), ("hold", 1, 3.0, 0.0, 10.0),
            ("unwinding", 1, 4.0, -2.0, 10.0), ("rest", 1, 1.0, 0.0, 20.0), ("winding", 2, 2.0, 4.0, 20.0),
            ("unwinding", 2, 2.0, -4.0, 20.0)]  # fmt: skip
    counts = [round(100 * seconds) for _, _, seconds, _, _ in legs]

    def each(column: int):
        return np.repeat([leg[column] for leg in legs], counts)

    time_s, velocity = 0.01 * np.arange(sum(counts)), each(3).astype(float)
    motion = np.cumsum(velocity) * 0.01
    phase = np.array([PHASES.index(name) for name in each(0)])
    index = np.zeros(len(time_s), int)
    return Record(
        time_s, motion, velocity, 0.0 * motion, motion, each(4).astype(float), None, None, each(1), phase, index
    )


def test_loads_and_speeds_are_those_that_were_made():
    ranges = covered(record())
    assert ranges["load"] == [10.0, 20.0] and ranges["speed_per_s"] == pytest.approx([2.0, 4.0])


def runs(*lengths_s: float) -> list[RecordedRun]:
    """A run for each length, whose rests and holds last so long."""
    recorded_runs = []
    for lasts_s in lengths_s:
        corners_s = np.cumsum([0.0, lasts_s, 5.0, 0.6 * lasts_s, 5.0, 2.0])
        time_s = np.arange(0.0, corners_s[-1], 0.02)
        turns = np.interp(time_s, corners_s, [0.0, 0.0, 20.0, 20.0, 0.0, 0.0])
        table = pd.DataFrame({"time_s": time_s, "motor_turns": turns, "displacement_mm": 0.0})
        recorded_runs.append(RecordedRun.cut(RUN, table))
    return recorded_runs


def test_holds_and_rests_are_those_that_were_made_and_none_goes_on_in_the_next_run():
    longest = pauses(runs(4.0, 7.0))
    assert longest["longest_rest_s"] == pytest.approx(7.0, abs=0.3)
    assert longest["longest_hold_s"] == pytest.approx(4.2, abs=0.3)


def test_a_planned_motion_is_told_the_same_pauses_as_the_verdict_says():
    (single_run,) = runs(4.0)
    recorded = Recorded([single_run.samples], [single_run.strokes], "motor_turns")
    assert pauses([single_run]) == {f"longest_{name}_s": recorded.longest_s(name) for name in ("hold", "rest")}
    plan = pd.DataFrame({"time_s": np.arange(0.0, 40.0, 0.02), "motor_turns": 20.0, "displacement_mm": 0.0})
    plan.loc[:100, "motor_turns"] = np.linspace(12.0, 20.0, 101)
    (asks,) = outside(RUN, plan, recorded).asks
    assert f"twice the longest that was recorded, {pauses([single_run])['longest_hold_s']:.3g} s, and 5 %)" in asks
