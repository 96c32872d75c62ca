"""The library's twins: what they leave of the rig's own effects, and that a stranger leaves more."""

import sys

import numpy as np
import pandas as pd
import pytest
from first_few import first_few

from pipeline.proof import twins
from pipeline.proof.case import draw_case
from pipeline.proof.size import rms


@pytest.mark.parametrize("effect", first_few(["creep", "friction_hysteresis", "stiffening", "viscous_loss"], 2))
def test_a_twin_leaves_part_of_the_rigs_effect_and_explains_the_rest(effect):
    row = twins.twin(effect, 1, "rich", 1.0)
    assert twins.LEAST <= row["share"] < 0.2


def test_the_problem_of_a_twin_is_the_effect_and_nothing_else():
    problem, does_mm = twins.noise_free(draw_case(1, "single", "rich", ["creep"], [1.0]))
    left_mm = problem.measured - problem.simulate(problem.nominal())
    np.testing.assert_allclose(left_mm - left_mm.mean(), does_mm - does_mm.mean(), atol=1e-3 * rms(does_mm))
    assert problem.movable == []


def test_a_stranger_leaves_more_than_the_twin():
    problem, does_mm = twins.noise_free(draw_case(1, "single", "rich", ["viscous_loss"], [1.0]))
    own, other = twins.unexplained_mm(problem, "viscous_loss"), twins.unexplained_mm(problem, "sensor_drift")
    assert own < 0.2 * does_mm.std() < 0.8 * does_mm.std() < other


def test_the_summary_says_which_twin_is_too_alike():
    rows = [("creep", 1, "rich", 0.1, 0.2), ("creep", 2, "rich", 0.1, 0.1), ("jam", 1, "rich", 0.1, 0.01)]
    creep, jam = twins.summary(pd.DataFrame(rows, columns=twins.COLUMNS))
    assert "15.00%" in creep and "10.00%" in creep and "too alike" not in creep
    assert "too alike" in jam


def test_the_command_writes_the_table(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(twins, "SEEDS", 1)
    monkeypatch.setattr(sys, "argv", ["twins", "--effect", "sensor_drift", "--out", str(tmp_path / "twins.csv")])
    with pytest.raises(SystemExit) as exit_info:
        twins.main()
    assert not exit_info.value.code
    table = pd.read_csv(tmp_path / "twins.csv")
    assert list(table.columns) == ["effect", "seed", "protocol", "raw_mm", "share"]
    assert list(table["effect"]) == ["sensor_drift"] and "sensor_drift" in capsys.readouterr().out
