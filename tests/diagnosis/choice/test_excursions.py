"""A reading that goes off for a while and comes back is no noise, and nothing that a string does."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_rgba

from pipeline.diagnosis.choice.excursions import excursions, far_off
from pipeline.diagnosis.drawing import figures, overview
from pipeline.diagnosis.fit import calibrate
from pipeline.diagnosis.fit.problem import Act
from pipeline.diagnosis.in_memory import diagnosed
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem
from pipeline.diagnosis.words.pages.verdict import verdict_text
from pipeline.proof.teach.lesson import recorded
from pipeline.rig.authors import authors
from pipeline.rig.authors.interface import Asked


def made(author: str, seed: int, effects: tuple[str, ...] = (), kappas: tuple[float, ...] = ()) -> RecordedRun:
    recording = authors()[author].make(Asked(seed, effects, kappas, "rich"))
    return recorded({"run": "made", **recording.content}, recording.table)


@pytest.fixture(scope="module")
def leaning() -> RecordedRun:
    """A recording during which somebody leans on the rig now and then."""
    return made("lattice", 813, ("x_leaning",), (7.0,))


@pytest.mark.long
def test_drops_that_come_back_are_unknown_and_said(leaning) -> None:
    content, study = diagnosed([leaning])
    assert content["verdict"] == "unknown" and content["mechanisms"] == []
    entries = content["evidence"]["excursions"]
    assert len(entries) == 7 and min(entry["lasts_s"] for entry in entries) > 1.0
    page = " ".join(verdict_text(content, leaning.run.system, [Path("raw/made")]).split())
    assert "The displacement goes off 7 times for 1.8 s to 15 s, by up to 1.8 mm, and comes back (at 44, 72" in page
    assert 0.05 < content["evidence"]["between_mm"] < 0.5 * content["evidence"]["calibrated_mm"]
    assert f"outside of them calibration leaves {content['evidence']['between_mm']:.2f} mm rms" in page
    assert page.startswith("made: unknown: the displacement goes off 7 times and comes back, which no explanation")
    assert "1. Look at the rig and at the sensor at 44, 72, 88 and 203 s and later of the recording" in page
    assert "2. Measure again what calibration moved far" in page
    _, residual, *_ = figures.drawn(study, content).axes
    shaded = [patch for patch in residual.patches if patch.get_facecolor() == to_rgba(overview.OFF)]
    assert len(shaded) == 7 and residual.get_title(loc="left").endswith(overview.GOES_OFF)


@pytest.mark.parametrize("author", sorted(authors()))
@pytest.mark.parametrize("seed", [71, 72])
def test_noise_does_not_go_off(author, seed) -> None:
    problem = make_problem([made(author, seed)])
    problem, _ = calibrate.without_outliers(problem, calibrate.base(problem))
    assert excursions(problem, calibrate.base(problem)) == []


def test_what_was_adopted_may_be_inexact(leaning) -> None:
    problem = make_problem([leaning])
    base = calibrate.base(problem)
    assert len(excursions(problem, base)) == 7
    adopted = Act("axial_elasticity", ({},), (0.0,))
    assert excursions(replace(problem, included=(adopted,)), replace(base, acts=())) == []


def test_a_spike_is_none_and_half_a_second_is_one() -> None:
    time_s = np.arange(0.0, 60.0, 0.1)
    residual = np.random.default_rng(1).normal(0.0, 0.01, len(time_s))
    residual[100:103] += 1.0
    assert far_off(residual, time_s) == []
    residual[300:310] -= 0.5
    (excursion,) = far_off(residual, time_s)
    assert excursion.at_s == pytest.approx(30.0) and excursion.lasts_s == pytest.approx(0.9)
    assert excursion.size == pytest.approx(0.5, abs=0.05)
