"""How likely each explanation is: a conditional logit on its signs and names, learnt on other people's laws.

The score of an explanation is a sum: a piecewise linear function of each sign, a number for each name, a share of what
the signature says, and small deviations of all these for singles, pairs and triples. The scores of all explanations and
of "none of them" share one softmax. `judge.json` holds the weights; `python -m pipeline.proof.teach` makes it.

Source: McFadden, "Conditional logit analysis of qualitative choice behavior", in Zarembka, Frontiers in Econometrics,
1974.
"""

import json
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from ...ground.command import command
from ...ground.errors import BadInput
from ...ground.kinematics import Array
from .recogniser import OF_ALL, OF_EXPLANATION, Recogniser
from .recogniser import read as recogniser_of

HERE = Path(__file__).parent
SIZES = (1, 2, 3)  # mechanisms in an explanation
BY_SIZE, BY_NAME = 2.0, 1.5  # how freely the number of mechanisms and each name may weigh, beside a ramp's 1
BY_SIGNATURE = 3.0  # the same of what a signature says: it is a logarithm of odds already, and weighs in proportion
APART = 0.3  # how freely singles, pairs and triples may be weighed otherwise than all of them


@dataclass(frozen=True)
class Weighed:
    """What an explanation names, and its signs by name."""

    ids: tuple[str, ...]
    signs: dict[str, float]


@dataclass(frozen=True)
class Judge:
    """Knots of every sign, and weights: of the ramps between knots and of the names, both by size, and of none."""

    knots: dict[str, list[float]]
    names: list[str]
    weights: Array  # (weights,), without a unit: what each column of `basis` counts
    of_none: Array  # (weights of none,), without a unit: what each of `none_of` counts
    recogniser: Recogniser | None = None  # what says which mechanisms a signature looks like

    @property
    def straight(self) -> tuple[str, ...]:
        """Signs that weigh in proportion too: those of the signature, where there is a recogniser."""
        return OF_EXPLANATION if self.recogniser else ()

    def basis(self, weighed: list[Weighed]) -> Array:
        """What the weights multiply, shape (explanations, weights). Each without a unit."""
        signs = {
            name: np.array([candidate.signs.get(name, 0.0) for candidate in weighed]) for name in self.knots
        }  # 0: no such mark
        ramps = [
            np.clip((signs[name] - low) / (high - low), 0.0, 1.0)
            for name, knots in self.knots.items()
            for low, high in pairwise(knots)
        ]
        alike = [
            BY_SIGNATURE * np.array([candidate.signs.get(name, 0.0) for candidate in weighed]) for name in self.straight
        ]
        named = [BY_NAME * np.array([float(name in candidate.ids) for candidate in weighed]) for name in self.names]
        sizes = np.array([len(candidate.ids) for candidate in weighed])
        every = np.column_stack([BY_SIZE * np.ones(len(weighed)), *ramps, *alike, *named])
        apart = np.hstack([every * (sizes == size)[:, None] for size in SIZES])
        return np.hstack([every, APART * apart])

    def because(self, candidate: Weighed, other: Weighed) -> dict[str, float]:
        """What each sign, the `names` and the `size` add to the log of how much likelier `candidate` is than `other`.

        The parts add up to all of it. A sign counts by the mean of its weights in explanations of either size; what
        is due to the sizes alone counts under `size`.
        """
        first, second = self.basis([candidate, other])
        half = len(self.weights) // (1 + len(SIZES))
        weights = self.weights[:half] + APART * np.array(
            [self.weights[half * len(each.ids) : half * (1 + len(each.ids))] for each in (candidate, other)]
        )
        mean, apart = weights.mean(axis=0), weights[0] - weights[1]
        parts = mean * (first - second)[:half]
        lead_by_sign = {"size": float(parts[0] + apart @ (first + second)[:half] / 2.0)}
        at = 1
        for name, knots in self.knots.items():
            lead_by_sign[name], at = float(parts[at : at + len(knots) - 1].sum()), at + len(knots) - 1
        for name in self.straight:
            lead_by_sign[name], at = lead_by_sign.get(name, 0.0) + float(parts[at]), at + 1
        return lead_by_sign | {"names": float(parts[at:].sum())}

    def probabilities(self, weighed: list[Weighed]) -> Array:
        """Of each explanation, and, last, of none of them. Shape (explanations + 1,), shares of 1."""
        scores = np.append(self.basis(weighed) @ self.weights, none_of(weighed) @ self.of_none)
        odds = np.exp(scores - scores.max())
        return np.asarray(odds / odds.sum())


def none_of(weighed: list[Weighed]) -> Array:
    """What tells that none is one: what the best leaves, and the best single, how large the mismatch is, its signature.

    Shape (weights,), each without a unit.
    """
    singles = [candidate for candidate in weighed if len(candidate.ids) == 1]
    best = min(candidate.signs["left_share"] for candidate in weighed)
    return np.array([1.0, best, max(best, -3.0), min(candidate.signs["left_share"] for candidate in singles or weighed),
                     weighed[0].signs["mismatch_floors"], weighed[0].signs.get(OF_ALL, 0.0)])  # fmt: skip


def read(content: dict[str, Any]) -> Judge:
    """A judge from the content of its file."""
    recogniser = recogniser_of(content["recogniser"]) if "recogniser" in content else None
    weights, of_none = np.array(content["weights"]), np.array(content["of_none"])
    return Judge(content["knots"], content["names"], weights, of_none, recogniser)


@cache
def judge(path: Path = HERE / "judge.json") -> Judge:
    """The judge that is part of the library, or another one's file; raises BadInput for a file that is none."""
    try:
        return read(json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError, KeyError, TypeError) as error:
        mend = f"give a file that `{command('proof.teach')}` wrote"
        raise BadInput(path, "--judge", f"is no judge: {error}", mend) from None
