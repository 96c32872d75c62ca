"""The files of a step, read back in the form in which the loop wrote them, or refused by their field."""

from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, RootModel, ValidationError, model_validator

from ..ground.errors import BadInput
from ..ground.input.complaint import short
from ..ground.stored.checked_json import read_checked

ANEW = "restore it, or begin anew: name another --out, and every run that is recorded so far"
Number = Annotated[float, Field(allow_inf_nan=False)]


class _Form(BaseModel):
    model_config = ConfigDict(strict=True)


class _Leg(_Form):
    seconds: Number
    motor_turns: Number
    load_n: Number | None = None


class _Pair(_Form):
    ids: list[list[str]]
    gap_now: float
    gap_then: float


class _Curves(_Form):
    time_s: list[float]
    motor_turns: list[float]
    load: list[float]
    calibrated: list[float]
    rivals: dict[str, list[float]]


class _Run(_Form):
    """A run that is proposed; step 0 has no legs where runs were there, or where a person makes the first one."""

    title: str = ""
    legs: list[_Leg] = []
    begins_turns: Number = Field(0.0, alias="from")
    runs: list[str] = []
    load: Number | None = None
    parts: list[list[str]] = []
    pairs: list[_Pair] = []
    limits: dict[str, float | list[float]] = {}
    turns_per_s2: Number = 0.0


class Proposed(_Run):
    """A run with what is foretold of it; without legs nothing is."""

    curves: _Curves | None = None

    @model_validator(mode="after")
    def _has_curves(self) -> "Proposed":
        if self.legs and self.curves is None:
            raise ValueError("no curves are there")
        return self


class _Option(_Run):
    title: str
    legs: list[_Leg]
    gap_now: float
    gap_then: float
    curves: _Curves


class Options(RootModel[list[_Option]]):
    """Runs that could be made."""


def _nothing() -> _Run:
    return _Run.model_validate({})


class State(_Form):
    """How far a step is."""

    model_config = ConfigDict(strict=True, extra="forbid")

    number: int
    state: Literal["proposed", "approved", "recorded", "diagnosed"]
    run_dir: str | None = None
    approved_by: str | None = None
    ended: str | None = None
    used: bool = True
    verdict: str | None = None
    proposal: _Run = Field(default_factory=_nothing)


class _Size(_Form):
    value: Number


class _Mechanism(_Form):
    id: str
    rms_mm: _Size | None = None


class _Explanation(_Form):
    ids: list[str]
    probability: Number | None = None


class _Evidence(_Form):
    explanations: list[_Explanation] = []


class Verdict(_Form):
    """What is read of a diagnosis.json."""

    verdict: str
    mechanisms: list[_Mechanism]
    alternatives: list[list[str]]
    evidence: _Evidence = _Evidence()


def read_formed(path: Path, form: type[BaseModel], mend: str = ANEW) -> Any:
    """The values of a step's JSON; raises BadInput with the field where they are not of the form."""
    content = read_checked(path, mend)
    check_form(path, form, content, mend)
    return content


def check_form(path: Path, form: type[BaseModel], content: Any, mend: str = ANEW) -> None:
    """Raise BadInput, with the field, where values of a step's JSON are not of the form."""
    try:
        form.model_validate(content)
    except ValidationError as error:
        first = error.errors()[0]
        field = ".".join(map(str, first["loc"])) or "content"
        raise BadInput(path, field, f"cannot be read ({first['msg']}: {short(first['input'])})", mend) from None
