"""Which mechanism's mismatches a signature looks like: a small network, taught on other people's laws.

It sees numbers of the mismatch alone and knows no law. A judge weighs what it says beside what each explanation
leaves. One class more, `outside`, is what the library does not have.

Source: Bishop, Neural Networks for Pattern Recognition, 1995 (chapters 4 and 6: one hidden layer, softmax).
"""

from dataclasses import dataclass
from typing import TypedDict

import numpy as np

from ...ground.kinematics import Array
from ...ground.outside_library import is_outside

OUTSIDE = "outside"  # the class of effects that no mechanism of the library has
DOUBT = 0.01  # least probability of each class, however unlike the signature is
OF_EXPLANATION = ("alike", "alike_else")  # signs of one explanation
OF_ALL = "alike_outside"  # the sign that all explanations of a recording share


class Content(TypedDict):
    """A recogniser as a judge's file holds it: the fields of `Recogniser`, arrays as lists."""

    numbers: list[str]
    classes: list[str]
    centre: list[float]
    spread: list[float]
    hidden: list[list[float]]
    output: list[list[float]]


@dataclass(frozen=True)
class Recogniser:
    """Names of the signature's numbers and of the classes, and a network with one layer of rectified units."""

    numbers: list[str]
    classes: list[str]
    centre: Array  # (numbers,), each in its number's unit
    spread: Array  # (numbers,), each in its number's unit
    hidden: Array  # (units, numbers + 1), without a unit; the last column is the bias
    output: Array  # (classes, units + 1), without a unit; the last column is the bias

    def likenesses(self, signature: dict[str, float]) -> dict[str, float]:
        """The probability of each class for the signature, shares of 1 by name; a missing number counts as 0."""
        values = np.array([signature.get(name, 0.0) for name in self.numbers])
        units = np.maximum(self.hidden @ np.append((values - self.centre) / self.spread, 1.0), 0.0)
        scores = self.output @ np.append(units, 1.0)
        odds = np.exp(scores - scores.max())
        return dict(zip(self.classes, (odds / odds.sum()).tolist(), strict=True))


def signs(likeness_by_class: dict[str, float], ids: tuple[str, ...]) -> dict[str, float]:
    """The signs that a signature gives an explanation by one effect: logarithms of shares; none for larger ones.

    `alike`: that effect; `alike_else`: the likeliest other one; `alike_outside`: none of the library, of all
    explanations alike. No signs where nothing was recognised.
    """
    if not likeness_by_class:
        return {}
    outside = {OF_ALL: float(np.log(likeness_by_class.get(OUTSIDE, 0.0) + DOUBT))}
    if len(ids) != 1:
        return dict.fromkeys(OF_EXPLANATION, 0.0) | outside
    name = OUTSIDE if is_outside(ids[0]) else ids[0]
    others = [share for other, share in likeness_by_class.items() if other not in (name, OUTSIDE)]
    named, other = likeness_by_class.get(name, 0.0), max(others, default=0.0)
    return {"alike": float(np.log(named + DOUBT)), "alike_else": float(np.log(other + DOUBT))} | outside


def read(content: Content) -> Recogniser:
    """A recogniser from the content of a judge's file; raises KeyError, TypeError or ValueError for a wrong one."""
    centre, spread = np.array(content["centre"], float), np.array(content["spread"], float)
    hidden, output = np.array(content["hidden"], float), np.array(content["output"], float)
    return Recogniser(content["numbers"], content["classes"], centre, spread, hidden, output)


def written(recogniser: Recogniser) -> Content:
    """A recogniser as the content of a judge's file, its numbers with four digits."""
    centre, spread, hidden, output = (
        np.array([float(f"{value:.4g}") for value in layer.flat]).reshape(layer.shape).tolist()
        for layer in (recogniser.centre, recogniser.spread, recogniser.hidden, recogniser.output)
    )
    return Content(
        numbers=recogniser.numbers, classes=recogniser.classes,
        centre=centre, spread=spread, hidden=hidden, output=output,
    )  # fmt: skip
