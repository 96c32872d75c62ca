"""Adaptation takes a smooth error of a new string away, the better the more of its strokes it was shown."""

import numpy as np
import pytest
from made_strings import NOISE_MM

from pipeline.models.interface import make_model
from pipeline.stages.campaign.adapt import Adaptation, terms
from pipeline.stages.campaign.few_shot import SHOTS, asked_and_shown, errors


@pytest.fixture(scope="module")
def adaptation(campaign):
    """Eq. 4 with what the strings to tune on say of its errors; what the strings add is in the terms, nearly."""
    return Adaptation(make_model("traditional"), campaign[campaign["strings"] == "tune"])


@pytest.fixture(scope="module")
def errors_by_shots(adaptation, campaign):
    """Forward and inverse errors by strokes shown, shape (strings, 2) each."""
    table = {shots: [] for shots in SHOTS}
    for asked_rows, shown in asked_and_shown(campaign):
        for shots, few in shown.items():
            table[shots].append(errors(adaptation.to(few), asked_rows))
    return {shots: np.array(rows) for shots, rows in table.items()}


def test_a_smooth_error_of_a_string_is_corrected_nearly_to_the_noise(errors_by_shots, campaign):
    before = np.array([errors(make_model("traditional"), asked_rows)[0] for asked_rows, _ in asked_and_shown(campaign)])
    assert np.median(before) > 4.0 * NOISE_MM
    assert np.median(errors_by_shots[5][:, 0]) < 1.3 * NOISE_MM
    assert (errors_by_shots[5][:, 0] < before).all()


def test_more_strokes_are_better_on_average(errors_by_shots):
    means = np.array([np.sqrt(np.mean(np.square(errors_by_shots[shots]), axis=0)) for shots in SHOTS])
    assert (means[1:3] < means[0:2]).all()
    assert (means[-1] <= 1.01 * means[1]).all() and (means[-1] < 0.5 * means[0]).all()


def test_without_a_stroke_it_is_the_mean_of_the_strings_to_tune_on(adaptation, campaign):
    new = campaign[campaign["strings"] == "test"]
    correction_mm = adaptation.to(new.iloc[:0]).forward(new) - adaptation.model.forward(new)
    assert correction_mm == pytest.approx(terms(new) @ adaptation.mean)
    fits = []
    for _, rows in campaign[campaign["strings"] == "tune"].groupby("string"):
        error_mm = rows["displacement_mm"].to_numpy() - adaptation.model.forward(rows)
        fits.append(np.linalg.lstsq(terms(rows), error_mm, rcond=None)[0])
    assert adaptation.mean == pytest.approx(np.mean(fits, axis=0))


def test_the_inverse_undoes_the_forward(adaptation, campaign):
    rows = campaign[campaign["string"] == "made-006"]
    adapted = adaptation.to(rows[rows["stroke"] <= 2])
    asked_rows = rows[(rows["stroke"] == 7) & (rows["motor_turns"] > 3.0)]
    inverse_rows = asked_rows.assign(displacement_mm=adapted.forward(asked_rows), motor_turns=np.nan)
    assert adapted.inverse(inverse_rows) == pytest.approx(asked_rows["motor_turns"].to_numpy(), abs=5e-3)


def test_the_answer_is_neither_read_forward_nor_backward(adaptation, campaign):
    rows = campaign[campaign["string"] == "made-006"]
    adapted = adaptation.to(rows[rows["stroke"] <= 2])
    forward = adapted.forward(rows.assign(displacement_mm=np.nan))
    inverse = adapted.inverse(rows.assign(motor_turns=np.nan))
    assert np.array_equal(forward, adapted.forward(rows)) and np.array_equal(inverse, adapted.inverse(rows))
    assert np.isfinite(forward).all() and np.isfinite(inverse).all()
