"""The loop of an effect: how far winding and unwinding part at one twist, where, and half of it as a parameter."""

import json
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pandas as pd
import pytest

from pipeline.diagnosis.facts.loops import widest
from pipeline.diagnosis.facts.mechanism_entries import totals
from pipeline.diagnosis.mechanisms.friction_hysteresis import half_loop
from pipeline.diagnosis.mechanisms.interface import Term
from pipeline.diagnosis.mechanisms.library import mechanisms
from pipeline.diagnosis.recording.system_units import Units
from pipeline.diagnosis.recording.working_samples import PHASES
from pipeline.diagnosis.words.language.vocabulary import Vocabulary
from pipeline.diagnosis.words.named.effect_sentence import details
from pipeline.systems import systems

ROOT = Path(__file__).parents[3]
TURNS = 20.0
NAMES = Units.of(systems()["separator"])
TERMS = [
    Term("a_mm", "resistance", np.zeros(1), total="half_loop_mm"),
    Term("b_mm", "resistance", np.zeros(1), total="half_loop_mm"),
    Term("a_load_mm_per_10_n", "resistance", np.zeros(1), "mm/10N", total="half_loop_mm_per_10_n"),
    Term("a_load_twist_mm_per_10_n", "resistance", np.zeros(1), "mm/10N"),
]


def strokes(count: int, whole: float = 1.0, per_way: int = 400) -> tuple[SimpleNamespace, np.ndarray]:
    """A recording of so many strokes, and an effect that opens by 0.06 mm at 16 turns but starts 0.4 mm off."""
    motion, stroke, phase = [], [], []
    for number in range(1, count + 1):
        top = TURNS if number == 1 else whole * TURNS
        motion += [np.linspace(0.0, top, per_way), np.linspace(top, 0.0, per_way)]
        stroke += [np.full(2 * per_way, number)]
        phase += [np.full(per_way, PHASES.index(name)) for name in ("winding", "unwinding")]
    turns, of_stroke, way = map(np.concatenate, (motion, stroke, phase))
    record = SimpleNamespace(motion=turns, stroke=of_stroke, phase=way, run_index=np.zeros(len(turns), dtype=int))
    record.load = np.full(len(turns), 20.0)
    half = 0.03 * np.exp(-(((turns - 16.0) / 6.0) ** 2))
    effect = np.where(way == 0, -half, half) - np.where((of_stroke == 1) & (way == 0), 0.4, 0.0)
    return SimpleNamespace(record=record), effect


def test_a_loop_is_as_wide_as_both_ways_part_at_one_twist_in_strokes_after_the_first() -> None:
    problem, effect = strokes(5)
    loop = widest(problem, effect)  # type: ignore[arg-type]
    assert loop is not None and np.ptp(effect) > 0.4
    assert loop.width == pytest.approx(0.06, rel=0.01) and loop.motion == pytest.approx(16.0, abs=0.5)


def test_a_stroke_of_few_samples_has_the_same_loop() -> None:
    loop = widest(*strokes(5, per_way=15))  # type: ignore[arg-type]
    assert loop is not None and loop.width == pytest.approx(0.06, rel=0.03)
    assert widest(*strokes(5, per_way=8)) is None  # type: ignore[arg-type]


def test_strokes_of_a_rig_without_a_load_have_one_width() -> None:
    problem, effect = strokes(5)
    problem.record.load = np.zeros_like(effect)
    loop = widest(problem, effect)  # type: ignore[arg-type]
    assert loop is not None and loop.width > 0.05 and loop.by_load == ()


def test_strokes_under_two_loads_have_a_width_under_each() -> None:
    problem, effect = strokes(7)
    assert widest(problem, effect).by_load == ()  # type: ignore[arg-type,union-attr]
    heavy = problem.record.stroke > 4
    problem.record.load = np.where(heavy, 40.0, 20.0)
    loop = widest(problem, np.where(heavy, 2.0, 1.0) * effect)  # type: ignore[arg-type]
    assert loop is not None
    assert loop.by_load == ((20.0, pytest.approx(0.06, rel=0.02)), (40.0, pytest.approx(0.12, rel=0.02)))


def test_without_whole_strokes_after_the_first_or_without_an_opening_there_is_no_loop() -> None:
    assert widest(*strokes(1)) is None  # type: ignore[arg-type]
    assert widest(*strokes(5, whole=0.5)) is None  # type: ignore[arg-type]
    problem, effect = strokes(5)
    assert widest(problem, np.zeros_like(effect)) is None  # type: ignore[arg-type]


def test_coefficients_that_are_the_whole_loop_are_summed() -> None:
    assert totals(TERMS, {"a_mm": 0.02, "b_mm": 0.01}, NAMES, 0.5) == {"half_loop_mm": (pytest.approx(0.03), "mm")}


def test_a_loop_that_grows_with_the_load_alone_says_by_how_much_beside_half_of_the_whole() -> None:
    parameters = {"a_mm": 0.0005, "a_load_mm_per_10_n": 0.04}
    grows = {"half_loop_mm_per_10_n": (0.04, "mm/10N")}
    assert totals(TERMS, parameters, NAMES, 0.031) == grows | {"half_loop_mm": (0.031, "mm")}
    assert totals(TERMS, parameters, NAMES) == grows


def test_a_sum_that_is_a_part_of_the_loop_gives_way_to_half_of_the_loop_or_to_nothing() -> None:
    parameters = {"a_mm": 0.0005, "a_load_mm_per_10_n": 0.02, "a_load_twist_mm_per_10_n": 0.04}
    assert totals(TERMS, parameters, NAMES, 0.031) == {"half_loop_mm": (0.031, "mm")}
    assert totals(TERMS, parameters, NAMES) == {}
    assert totals(TERMS, {"a_load_twist_mm_per_10_n": 0.04}, NAMES, 0.031) == {"half_loop_mm": (0.031, "mm")}


@pytest.mark.long
def test_half_the_play_is_that_of_the_recording_whatever_the_class_is_made_of(conceal, tmp_path):
    """The half-width of the class alone said 0.25 turns, with a share of 1 in a play of half that width."""
    folder, truth = conceal("backlash", kappa=3.0)
    subprocess.run([sys.executable, "-m", "pipeline.diagnose", folder, "--out", tmp_path], check=True, cwd=ROOT)
    content = json.loads((tmp_path / folder.name / "diagnosis.json").read_text())
    (named,) = content["mechanisms"]
    samples = pd.read_parquet(folder / "recording.parquet")
    turns, effect_mm = truth["turns"], truth["mismatch"]
    speed, near = np.gradient(turns), np.abs(turns / turns.max() - 0.6) < 0.05
    recorded = samples[(samples["motor_turns"] / turns.max() - 0.6).abs() < 0.05]
    slope = np.polyfit(recorded["motor_turns"], recorded["displacement_mm"], 1)[0]
    apart_mm = effect_mm[near & (speed < 0)].mean() - effect_mm[near & (speed > 0)].mean()
    play = named["parameters"]["half_play_turns"]
    assert play["value"] == pytest.approx(apart_mm / slope / 2.0, rel=0.08)
    assert play["low"] < play["value"] < play["high"] and play["unit"] == "turns"
    assert f"half the play is {play['value']:.3g} turns (" in " ".join(named["sentence"].split())


def test_half_the_width_of_a_loop_on_the_twist_counts_each_of_its_plays_by_its_share() -> None:
    """A verdict called the widest of two plays, 0.0384 turns, half the play of friction; both ways part by less."""
    values = {"play_turns": 0.0384, "usual_load": 1.82, "share": 0.42, "inner_share": 0.65}
    assert half_loop(values) == pytest.approx(0.0384 * (0.42 + 0.4 * 0.65))
    assert half_loop({"span_turns": 20.0, "stop_0.03_mm": 0.01}) == 0.0


def test_a_loop_on_the_twist_says_half_its_width_and_under_which_load() -> None:
    parameters = {
        "half_loop_turns": {"value": 0.0263, "low": 0.025, "high": 0.027, "unit": "turns"},
        "usual_load": {"value": 1.82, "low": 1.82, "high": 1.82, "unit": "1"},
    }
    system = systems()["separator"]
    sentence = details(mechanisms()["friction_hysteresis"], parameters, Vocabulary.of(system), Units.of(system))
    assert sentence == "half the width of the loop is 0.0263 turns (0.025 to 0.027) at 18.2 N"
