"""The configuration of each model, as `config/schema.yaml` checks it."""

from typing import TypedDict

from pydantic import JsonValue


class ModelPlan(TypedDict):
    """An entry of `models:`; `direction`: whether the model is told winding from unwinding; `seeds`: fits by split."""

    title: str
    direction: bool
    seeds: dict[str, int]
    settings: dict[str, JsonValue]
