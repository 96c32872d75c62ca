"""The words on the model to take, for the end of the main job and for a material's page: which, why, for what."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from ...ground.model_errors import chosen_of, errors_in, floor_in, has_apart
from . import inverse_beside
from .usual_model import why

NOT_DECIDED = (
    "Some of its later strokes were recorded under a load or to a twist that few learnt strokes have, so they do not "
    "decide."
)


class Advice(NamedTuple):
    """The `model` to take, the reason, and its inverse error; each is empty where it is not known.

    `controllers` are the models to export, by the kind of controller.
    """

    model: str
    reason: str
    at_inverse: str
    controllers: dict[str, str]


def advice_on(models: Sequence[str], models_csv: Path) -> Advice:
    """Which of some models to take by the errors of a models.csv, which need not be there."""
    errors_mm, errors_turns = errors_in(models_csv), errors_in(models_csv, "inverse")
    chosen = chosen_of(models, errors_mm)
    at_inverse = inverse_beside.sentences(chosen, {model: model for model in models}, errors_turns, errors_mm)
    wanted = {
        "a controller": chosen,
        "a position controller": inverse_beside.better(chosen, list(models), errors_turns),
    }
    controllers = {where: model for where, model in wanted.items() if model}
    reason = why(chosen, models, errors_mm, floor_in(models_csv))
    if reason and has_apart(models_csv):
        reason = f"{reason} {NOT_DECIDED}"
    return Advice(chosen, reason, at_inverse, controllers)
