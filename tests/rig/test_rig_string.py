"""The string: every effect can be switched off, does what its name says, and remembers."""

from pathlib import Path

import numpy as np
import pytest
from imported import imported

import pipeline.rig
from pipeline.ground.kinematics import Geometry
from pipeline.rig import effects
from pipeline.rig.motion_commands import Motion, commands
from pipeline.rig.setup import described, dimensions, read_setup
from pipeline.rig.string_state import String

GEOMETRY = Geometry("separator", 0.40, 400.0, 15.0, 150.0, 8.0)
STROKES = {"repeat": 3, "top_turns": 25, "speed_turns_per_s": 2.5, "hold_s": 5, "rest_s": 10, "load_n": 20}
TOLD = commands(Motion.model_validate({"rest_s": 2, "strokes": [STROKES]}), 0.02)
EFFECTS = read_setup("paper").effects


def pulled(*names: str, trajectory=TOLD) -> np.ndarray:
    """Contraction with these effects, less the analytic one, in mm."""
    string = String(GEOMETRY, [effects.make(name, EFFECTS.get(name, {})) for name in names], 0.02)
    return string.pull(trajectory.motor_turns, trajectory.load_n) - GEOMETRY.contraction_mm(
        trajectory.motor_turns, trajectory.load_n
    )


def at(error_mm: np.ndarray, time_s: float) -> float:
    return float(error_mm[round(time_s / 0.02)])


def test_without_effects_the_string_is_the_analytic_one():
    np.testing.assert_allclose(pulled(), 0.0, atol=1e-12)


@pytest.mark.parametrize("name", effects.names())
def test_each_effect_alone_does_something_and_next_to_nothing_at_the_start(name):
    error_mm = pulled(name)
    assert np.isfinite(error_mm).all()
    assert np.abs(error_mm[TOLD.time_s < 1.9] - error_mm[0]).max() < 0.1
    assert np.abs(error_mm).max() > 0.03


@pytest.mark.parametrize("name", effects.names())
def test_each_effect_carries_its_state_however_the_time_is_cut(name):
    whole = pulled(name)
    string = String(GEOMETRY, [effects.make(name, EFFECTS.get(name, {}))], 0.02)
    parts = [string.pull(TOLD.motor_turns[a : a + 700], TOLD.load_n[a : a + 700]) for a in range(0, 5000, 700)]
    joined = np.concatenate(parts) - GEOMETRY.contraction_mm(TOLD.motor_turns, TOLD.load_n)
    np.testing.assert_allclose(joined, whole, atol=1e-9)


def test_compaction_follows_the_twist_and_leaves_nothing_behind():
    error_mm = pulled("radius_compaction")
    start, wound, hold_end, end = TOLD.strokes_s[0]
    assert at(error_mm, hold_end - 0.1) < -2.0
    assert at(error_mm, (start + wound) / 2) == pytest.approx(at(error_mm, (hold_end + end) / 2), abs=0.02)
    assert abs(at(error_mm, end + 5)) < 0.02


def test_plastic_elongation_grows_from_stroke_to_stroke_and_stays():
    error_mm = pulled("plastic_elongation")
    after_mm = [at(error_mm, end + 5) for end in TOLD.strokes_s[:, 3]]
    steps_mm = -np.diff(after_mm, prepend=0.0)
    assert (steps_mm > 0.02).all() and (np.diff(steps_mm) < 0).all()
    assert at(error_mm, TOLD.strokes_s[0, 3] + 9) == at(error_mm, TOLD.strokes_s[0, 3] + 1)


def test_friction_opens_a_loop_as_wide_as_its_play():
    error_mm = pulled("friction_hysteresis")
    start, wound, hold_end, end = TOLD.strokes_s[1]
    gap_mm = at(error_mm, (hold_end + end) / 2) - at(error_mm, (start + wound) / 2)
    slope = float(GEOMETRY.slope_mm_per_turn(12.5, 20.0))
    assert gap_mm / slope == pytest.approx(0.20, abs=0.01)


def test_creep_goes_on_while_holding_and_comes_back_while_resting():
    error_mm = pulled("creep")
    _, wound, hold_end, end = TOLD.strokes_s[0]
    assert at(error_mm, hold_end) < at(error_mm, wound) - 0.003
    assert at(error_mm, end + 9) > at(error_mm, end) + 0.003


def test_the_papers_effects_together_keep_their_state_to_the_bit():
    names = list(EFFECTS)
    whole = pulled(*names)
    string = String(GEOMETRY, [effects.make(name, EFFECTS[name]) for name in names], 0.02)
    parts = [string.pull(TOLD.motor_turns[a : a + 700], TOLD.load_n[a : a + 700]) for a in range(0, 5000, 700)]
    joined = np.concatenate(parts) - GEOMETRY.contraction_mm(TOLD.motor_turns, TOLD.load_n)
    np.testing.assert_array_equal(joined, whole)


def test_a_finer_step_changes_little():
    fine = commands(Motion.model_validate({"rest_s": 2, "strokes": [STROKES]}), 0.005)
    string = String(GEOMETRY, [effects.make(*effect) for effect in EFFECTS.items()], 0.005)
    error_mm = string.pull(fine.motor_turns, fine.load_n) - GEOMETRY.contraction_mm(fine.motor_turns, 20.0)
    np.testing.assert_allclose(error_mm[::4], pulled(*EFFECTS), atol=0.01)


def test_the_rig_knows_neither_diagnosis_nor_models():
    for path in Path(pipeline.rig.__file__).parent.rglob("*.py"):
        assert not [name for name in imported(path) if name.startswith(("pipeline.diagnosis", "pipeline.models"))], path


def test_the_paper_rig_is_measured_right():
    setup = read_setup("paper")
    assert dimensions(described(setup, Path("synthetic-01/run.yaml"))) == GEOMETRY
