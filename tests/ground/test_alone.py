"""Each of a list in a process of its own."""

import os

import pytest

from pipeline.ground.code.own_process import each_alone


def told(item: int, more: int) -> tuple[int, int]:
    """The process that works on an item, and what it gives."""
    if item == 13:
        raise ValueError("13 is unlucky")
    return os.getpid(), item + more


@pytest.mark.parametrize("jobs", [1, 2])
def test_each_item_has_a_process_of_its_own_and_the_results_keep_their_order(jobs):
    answers = list(each_alone(told, [3, 1, 2], 10, jobs=jobs))
    assert [value for _, value in answers] == [13, 11, 12]
    assert len({process for process, _ in answers} | {os.getpid()}) == 4


def test_one_item_costs_no_process():
    assert list(each_alone(told, [3], 10)) == [(os.getpid(), 13)]
    assert list(each_alone(told, [], 10)) == []


def test_an_error_of_the_work_is_raised():
    with pytest.raises(ValueError, match="unlucky"):
        list(each_alone(told, [3, 13], 10))
