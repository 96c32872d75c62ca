"""A long recording is refitted to averages, and scored on every second, third, … of its own samples."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pipeline.diagnosis.fit.problem import Problem
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study import own_rate
from pipeline.run.description import parse_run
from pipeline.run.spikes import despiked
from pipeline.systems import systems

ROWS, STEP_S = 3_000, 0.02


def described(**changes):
    """A twisted pair."""
    string = {"material": "Z", "radius_mm": 0.4, "length_mm": 300.0, "stiffness_n_per_mm": 50.0}
    content = {"run": "long", "actuator": "twisted_pair", "string": string, "rig": {"load_n": 20.0}}
    return parse_run(content | changes, Path("long") / "run.yaml")


def recorded(rows: int = ROWS) -> pd.DataFrame:
    """Six strokes of a twisted pair, with noise."""
    time_s = STEP_S * np.arange(rows)
    turns = 20.0 * np.interp((time_s / 10.0) % 1.0, [0.0, 0.1, 0.5, 0.6, 1.0], [0.0, 0.0, 1.0, 1.0, 0.0])
    noise_mm = np.random.default_rng(1).normal(0.0, 0.02, rows)
    displacement_mm = 300.0 - np.sqrt(300.0**2 - (0.4 * 2.0 * np.pi * turns) ** 2) + noise_mm
    return pd.DataFrame({"time_s": time_s, "motor_turns": turns, "displacement_mm": displacement_mm})


@pytest.mark.parametrize(("most", "rows"), [(ROWS, ROWS), (ROWS - 1, ROWS // 2), (ROWS // 3, ROWS // 3)])
def test_what_is_scored_are_own_samples_at_most_so_many(monkeypatch, most, rows):
    monkeypatch.setattr(own_rate, "SCORED_SAMPLES", most)
    recording = recorded()
    scored = own_rate.to_score([RecordedRun.cut(described(), recording)])
    assert len(scored.record) == rows
    np.testing.assert_array_equal(scored.measured, recording["displacement_mm"].to_numpy()[:: ROWS // rows])


def test_a_system_that_follows_derivatives_is_scored_on_all_it_has(monkeypatch):
    followers = [system for system in systems().values() if system.differentiates]
    assert followers
    sample_counts = []
    monkeypatch.setattr(own_rate, "SCORED_SAMPLES", 10)
    monkeypatch.setattr(own_rate, "at_own_rate", lambda runs: sample_counts.append(len(runs[0].samples)))
    run = type("Told", (), {"system": followers[0]})()
    own_rate.to_score([replace(RecordedRun.cut(described(), recorded()), run=run)])  # type: ignore[arg-type]
    assert sample_counts == [ROWS]


def test_a_long_recording_is_polished_on_averages_and_a_short_one_as_it_is(monkeypatch):
    runs = [RecordedRun.cut(described(), recorded())]
    fine: Problem = own_rate.to_score(runs)
    assert own_rate.to_polish(runs, fine) is fine
    monkeypatch.setattr(own_rate, "POLISHED_SAMPLES", 1_000)
    averaged = own_rate.to_polish(runs, fine)
    assert len(averaged.record) == 1_000
    plain = runs[0].samples["displacement_mm"].to_numpy()
    assert averaged.measured == pytest.approx(despiked(plain).reshape(-1, 3).mean(axis=1))


def test_terms_of_fewer_shapes_are_remembered_of_a_long_recording(monkeypatch):
    from pipeline.diagnosis.fit import problem as module
    from pipeline.diagnosis.mechanisms.library import mechanisms

    problem = own_rate.to_score([RecordedRun.cut(described(), recorded())])
    options = [
        (effect, nonlinear) for effect in mechanisms().values() for nonlinear in effect.candidates(problem.drivers)
    ][:5]
    numbers = [ROWS * len(problem.terms(mechanism, nonlinear)) for mechanism, nonlinear in options]
    problem._terms.clear()
    monkeypatch.setattr(module, "REMEMBERED_NUMBERS", sum(numbers[-2:]))
    for mechanism, nonlinear in options:
        problem.terms(mechanism, nonlinear)
    assert [key[0] for key in problem._terms] == [mechanism.id for mechanism, _ in options[-2:]]
    monkeypatch.setattr(module, "REMEMBERED_NUMBERS", ROWS - 1)
    problem.terms(*options[0])
    assert problem.terms(*options[0]) is problem.terms(*options[0])  # the last one is always kept
    assert len(problem._terms) == 1
