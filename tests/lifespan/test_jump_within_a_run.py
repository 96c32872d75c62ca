"""A reading that jumps within a run: no wear, no law, and the words that say so."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import programs
import pytest
from made_life import folder, samples

from pipeline.lifespan.forecast.life_questions import model_error, stroke_loss
from pipeline.lifespan.from_folders import strings
from pipeline.lifespan.stroke_health.reading_jump import steps
from pipeline.lifespan.words.jump_said import jump_lines
from pipeline.lifespan.words.sentences import sentences

NOISE_MM = 0.01
N = np.arange(1.0, 15.0)


def table(rest_mm: np.ndarray, runs: list[str] | None = None, seed: int = 0) -> pd.DataFrame:
    """A table of strokes with these readings at rest and noise on them."""
    noisy = rest_mm + NOISE_MM * np.random.default_rng(seed).standard_normal(len(rest_mm))
    number = np.arange(1, len(rest_mm) + 1)
    return pd.DataFrame({"run": runs or "a-1", "stroke": number, "rest_mm": noisy, "rest_mm_error": NOISE_MM})


def found(rest_mm: np.ndarray, runs: list[str] | None = None) -> list[tuple[str, int, float]]:
    """Run, stroke and size of the jumps, rounded."""
    return [(step.run, step.stroke, round(step.moved_mm, 1)) for step in steps(table(rest_mm, runs), "rest_mm")]


def slipped(strokes: int, *jumps: tuple[int, float]) -> pd.DataFrame:
    """Samples of a string that does not age, whose clamp slips by so many mm while it unwinds in a stroke."""
    table_ = samples(strokes, 0.0)
    stroke, place = np.divmod(np.arange(len(table_)), 114)
    displacement_mm = table_["displacement_mm"] + 0.05 * np.minimum(stroke, strokes - 1)
    for number, slip_mm in jumps:
        displacement_mm -= slip_mm * ((stroke >= number) | ((stroke == number - 1) & (place >= 90)))
    return table_.assign(displacement_mm=displacement_mm)


@pytest.mark.parametrize("after", [2, 8, 12])
def test_one_clean_step_is_a_jump_after_its_stroke(after: int) -> None:
    assert found(-0.8 * (after < N)) == [("a-1", after, -0.8)]
    ((run, stroke, moved_mm),) = found(0.8 * (after < N) + 0.2 * np.log(N) / np.log(14.0))
    assert (run, stroke) == ("a-1", after) and moved_mm == pytest.approx(0.85, abs=0.06), "with a little creep"


def test_two_steps_are_two_jumps_also_where_the_second_takes_the_first_back() -> None:
    assert found(-0.8 * (N > 4) - 0.5 * (N > 9)) == [("a-1", 4, -0.8), ("a-1", 9, -0.5)]
    assert found(-0.8 * (N > 4) + 0.8 * (N > 9)) == [("a-1", 4, -0.8), ("a-1", 9, 0.8)]


@pytest.mark.parametrize(
    "rest_mm",
    [
        -0.1 * N,
        -0.6 * np.log(N),
        -2.0 * np.exp(-2.0 * N),
        -0.8 * np.exp(-N / 0.7),
        -0.8 * np.exp((N - 14.0) / 0.7),
        0.05 / (14.5 - N),
        -0.8 * (N == 6),
        -0.8 * (N == 14),
        -0.8 * (N > 13),
        -0.2 * np.clip(N - 5.0, 0.0, 4.0),
        -0.8 * (N > 8) - 0.1 * N,
    ],
    ids=["line", "creep", "bedding in", "bedding in slower", "end", "feeds itself", "bad stroke", "bad last", "last",
         "ramp", "wear larger than the step"],
)  # fmt: skip
def test_wear_creep_and_a_bad_stroke_are_no_jump(rest_mm: np.ndarray) -> None:
    assert found(rest_mm) == []


def test_a_step_that_noise_can_make_is_no_jump() -> None:
    """Over 200 records of noise none jumps, and none with a step of three times the noise."""
    for size_mm in (0.0, 3.0 * 0.05):
        noisy = (
            table(-size_mm * (N > 8) + 0.05 * np.random.default_rng(seed).standard_normal(14), seed=seed)
            for seed in range(200)
        )
        assert not any(steps(strokes, "rest_mm") for strokes in noisy)
    assert found(-0.04 * (N > 8)) == [], "less than anyone sets out for"


def test_a_step_between_two_runs_or_over_strokes_that_are_not_compared_is_no_jump() -> None:
    assert found(-0.8 * (N > 8), ["a-1"] * 8 + ["a-2"] * 6) == []
    over = table(-0.8 * (N > 8))
    assert steps(over.assign(stroke=over["stroke"] + 3 * (over["stroke"] > 8)), "rest_mm") == []


@pytest.fixture(scope="module")
def printed(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str, dict]:
    """What the program prints and writes of 14 strokes whose clamp slipped by 0.8 mm in the eighth."""
    place = tmp_path_factory.mktemp("slip")
    run = folder(place, "a-1", slipped(14, (8, 0.8)))
    ran = programs.run("pipeline.lifespan", run, "--out", place / "out")
    assert ran.returncode == 0, ran.stderr
    return run, ran.stdout, json.loads((place / "out" / "a-1" / "lifespan.json").read_text())


def test_a_clamp_that_slipped_once_is_said_to_be_a_jump_and_the_command_names_its_run(printed) -> None:
    run, text, saved = printed
    assert "Jump: at stroke 8 (a-1) the reading at rest fell by 0.8 mm at once, " in text
    assert "times the noise from stroke to stroke.\n  A jump is no wear: a clamp or the counter may have" in text
    assert f"\n    python -m pipeline.diagnose {run} --out {run.parent / 'out' / 'jump'}\n" in text
    (jump,) = saved["jumps"]
    assert (jump["indicator"], jump["run"], jump["after_stroke"]) == ("rest_mm", "a-1", 8)
    assert jump["jump_mm"] == pytest.approx(-0.8, abs=0.05)


def test_no_law_goes_through_a_jump_and_the_other_question_keeps_its_forecast(printed) -> None:
    """ "Not one stroke is sure" stood there of an error that had stood still for six strokes."""
    _, text, saved = printed
    words = " ".join(text.split())
    assert "not one stroke is sure" not in text and "calibrate your model again now" not in text
    assert "Until that model is off by 1 mm: no claim: most of its change came by a jump at stroke 8, and" in words
    assert "For a forecast record 12 strokes as a new run, and name only the runs since the jump." in words
    assert "Advice: find what jumped and mend it, then calibrate your model on strokes recorded after it." in words
    assert "Why that first: a model calibrated on strokes before a jump" in words and "Calibrate it by" not in text
    error, loss = saved["questions"]["model_error"], saved["questions"]["stroke_loss"]
    assert error["state"] == "no claim" and error["laws"] == [] and saved["recalibrate_after_strokes"] is None
    assert loss["state"] in ("one-sided", "censored") and loss["laws"]


def test_of_a_stroke_and_a_rest_each_change_has_its_own_verdict(printed) -> None:
    """ "The string is 0.8 mm longer at rest. This change is within the noise" of 40 times the noise."""
    words = " ".join(printed[1].split())
    assert ", but the string is 0.8 mm longer at rest, beyond the noise (the last 3 strokes against the first" in words
    assert ", within the noise" in words.split("but the string")[0].split("So far")[1]
    assert "This change" not in words


def test_a_limit_that_a_jump_passed_is_passed_and_what_jumped_is_found_before_a_calibration(tmp_path: Path) -> None:
    run = folder(tmp_path, "a-1", slipped(14, (8, 1.5)))
    words = " ".join(programs.run("pipeline.lifespan", run, "--out", tmp_path / "out").stdout.split())
    assert "Until that model is off by 1 mm: passed already at stroke 9." in words
    assert "Advice: find what jumped and mend it, then" in words and "Calibrate it by" not in words


def test_a_string_that_wears_without_a_step_keeps_its_forecast_and_no_jump_is_said(tmp_path: Path) -> None:
    (health,) = strings([folder(tmp_path, "a-1", samples(24, 0.002))])
    assert jump_lines(health, [tmp_path / "a-1"], tmp_path) == []
    assert all(len(answer.left.when) for answer in (stroke_loss(health, 0.1), model_error(health, 4.0)))


def test_two_jumps_are_both_said_and_refuse_the_forecast(tmp_path: Path) -> None:
    run = folder(tmp_path, "a-1", slipped(16, (5, 0.6), (10, -0.6)))
    (health,) = strings([run])
    fell, rose, *_ = jump_lines(health, [run], tmp_path)
    assert "at stroke 5 (a-1) the reading at rest fell by" in fell
    assert "at stroke 10 (a-1) the reading at rest rose by" in rose
    assert "came by jumps at strokes 5 and 10, and" in model_error(health, 1.0).left.reason
    answers = [stroke_loss(health, 0.1), model_error(health, 1.0)]
    assert "No ageing is seen" not in sentences(health, answers, 0.9), "a model that was off in between"


def test_a_stroke_that_jumps_is_foretold_nothing_of(tmp_path: Path) -> None:
    (health,) = strings([folder(tmp_path, "a-1", slipped(14))])
    jumped = health.strokes.assign(stroke_mm=health.strokes["stroke_mm"] - 0.5 * (health.strokes["stroke"] > 8))
    health = replace(health, strokes=jumped)
    assert "Jump: from stroke 8 to 9 (a-1) the stroke got shorter by 0." in jump_lines(health, [], tmp_path)[0]
    assert stroke_loss(health, 0.1).left.reason.startswith("most of its change came by a jump at stroke 8")


def test_a_jump_that_is_little_of_a_models_error_leaves_its_forecast(tmp_path: Path) -> None:
    (health,) = strings([folder(tmp_path, "a-1", slipped(24, (8, 0.3)))])
    worn = health.strokes.assign(model_error_mm=0.1 * health.strokes["stroke"])
    assert model_error(health, 9.0).left.jumped
    assert len(model_error(replace(health, strokes=worn), 9.0).left.when)
