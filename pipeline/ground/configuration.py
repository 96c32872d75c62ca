"""The configuration of each model, as `config/schema.yaml` checks it."""

from collections.abc import Mapping
from copy import deepcopy
from typing import TypedDict

from pydantic import JsonValue


class ModelPlan(TypedDict):
    """An entry of `models:`; `direction`: whether the model is told winding from unwinding; `seeds`: fits by split."""

    title: str
    direction: bool
    seeds: dict[str, int]
    settings: dict[str, JsonValue]


# what an entry need not say: a model that is not told the direction, fitted once on each split, with its own settings
USUAL: Mapping[str, JsonValue] = {"direction": False, "seeds": {"within": 1, "later": 1}, "settings": {}}


def complete(models: Mapping[str, ModelPlan]) -> None:
    """Add to each entry of `models:` what it leaves out."""
    for plan in models.values():
        for key, value in USUAL.items():
            plan.setdefault(key, deepcopy(value))  # type: ignore[misc]
