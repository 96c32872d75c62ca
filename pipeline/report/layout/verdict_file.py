"""A diagnosis.json as the pages take it: of the form that they read, and not damaged."""

from pathlib import Path
from typing import Annotated, Any, Literal, cast

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from ...ground.command import REMAKE
from ...ground.errors import BadInput
from ...ground.stored.checked_json import read_checked
from .verdict_content import Content

NAME = "diagnosis.json"
FLOOR = "noise_floor_"  # before the reading's unit
Number = Annotated[float, Field(allow_inf_nan=False)]


class _Form(BaseModel):
    model_config = ConfigDict(strict=True)


class _Named(_Form):
    id: str


class _Evidence(_Form):
    chosen_without_them: list[str] | None = None
    closest_without_them: list[str] = []


class _Fit(_Form):
    heldout: dict[str, Any] | None = None
    worse_than_nominal: list[str] = []


class _Diagnosis(_Form):
    verdict: Literal["consistent", "parameters", "explained", "ambiguous", "unknown"]
    mechanisms: list[_Named]
    alternatives: list[list[str]]
    mismatch: dict[str, Any] | None
    evidence: _Evidence = _Evidence()
    fit: _Fit
    next_experiment: str | None = None


class _Sizes(_Form):
    """Sizes whose keys end in the reading's unit, here without it."""

    noise_floor: Number
    rms: Number | None = None
    nominal: Number | None = None
    calibrated: Number | None = None
    explained: Number | None = None


def read_verdict(path: Path, mend: str = REMAKE) -> Content:
    """What a diagnosis wrote; raises BadInput for a file that is damaged, or holds what no diagnosis gives."""
    content = read_checked(path, mend)
    try:
        _Diagnosis.model_validate(content)
        fit: dict[str, Any] = content["fit"]
        unit = next((key.removeprefix(FLOOR) for key in fit if key.startswith(FLOOR)), "")
        sizes = {**(content["mismatch"] or {}), **(fit.get("heldout") or {}), **fit}
        _Sizes.model_validate({name: sizes[key] for name in _Sizes.model_fields if (key := f"{name}_{unit}") in sizes})
    except ValidationError as error:
        field = ".".join(map(str, error.errors()[0]["loc"])) or "content"
        raise BadInput(path, field, "is damaged: it is not what a diagnosis gives", mend) from None
    return cast(Content, content)


def damage(path: Path) -> str:
    """What is wrong with a diagnosis.json; empty where nothing is."""
    try:
        read_verdict(path)
    except BadInput as error:
        return f"{error.field}: {error.problem}"
    return ""
