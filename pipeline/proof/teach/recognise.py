"""Signatures of concealed cases → a recogniser: a network that tells which mechanism made a mismatch.

Source: Bishop, Neural Networks for Pattern Recognition, 1995 (one hidden layer, softmax, weight decay).
"""

import warnings

import numpy as np
from sklearn.exceptions import ConvergenceWarning
from sklearn.neural_network import MLPClassifier

from ...diagnosis.numerics.recogniser import OUTSIDE, Recogniser
from ...ground.outside_library import is_outside
from .lesson import Lesson

UNITS, DECAY, PASSES = 48, 3.0, 200  # of the network: rectified units, weight decay, passes over all lessons


def classes(lesson: Lesson) -> list[str]:
    """The class of a lesson's signature: each hidden effect, or `outside`."""
    return [OUTSIDE if is_outside(name) else name for name in lesson.effects]


def taught(lessons: list[Lesson]) -> Recogniser | None:
    """The recogniser of the lessons' signatures; where two effects were hidden, each counts as half right."""
    seen = [lesson for lesson in lessons if lesson.signature]
    if len({name for lesson in seen for name in classes(lesson)}) < 2:
        return None
    numbers = sorted(seen[0].signature)
    rows = [[lesson.signature[name] for name in numbers] for lesson in seen for _ in classes(lesson)]
    table, right = np.array(rows), np.array([name for lesson in seen for name in classes(lesson)])
    centre, spread = table.mean(axis=0), np.maximum(table.std(axis=0), 1e-6)
    network = MLPClassifier((UNITS,), alpha=DECAY, max_iter=PASSES, random_state=0)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)  # the passes are as many as help strangers
        network.fit((table - centre) / spread, right)
    layers = [
        np.column_stack([weights.T, bias]) for weights, bias in zip(network.coefs_, network.intercepts_, strict=True)
    ]
    return Recogniser(numbers, [str(name) for name in network.classes_], centre, spread, *layers)
