"""The inverse error of the model to take, which a position controller needs, and any model that is better there.

The model to take is chosen by its forward error alone (`usual_model.py`). Errors here are RMSEs on all points of a
split, `within` or `later`, by model and split: inverse ones in turns, forward ones in mm.
"""

from collections.abc import Mapping
from typing import NamedTuple

from ...ground.model_errors import LESS, Errors
from .usual_model import WHERE, is_told_apart

CALL = "A position controller asks the inverse (tsa_inverse of an export)"


class Inverse(NamedTuple):
    """Inverse errors in turns of the model to take and, where one is clearly better, of the best other model.

    `better` is empty where no other model is; `split` is the one of which the errors are.
    """

    split: str
    own_turns: float
    better: str = ""
    better_turns: float = float("nan")


def inverse_of(chosen: str, models: list[str], errors_turns: Errors) -> Inverse | None:
    """The inverse error of a chosen model and the better one among `models`; None where its error is not known."""
    split = next((split for split in WHERE if (chosen, split) in errors_turns), "")
    if not split:
        return None
    own_turns = errors_turns[chosen, split]
    others = [model for model in models if model != chosen and (model, split) in errors_turns]
    best = min(others, key=lambda model: errors_turns[model, split], default="")
    if (
        not best
        or errors_turns[best, split] * LESS > own_turns
        or not is_told_apart(errors_turns[best, split], own_turns)
    ):
        return Inverse(split, own_turns)
    return Inverse(split, own_turns, best, errors_turns[best, split])


def better(chosen: str, models: list[str], errors_turns: Errors) -> str:
    """The model that is clearly better at the inverse than the chosen one; empty if there is none."""
    inverse = inverse_of(chosen, models, errors_turns)
    return inverse.better if inverse else ""


def sentences(chosen: str, titles: Mapping[str, str], errors_turns: Errors, errors_mm: Errors) -> str:
    """The inverse error of a chosen model, which model is better there, by how much, and what that costs forward.

    `titles` are those of the models that are compared. Empty where the error is not known.
    """
    inverse = inverse_of(chosen, list(titles), errors_turns)
    if inverse is None:
        return ""
    where = WHERE[inverse.split]
    own = f"Its inverse error {where} is {inverse.own_turns:.3f} turns."
    if not inverse.better:
        return own
    against = f"{inverse.better_turns:.3f} turns against {inverse.own_turns:.3f} turns"
    words = f"{own} {CALL}: for that take the {titles[inverse.better]}, which errs less at it: {against}."
    pair = [(model, inverse.split) for model in (inverse.better, chosen)]
    if all(key in errors_mm for key in pair):
        words += f" Forward it errs by {errors_mm[pair[0]]:.3f} mm against {errors_mm[pair[1]]:.3f} mm."
    return words
