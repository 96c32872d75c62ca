"""The box is where the energy is."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pipeline.diagnosis.fit import locate
from pipeline.diagnosis.recording.covered import pauses
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.verdict import diagnosis
from pipeline.diagnosis.words.pages.details import details_text


def test_box_of_a_patch(problem) -> None:
    drivers = problem.drivers
    top = drivers.motion.max()
    inside = (drivers.motion > 0.6 * top) & (drivers.stroke >= 4) & (drivers.stroke <= 9) & (drivers.phase == 0)
    box = locate.box(np.where(inside, 1.0, 0.02), problem)
    assert box["phase"] == "winding" and box["share"] >= 0.8
    assert box["strokes"][0] >= 4 and box["strokes"][1] <= 9
    assert box["motor_turns"][0] >= 0.55 * top


def test_a_named_mechanism_that_refining_took_back_is_nowhere_and_stops_nothing(studied) -> None:
    outcome, run, samples = studied("creep")
    silent = tuple(replace(act, coefficients=(0.0,) * len(act.coefficients)) for act in outcome.best.acts)
    outcome = replace(outcome, best=replace(outcome.best, acts=silent), state=replace(outcome.state, acts=silent))
    content = diagnosis(outcome, outcome.problem, None, [run], None, frozenset())
    (entry,) = content["mechanisms"]
    assert entry["location"]["share"] == 0.0 and entry["rms_mm"]["value"] == 0.0
    assert "a strength of 0" in entry["sentence"] and content["simulation"] == []
    content["evidence"]["covered"] |= pauses([RecordedRun.cut(run, samples)])
    assert "The search's first fit" in " ".join(
        details_text(content, outcome.problem.system, [Path("raw/run-0")]).split()
    )


@pytest.mark.parametrize("signal", [0.0, np.nan])
def test_the_box_of_nothing_is_the_whole_recording(problem, signal) -> None:
    box = locate.box(np.full(len(problem.record), signal), problem)
    top = [float(problem.drivers.motion.min()), float(problem.drivers.motion.max())]
    assert box["share"] == 0.0 and box["phase"] == "all" and box["motor_turns"] == top
