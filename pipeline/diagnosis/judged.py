"""Probabilities of explanations → the sets that a verdict holds: together they have the truth as often as is asked."""

import numpy as np

from pipeline.kinematics import Array

ASKED = 0.9  # how often the sets shall hold the truth, where something of the library is at work
UNKNOWN = 0.5  # of the probability: "none of them" with more makes the verdict


def held(probabilities: Array) -> list[int]:
    """Places of the explanations that are held, the likeliest first; none where "none of them", the last, is likelier."""
    *named, none = probabilities.tolist()
    if none >= UNKNOWN:
        return []
    order = np.argsort(-np.array(named), kind="stable")
    reached = np.cumsum(np.array(named)[order]) / max(sum(named), 1e-300)
    return [int(place) for place in order[: int(np.argmax(reached >= ASKED)) + 1]]
