"""When a larger explanation stands beside the chosen one."""

from types import SimpleNamespace

import numpy as np
import pytest

from pipeline.diagnosis.compare import to_the_noise
from pipeline.diagnosis.noise import estimate

FLOOR = 1.0


def explanation(ids, left, cost):
    """What an explanation leaves in noise floors, and its cost."""
    return SimpleNamespace(ids=tuple(ids.split()), energy=FLOOR**2 + left**2, cost=cost)


@pytest.mark.parametrize(
    ("ids", "left", "cost", "stands"),
    [
        ("creep jam", 0.05, -400.0, True),  # to the noise, and likelier by far
        ("creep jam", 0.25, -400.0, False),  # leaves most of what was left
        ("creep jam", 0.05, -20.0, False),  # hardly likelier
    ],
)
def test_a_larger_explanation_stands_where_it_alone_explains_to_the_noise(ids, left, cost, stands):
    larger = explanation(ids, left, cost)
    search = SimpleNamespace(all_of=lambda size: [larger] if size == 2 else [], mismatch=lambda floor: 3.0)
    assert to_the_noise(search, explanation("creep", 0.33, 0.0), FLOOR) == [larger] * stands
    assert to_the_noise(search, explanation("x_wave", 0.33, 0.0), FLOOR) == []  # no physics: it may leave something


def test_the_noise_of_a_recording_of_a_few_hundred_samples():
    target = np.random.default_rng(0).normal(size=400)
    columns = np.array([np.ones(400), np.linspace(-1.0, 1.0, 400)])
    noise = estimate(target, columns, np.arange(400), step_s=0.05, trim=0.3)
    assert noise.floor == pytest.approx(1.0, rel=0.15)
