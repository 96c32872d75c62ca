"""What a recording may decide is judged by what was measured to move, and by a floor that counts no structure."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pipeline.diagnosis.faint_recordings import refuse_faint, unforeseen
from pipeline.diagnosis.study.engine import study
from pipeline.ground.errors import BadInput


@pytest.fixture
def plain_study(problem):
    """The study of a recording with nothing concealed in it."""
    return study(problem)


def test_a_reading_that_is_noise_is_refused_with_both_sizes(plain_study):
    noise = 9.0 * np.random.default_rng(0).standard_normal(len(plain_study.problem.measured))
    loud = replace(plain_study.problem, measured=plain_study.problem.measured + noise)
    with pytest.raises(BadInput, match=r"moves by 6[0-9] mm and has a noise of [89]"):
        refuse_faint(replace(plain_study, problem=loud, floor=9.0), Path("run"))


def test_structure_that_a_regression_foretells_is_no_noise(plain_study):
    problem = plain_study.problem
    swing = 0.1 * np.ptp(problem.measured) * np.sin(2.0 * np.pi * problem.drivers.motion / problem.drivers.span)
    bent = replace(problem, measured=problem.measured + swing)
    floor = float(np.std(swing))  # as an engine says that has no physics for it
    assert 20.0 * floor > np.ptp(bent.measured)
    assert unforeseen(bent, plain_study.base) < 0.2 * floor
    refuse_faint(replace(plain_study, problem=bent, floor=floor), Path("run"))


def test_what_was_measured_to_move_counts_and_not_only_what_should_have_moved(plain_study):
    small = replace(
        plain_study, nominal=replace(plain_study.nominal, values=0.02 * plain_study.nominal.values), floor=0.05
    )
    still = replace(small.problem, measured=np.zeros_like(small.problem.measured))
    refuse_faint(small, Path("run"))
    noisy = 0.05 * np.random.default_rng(1).standard_normal(len(still.measured))
    with pytest.raises(BadInput, match="nothing can be told"):
        refuse_faint(replace(small, problem=replace(still, measured=noisy)), Path("run"))
