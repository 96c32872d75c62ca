"""Of tied explanations, the smallest that predicts about as well as the best stands first."""

from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.choice import cross_validation
from pipeline.diagnosis.numerics.noise import white
from pipeline.diagnosis.recording.recorded_run import RecordedRun
from pipeline.diagnosis.study.engine import make_problem, study
from pipeline.rig.others import cases
from pipeline.rig.others.made import write_run
from pipeline.run.samples import read_samples


def sets(*names):
    """Explanations by their ids."""
    return [SimpleNamespace(ids=tuple(name.split())) for name in names]


@pytest.mark.parametrize(
    ("errors", "first"),
    [
        ([1.0, 1.3, 2.0], "creep jam"),  # a third worse at most is as well, and smaller
        ([1.0, 1.5, 2.0], "creep jam wear"),
        ([1.0, 1.2, 1.1], "thermal"),
        ([2.0, 2.6, 4.0], "creep jam"),
        ([0.1, 0.15, 0.2], "creep jam wear"),
    ],
)
def test_the_smallest_that_foresees_as_well_stands_first_and_the_rest_stay(monkeypatch, errors, first):
    tied = sets("creep jam wear", "creep jam", "thermal")
    monkeypatch.setattr(cross_validation, "left_out_errors", lambda linear, sets: errors)
    ordered = [" ".join(explanation.ids) for explanation in cross_validation.by_prediction(None, tied)]
    assert ordered == [
        first,
        *(" ".join(explanation.ids) for explanation in tied if " ".join(explanation.ids) != first),
    ]


def test_one_explanation_needs_no_left_out_stretches(monkeypatch):
    monkeypatch.setattr(cross_validation, "left_out_errors", None)
    assert cross_validation.by_prediction(None, sets("creep")) == sets("creep")
    assert cross_validation.by_prediction(None, []) == []


def test_of_two_as_small_the_one_that_foresees_better_stands_first(monkeypatch):
    monkeypatch.setattr(cross_validation, "left_out_errors", lambda linear, sets: [1.2, 1.1, 1.34, 1.0])
    ordered = cross_validation.by_prediction(None, sets("creep jam", "wear jam", "slack", "creep wear"))
    assert [" ".join(explanation.ids) for explanation in ordered] == ["slack", "creep jam", "wear jam", "creep wear"]


ROWS = 1003  # no five stretches of them are alike


def linear_of(columns, target, prior=0.0, most=np.inf):
    """A linearisation of columns, shape (columns, rows), each with one prior; coefficients are at most `most`."""
    count = len(columns)
    return SimpleNamespace(
        table=np.vstack([columns, target]), rows=ROWS, noise=white(0.5), begin=np.zeros(count),
        gram=(columns @ columns.T) / 0.25 + prior * np.eye(count), low=np.full(count, -most), high=np.full(count, most),
        problem=SimpleNamespace(drivers=SimpleNamespace(first=np.zeros(ROWS, bool))),
    )  # fmt: skip


def left_out(columns, target, prior=0.0):
    """The error on stretches left out, by the normal equations of the rows that stay."""
    parts = np.array_split(np.arange(ROWS), 5)
    squares = []
    for rows in [*parts, np.concatenate(parts[3:])]:
        stays = np.setdiff1d(np.arange(ROWS), rows)
        gram = columns[:, stays] @ columns[:, stays].T / 0.25 + prior * np.eye(len(columns))
        solution = np.linalg.solve(gram, columns[:, stays] @ target[stays] / 0.25)
        squares.append(np.square(target[rows] - solution @ columns[:, rows]))
    return float(np.sqrt(np.mean(np.concatenate(squares))))


@pytest.mark.parametrize("prior", [0.0, 300.0])
def test_each_stretch_and_the_last_two_together_are_foretold_by_the_others(prior):
    """The columns of one explanation may stand anywhere in the table; a prior holds in each fit."""
    draw = np.random.default_rng(5)
    columns = draw.standard_normal((3, ROWS)) * np.linspace(0.5, 2.0, ROWS)
    target = 2.0 * columns[0] - columns[2] * np.linspace(0.0, 3.0, ROWS) + draw.standard_normal(ROWS)
    linear = linear_of(columns, target, prior)
    explanations = [SimpleNamespace(fit=SimpleNamespace(columns=np.array(own))) for own in ([2, 0], [1], [0, 1, 2])]
    expected = [left_out(columns[explanation.fit.columns], target, prior) for explanation in explanations]
    assert cross_validation.left_out_errors(linear, explanations) == pytest.approx(expected, rel=1e-6)


def test_bounds_hold_where_stretches_are_left_out():
    column = np.ones((1, ROWS))
    explanation = SimpleNamespace(fit=SimpleNamespace(columns=np.array([0])))
    (error,) = cross_validation.left_out_errors(linear_of(column, 3.0 * column[0], most=1.0), [explanation])
    assert error == pytest.approx(2.0)


def test_true_mechanisms_predict_left_out_stretches_and_others_do_not(tmp_path):
    write_run(cases.make("mass-two", 312), tmp_path / "a-01")
    run, samples = read_samples(tmp_path / "a-01")
    search = study(make_problem([RecordedRun.cut(run, samples)])).search
    both = search.explain(("friction_hysteresis", "viscous_loss"))
    tried = [both, search.explain(("sensor_drift",)), search.nothing]
    true, false, nothing = cross_validation.left_out_errors(search.linear, tried)
    assert true < 0.3 * false and true < 0.3 * nothing
