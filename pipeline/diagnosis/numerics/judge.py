"""How likely each explanation is: a conditional logit on its signs and names, learnt on other people's laws.

The score of an explanation is a sum: a piecewise linear function of each sign, a number for each name, and small
deviations of both for singles, pairs and triples. To those of singles and of "none of them" a share is added of what
the signature of the mismatch looks like. All scores share one softmax. `judge.json` holds the weights;
`python -m pipeline.proof.teach` makes it.

Source: McFadden, "Conditional logit analysis of qualitative choice behavior", in Zarembka, Frontiers in Econometrics,
1974.
"""

import json
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import NotRequired, TypedDict

import numpy as np

from ...ground.command import command
from ...ground.errors import BadInput
from ...ground.kinematics import Array
from .recogniser import OF_ALL, OF_EXPLANATION, Recogniser
from .recogniser import Content as RecogniserJson
from .recogniser import read as recogniser_of

HERE = Path(__file__).parent
SIZES = (1, 2, 3)  # mechanisms in an explanation
BY_SIZE, BY_NAME = 2.0, 1.5  # how freely the number of mechanisms and each name may weigh, beside a ramp's 1
OF_SIGNATURE = (*OF_EXPLANATION, "size", OF_ALL, "none")  # what is weighed of it: of singles, and of "none of them"
APART = 0.3  # how freely singles, pairs and triples may be weighed otherwise than all of them


@dataclass(frozen=True)
class Weighed:
    """What an explanation names, and its signs by name."""

    ids: tuple[str, ...]
    signs: dict[str, float]


class JudgeJson(TypedDict):
    """What a judge's file holds: knots of every sign, and weights, as `Judge` has them; each without a unit."""

    knots: dict[str, list[float]]
    names: list[str]
    weights: list[float]
    of_none: list[float]
    of_signature: NotRequired[list[float]]
    recogniser: NotRequired[RecogniserJson]


@dataclass(frozen=True)
class Judge:
    """Knots of every sign, and weights: of the ramps between knots and of the names, both by size, and of none."""

    knots: dict[str, list[float]]
    names: list[str]
    weights: Array  # (weights,), without a unit: what each column of `basis` counts
    of_none: Array  # (weights of none,), without a unit: what each of `none_of` counts
    recogniser: Recogniser | None = None  # what says which effect a signature looks like
    of_signature: Array = field(default_factory=lambda: np.zeros(len(OF_SIGNATURE)))  # (5,), without a unit

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
        named = [BY_NAME * np.array([float(name in candidate.ids) for candidate in weighed]) for name in self.names]
        sizes = np.array([len(candidate.ids) for candidate in weighed])
        every = np.column_stack([BY_SIZE * np.ones(len(weighed)), *ramps, *named])
        apart = np.hstack([every * (sizes == size)[:, None] for size in SIZES])
        return np.hstack([every, APART * apart])

    @property
    def columns(self) -> list[str]:
        """What each column of `basis` stands for: the size, a sign above a knot, a name; and each of these by size."""
        ramps = [f"{sign} above {low}" for sign, knots in self.knots.items() for low in knots[:-1]]
        every = ["size", *ramps, *(f"name {name}" for name in self.names)]
        return [*every, *(f"{column}, of {size}" for size in SIZES for column in every)]

    def because(self, candidate: Weighed, other: Weighed) -> dict[str, float]:
        """What each sign, the `names` and the `size` add to the log of the odds of `candidate` against `other`.

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
        first_parts, second_parts, _ = signature_table([candidate, other]) * self.of_signature
        for name, part in zip((*OF_EXPLANATION, "size"), first_parts - second_parts, strict=False):
            lead_by_sign[name] = lead_by_sign.get(name, 0.0) + float(part)
        return lead_by_sign | {"names": float(parts[at:].sum())}

    def probabilities(self, weighed: list[Weighed]) -> Array:
        """The probability of each explanation and, last, of none of them. Shape (explanations + 1,), shares of 1."""
        scores = np.append(self.basis(weighed) @ self.weights, none_of(weighed) @ self.of_none)
        scores = scores + signature_table(weighed) @ self.of_signature
        odds = np.exp(scores - scores.max())
        return np.asarray(odds / odds.sum())


def none_of(weighed: list[Weighed]) -> Array:
    """The signs of "none of them": the residual of the best, the best single one, and the size of the mismatch.

    Shape (weights,), each without a unit.
    """
    singles = [candidate for candidate in weighed if len(candidate.ids) == 1]
    best = min(candidate.signs["left_share"] for candidate in weighed)
    return np.array([1.0, best, max(best, -3.0), min(candidate.signs["left_share"] for candidate in singles or weighed),
                     weighed[0].signs["mismatch_floors"]])  # fmt: skip


def signature_table(weighed: list[Weighed]) -> Array:
    """The signs from the signature for each explanation and, last, for none; zeros where nothing was recognised.

    Shape (explanations + 1, 5), each without a unit: logarithms of shares, and ones.
    """
    table = np.zeros((len(weighed) + 1, len(OF_SIGNATURE)))
    if OF_ALL not in weighed[0].signs:
        return table
    for row, candidate in zip(table, weighed, strict=False):
        if len(candidate.ids) == 1:
            row[:3] = [*(candidate.signs.get(name, 0.0) for name in OF_EXPLANATION), 1.0]
    table[-1, 3:] = weighed[0].signs[OF_ALL], 1.0
    return table


def read(content: JudgeJson) -> Judge:
    """A judge from the content of its file."""
    judge = Judge(content["knots"], content["names"], np.array(content["weights"]), np.array(content["of_none"]))
    if "recogniser" not in content:
        return judge
    recogniser = recogniser_of(content["recogniser"])
    return replace(judge, recogniser=recogniser, of_signature=np.array(content["of_signature"], float))


@cache
def judge(path: Path = HERE / "judge.json") -> Judge:
    """The judge of the library, or one from another file; raises BadInput for a file that holds no judge."""
    try:
        return read(json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError, KeyError, TypeError) as error:
        mend = f"give a file that `{command('proof.teach')}` wrote"
        raise BadInput(path, "--judge", f"is no judge: {error}", mend) from None
