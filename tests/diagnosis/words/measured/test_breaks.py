"""What changed in the break between two runs is no effect: it is no slip, and the figure leads no line across it."""

import json
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from made_recording import BASE, content, motion
from matplotlib.figure import Figure

from pipeline.diagnosis import in_memory
from pipeline.diagnosis.drawing import overview
from pipeline.diagnosis.facts.mechanism_entries import recorded_about
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.mechanisms.shared_laws import happens_within, jump_mark
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem
from pipeline.diagnosis.words.pages.verdict import verdict_text
from pipeline.run.description import parse_run
from pipeline.systems import systems

TURNS, LOSES_AT_S = 0.3, 60.0  # lost, in the break or within the second run


def run_of(name: str, seed: int, lost_turns: float = 0.0, lost_at_s: float = -1.0, zero_mm: float = 0.0) -> RecordedRun:
    """A run of one string whose motor counts `lost_turns` too many from a time on, with a zero of its own."""
    corners = motion(4)
    time_s = np.arange(0.0, corners[-1, 0], 0.05)
    turns = np.interp(time_s, corners[:, 0], corners[:, 1])
    true_turns = turns - lost_turns * (time_s >= lost_at_s)
    noise = 0.03 * np.random.default_rng(seed).standard_normal(len(turns))
    reading_mm = BASE.contraction_mm(true_turns, 20.0) + zero_mm + noise
    table = pd.DataFrame({"time_s": time_s, "motor_turns": turns, "displacement_mm": reading_mm, "load_n": 20.0})
    described = content(name)
    described["string"] |= {"id": "spool-3", "strokes_before": 4 * (seed - 1)}
    return RecordedRun.cut(parse_run(described, Path(name) / "run.yaml"), table)


def verdict_of(second: RecordedRun):
    first = run_of("a-1", 1)
    diagnosis, study = in_memory.diagnosed([first, second])
    diagnosis["run"] = ["a-1", "a-2"]
    words = verdict_text(diagnosis, systems()["separator"], [Path("a-1"), Path("a-2")], Path("out"))
    return diagnosis, study, " ".join(words.split())


@pytest.fixture(scope="module")
def changed():
    """Two runs between which nothing but the motor's count was changed."""
    return verdict_of(run_of("a-2", 2, TURNS, zero_mm=4.0))


@pytest.mark.long
def test_a_twist_that_changed_between_two_runs_is_no_slip_and_is_said(changed) -> None:
    diagnosis, _, words = changed
    assert diagnosis["verdict"] == "parameters" and not diagnosis["mechanisms"]
    assert "Between the runs the twist changed, in a-2 by -0.3 turns. A string hung anew or of another radius" in words
    assert "Measure the zero" not in words and "three is the most" not in words
    assert diagnosis["parameters"]["angle_turns_2"]["value"] == pytest.approx(-TURNS, abs=0.03)


@pytest.mark.long
def test_counts_that_are_lost_within_a_run_are_named_still_with_a_time_that_was_recorded() -> None:
    diagnosis, study, words = verdict_of(run_of("a-2", 2, TURNS, LOSES_AT_S))
    assert [entry["id"] for entry in diagnosis["mechanisms"]] == ["count_slip"]
    assert "Between the runs" not in words
    at_s = diagnosis["mechanisms"][0]["parameters"]["at_s"]
    begins = study.problem.drivers.elapsed_s[study.problem.drivers.first == 0]
    assert at_s["value"] == pytest.approx(begins[1] + LOSES_AT_S, abs=1.0)
    assert begins[1] <= at_s["low"] <= at_s["value"] <= at_s["high"] <= study.problem.drivers.elapsed_s[-1]


@pytest.mark.long
def test_no_slip_is_looked_for_in_a_break_and_no_jump_is_seen_there(changed) -> None:
    problem = make_problem([run_of("a-1", 1), run_of("a-2", 2)])
    drivers = problem.drivers
    begin = int(np.flatnonzero(drivers.first == 0)[1])
    step = np.where(np.arange(len(drivers.first)) < begin, 0.0, 5.0)
    noise = 0.1 * np.random.default_rng(0).standard_normal(len(step))
    assert jump_mark(drivers, step + noise, step) < 1.0 < jump_mark(drivers, np.roll(step, 40) + noise, step)
    break_s = drivers.elapsed_s[begin - 1], drivers.elapsed_s[begin]
    for id_ in ("count_slip", "clamp_slip"):
        tried = [
            *mechanisms()[id_].candidates(drivers),
            *mechanisms()[id_].suggest(drivers, step + noise, np.zeros(len(step))),
        ]
        assert len(tried) > 80 and not any(break_s[0] < each["at_s"] < break_s[1] for each in tried)
    assert not happens_within(drivers, {"at_s": sum(break_s) / 2}) and happens_within(drivers, {"at_s": -1.0})
    assert recorded_about(drivers, break_s[1] + 5.0) == (break_s[1], drivers.elapsed_s[-1])


def test_no_line_of_the_figure_leads_across_a_break(changed) -> None:
    drivers = changed[1].problem.drivers
    axes = Figure().subplots()
    overview.over_time(axes, drivers, {"recording": (drivers.motion, {"color": "k"})}, "turns")
    time_s = axes.get_lines()[0].get_xdata()
    gaps = np.diff(time_s)
    assert np.isnan(time_s).sum() == 1 and np.nanmax(gaps) < 1.0 < np.diff(drivers.elapsed_s).max()


def test_a_verdict_of_several_runs_can_be_written(changed) -> None:
    json.dumps(changed[0])
