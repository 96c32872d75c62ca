"""The zeros in a diagnosis keep the digits of their width; a later one says how far it is from the first."""

from pathlib import Path

import pytest
from made_recording import content, recording

from pipeline.diagnosis.document.rounded import to_its_width
from pipeline.diagnosis.fit import calibrate, intervals
from pipeline.diagnosis.fit.zero_entries import zero_entries
from pipeline.diagnosis.numerics.noise import white
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.own_rate import at_own_rate
from pipeline.run.description import parse_run
from pipeline.run.strokes import segment

FAR_MM, MOVED_MM = -150.0, 0.6


def test_zeros_far_from_0_keep_an_interval_and_say_what_they_were_moved_by() -> None:
    runs = []
    for name, zero_mm in (("a-1", FAR_MM), ("a-2", FAR_MM + MOVED_MM)):
        samples = recording(3, rate_hz=20.0, noise_mm=0.002)
        samples["displacement_mm"] += zero_mm
        run = parse_run(content(name), Path(f"raw/{name}/run.yaml"))
        runs.append(RecordedRun(run, samples, segment(samples, "motor_turns", name)))
    problem = at_own_rate(runs, thin=False)
    noise = white(0.002)
    bands = intervals.intervals(problem, calibrate.base(problem), noise)
    zeros = zero_entries(problem, bands, "mm")
    assert list(zeros) == ["zero_1_mm", "zero_2_mm"] and "from_first" not in zeros["zero_1_mm"]
    for zero in zeros.values():
        assert zero["low"] < zero["value"] < zero["high"]
    move = zeros["zero_2_mm"]["from_first"]
    assert move["value"] == pytest.approx(MOVED_MM, abs=1e-4) and move["low"] < move["value"] < move["high"]
    assert move["value"] == pytest.approx(zeros["zero_2_mm"]["value"] - zeros["zero_1_mm"]["value"], abs=1e-4)


def test_an_interval_is_rounded_to_two_digits_of_its_width() -> None:
    """With five digits of the value all three were alike: -149.41, -149.41 and -149.4."""
    ends = {"value": -149.409123, "low": -149.411523, "high": -149.404123}
    assert to_its_width(ends) == {"value": -149.4091, "low": -149.4115, "high": -149.4041}
    wide = {"value": 0.0123456, "low": -2.3456789, "high": 3.4567891}
    assert to_its_width(wide) == {"value": 0.012346, "low": -2.3457, "high": 3.4568}, "no fewer than elsewhere"
    point = {"value": 1.2345678, "low": 1.2345678, "high": 1.2345678}
    assert to_its_width(point) == dict.fromkeys(point, 1.2346)
    unknown = to_its_width({"value": 1.2345678, "low": float("-inf"), "high": float("inf")})
    assert unknown == {"value": 1.2346, "low": None, "high": None}
