"""The last strokes decide between explanations that were likely without them, and contradict none of these."""

import numpy as np
import pandas as pd
import pytest

from pipeline.diagnosis.in_memory import diagnosed
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.heldout import decided
from pipeline.diagnosis.words.pages.verdict import verdict_text
from pipeline.run.description import Run

BEST, SECOND, THIRD = ["backlash", "clamp_slip"], ["clamp_slip", "friction_hysteresis"], ["clamp_slip", "slack"]


def errors():
    """Errors of a procedure that named the best of three without the last strokes."""
    tied = [{"ids": SECOND, "explained": 0.2, "state": "second"}, {"ids": THIRD, "explained": 0.3, "state": "third"}]
    own = {"split": "last", "nominal": 2.0, "calibrated": 1.0, "explained": 0.5, "without_physics": 0.4, "left": {}}
    return own | {"chosen": BEST, "closest": [], "state": "best", "until_s": 9.0, "tied": tied}


def test_the_error_is_of_what_all_strokes_name_where_it_was_likely_without_the_last_ones():
    before = errors()
    after = decided(before, SECOND[::-1])
    assert (after["explained"], after["state"], set(after["chosen"])) == (0.2, "second", set(SECOND))
    assert after["decided"] == [BEST, THIRD] and (after["nominal"], after["until_s"]) == (2.0, 9.0)
    assert "without_physics" not in after and "left" not in after, "these were asked about the other one"


@pytest.mark.parametrize("named", [BEST, ["creep"], []])
def test_it_stays_the_error_of_what_was_named_without_them_otherwise(named):
    before = errors()
    assert decided(before, named) is before


def pair(name: str, load_n: float, tops: int, slip_mm: float, seed: int) -> RecordedRun:
    """A twisted pair with a friction that follows load and lever; its clamp slips once, where `slip_mm` is not 0."""
    rate_hz, motor = 20, [np.zeros(80)]
    ramp = 3.0 * np.linspace(0.0, 1.0, 130) ** 2 - 2.0 * np.linspace(0.0, 1.0, 130) ** 3
    for _ in range(tops):
        motor += [26.0 * ramp, np.full(40 if slip_mm else 400, 26.0), 26.0 * ramp[::-1], np.zeros(40)]
    turns = np.concatenate(motor)
    wound = 2.0 * np.pi * 0.601 * turns
    drawn_mm, slope, pressed = 300.5 - np.sqrt(300.5**2 - wound**2), wound / np.sqrt(300.5**2 - wound**2), [0.0]
    for moved in np.diff(turns):
        pressed.append(min(max(pressed[-1] + moved / 0.8, -1.0), 1.0))
    drawn_mm = drawn_mm - 0.022 * load_n * slope * np.array(pressed)
    drawn_mm[int(0.55 * len(turns)) :] -= slip_mm
    noise = np.random.default_rng(seed).normal(0.0, 0.02, len(turns))
    samples = pd.DataFrame(
        {
            "time_s": np.arange(len(turns)) / rate_hz,
            "motor_turns": turns,
            "displacement_mm": drawn_mm + noise,
            "load_n": np.full(len(turns), load_n),
        }
    )
    string = {"material": "dyneema", "radius_mm": 0.6, "length_mm": 300.0, "id": "b"}
    run = Run.model_validate({"run": name, "actuator": "twisted_pair", "string": string, "rig": {}})
    return RecordedRun.cut(run, samples)


@pytest.mark.long
def test_one_stroke_under_another_load_that_settles_a_tie_is_not_asked_for_again():
    """The verdict had asked for it, named the right one with 98 %, and said: not settled, record 15 strokes again."""
    runs = [pair("b-1", 25.0, 14, 0.8, 5), pair("b-2", 50.0, 1, 0.0, 6)]
    content, study = diagnosed(runs)
    assert {entry["id"] for entry in content["mechanisms"]} == set(SECOND)
    assert content["evidence"]["likely_without_them"] == [BEST] and set(
        content["evidence"]["chosen_without_them"]
    ) == set(SECOND)
    words = " ".join(verdict_text(content, study.problem.system, []).split())
    assert "Without the last 30 % of strokes backlash + clamp_slip was likely too." in words
    assert "not settled" not in words and "still missing" not in words and "strokes again" not in words
    assert "The unseen strokes had 25 to 50 N of load" in words
