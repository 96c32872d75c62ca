"""How a judge weighs: on made weights, whose scores a person can add up."""

import json

import numpy as np
import pytest

from pipeline.diagnosis.numerics import judge as judging
from pipeline.diagnosis.numerics.judge import Judge, Weighed, none_of, read, signature_table
from pipeline.ground.errors import BadInput

KNOTS = {"gain": [0.0, 2.0, 4.0], "left_share": [-4.0, 0.0]}
NAMES = ["creep", "jam"]
SIGNS = {"gain": 3.0, "left_share": -1.0, "mismatch_floors": 2.5}
HALF = 1 + 3 + 2  # columns: the size, the ramps, the names


def weighed(names, **changes):
    """An explanation and its signs."""
    return Weighed(tuple(names.split()), SIGNS | changes)


def judge_of(weights, of_none=(0.0,) * 5, **more):
    """A judge with these weights."""
    return Judge(KNOTS, NAMES, np.array(weights, float), np.array(of_none, float), **more)


def test_each_sign_climbs_between_its_knots_and_each_name_counts_by_size():
    candidates = [
        weighed("creep"),
        weighed("creep jam", gain=-9.0),
        weighed("x_wave creep jam", gain=9.0, left_share=5),
    ]
    basis = judge_of(np.zeros(4 * HALF)).basis(candidates)
    every = np.array(
        [
            [2.0, 1.0, 0.5, 0.75, 1.5, 0.0],
            [2.0, 0.0, 0.0, 0.75, 1.5, 1.5],
            [2.0, 1.0, 1.0, 1.0, 1.5, 1.5],
        ]
    )
    assert basis.shape == (3, 4 * HALF) and basis[:, :HALF] == pytest.approx(every)
    for row, own in zip(basis, every, strict=True):
        size = int(np.flatnonzero(row[HALF::HALF])[0])
        apart = np.zeros((3, HALF))
        apart[size] = 0.3 * own
        assert row[HALF:] == pytest.approx(apart.ravel())
    assert [int(np.flatnonzero(row[HALF::HALF])[0]) for row in basis] == [0, 1, 2]


def test_a_sign_that_an_explanation_lacks_is_nothing():
    (row,) = judge_of(np.zeros(4 * HALF)).basis([Weighed(("creep",), {})])
    assert row[:HALF] == pytest.approx([2.0, 0.0, 0.0, 1.0, 1.5, 0.0])


def test_columns_are_named_as_they_stand():
    columns = judge_of(np.zeros(4 * HALF)).columns
    first = ["size", "gain above 0.0", "gain above 2.0", "left_share above -4.0", "name creep", "name jam"]
    assert columns == [*first, *(f"{name}, of {size}" for size in (1, 2, 3) for name in first)]


def test_what_counts_for_one_against_another_is_told_by_sign():
    """Weights of all sizes are the same here but that of the size of pairs, and of jam in them."""
    weights = np.zeros(4 * HALF)
    weights[:HALF] = [0.5, 1.0, 4.0, 2.0, 3.0, -1.0]
    weights[2 * HALF] = 10.0
    weights[3 * HALF - 1] = 7.0
    reasons = judge_of(weights).because(weighed("creep"), weighed("creep jam", gain=1.0, left_share=-3.0))
    pairs_jam = -1.0 + 0.3 * 7.0  # in pairs; among singles it is -1
    expected = {
        "gain": 1.0 * (1.0 - 0.5) + 4.0 * 0.5,
        "left_share": 2.0 * (0.75 - 0.25),
        "names": -(-1.0 + pairs_jam) / 2.0 * 1.5,
        "size": -0.3 * 10.0 * 4.0 / 2.0 - 0.3 * 7.0 * 1.5 / 2.0,
        "alike": 0.0, "alike_else": 0.0,
    }  # fmt: skip
    assert reasons == pytest.approx(expected)


def test_a_signature_counts_for_singles_and_for_none_of_them():
    alike = {"alike": -1.0, "alike_else": -2.0, "alike_outside": -3.0}
    candidates = [weighed("creep", **alike), weighed("creep jam", **alike)]
    assert signature_table(candidates).tolist() == [[-1.0, -2.0, 1.0, 0.0, 0.0], [0.0] * 5, [0.0, 0.0, 0.0, -3.0, 1.0]]
    assert not signature_table([weighed("creep"), weighed("jam")]).any()
    assert signature_table([weighed("creep", alike_outside=-3.0)])[0].tolist() == [0.0, 0.0, 1.0, 0.0, 0.0]
    judge = judge_of(np.zeros(4 * HALF), of_signature=np.array([1.0, 10.0, 100.0, 1000.0, 5.0]))
    reasons = judge.because(*candidates)
    assert (reasons["alike"], reasons["alike_else"], reasons["size"]) == (-1.0, -20.0, 100.0)
    shares = judge_of(np.zeros(4 * HALF), of_signature=np.array([1.0, 0.5, 3.0, 0.1, 0.2])).probabilities(candidates)
    assert shares == pytest.approx(np.exp([1.0, 0.0, -0.1]) / np.exp([1.0, 0.0, -0.1]).sum())


def test_none_of_them_is_judged_by_the_best_and_by_the_best_single_one():
    candidates = [
        weighed("creep", left_share=-0.5),
        weighed("creep jam", left_share=-3.5),
        weighed("jam", left_share=-1.0),
    ]
    assert none_of(candidates).tolist() == [1.0, -3.5, -3.0, -1.0, 2.5]
    assert none_of(candidates[:1]).tolist() == [1.0, -0.5, -0.5, -0.5, 2.5]
    assert none_of(candidates[1:2]).tolist() == [1.0, -3.5, -3.0, -3.5, 2.5]


def test_probabilities_are_shares_by_scores_however_large_these_are():
    weights = np.zeros(4 * HALF)
    weights[HALF - 2 : HALF] = [2.0, 1.0]
    for offset in (0.0, 400.0):
        weights[0] = offset
        judge = judge_of(weights, (2.0 * offset + 0.5, 0.0, 0.0, 0.0, 0.2))
        scores = np.array([3.0, 1.5, 1.0])
        shares = judge.probabilities([weighed("creep"), weighed("jam")])
        assert shares == pytest.approx(np.exp(scores) / np.exp(scores).sum())


def test_a_file_of_a_judge_is_read_with_and_without_a_recogniser(tmp_path):
    content = {"knots": KNOTS, "names": NAMES, "weights": [1.0] * 24, "of_none": [1.0, 2.0, 3.0, 4.0, 5.0]}
    bare = read(content)
    assert (bare.knots, bare.names) == (KNOTS, NAMES) and bare.recogniser is None
    assert bare.weights.tolist() == [1.0] * 24 and bare.of_none.tolist() == [1.0, 2.0, 3.0, 4.0, 5.0]
    assert bare.of_signature.tolist() == [0.0] * 5
    network = {
        "numbers": ["loop"], "classes": ["creep"], "centre": [0.0], "spread": [1.0], "hidden": [[1.0, 0.0]],
        "output": [[1.0, 0.0]],
    }  # fmt: skip
    both = read({**content, "recogniser": network, "of_signature": [1, 2, 3, 4, 5]})
    assert both.recogniser.classes == ["creep"] and both.of_signature.tolist() == [1.0, 2.0, 3.0, 4.0, 5.0]
    path = tmp_path / "judge.json"
    path.write_text(json.dumps(content))
    assert judging.judge(path).names == NAMES and judging.judge(path) is judging.judge(path)


@pytest.mark.parametrize("text", ["{", "[]", '{"knots": {}}', None])
def test_a_file_that_holds_no_judge_is_refused_with_the_mend(tmp_path, text):
    path = tmp_path / "judge.json"
    if text is not None:
        path.write_text(text)
    with pytest.raises(BadInput, match=r"--judge: is no judge: .*Mend: give a file that .*proof\.teach"):
        judging.judge(path)
