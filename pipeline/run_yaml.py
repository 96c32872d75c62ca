"""What `run.yaml` may say: the string, the rig, the file and its channels, checked key by key."""

import difflib
import re
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError, field_validator, model_validator

from pipeline.errors import BadInput
from pipeline.systems import System, systems

RUN_NAME = re.compile(r"[a-z0-9][a-z0-9-]*")
MATERIAL_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]*")
STRING_ACTUATORS = ("separator", "twisted_pair")


def _no_bool(value: Any) -> Any:
    if isinstance(value, bool):  # YAML reads yes and no as these, and they would count as 1 and 0
        raise ValueError("must be a number")
    return value


Number = Annotated[float, BeforeValidator(_no_bool), Field(allow_inf_nan=False)]
Positive = Annotated[Number, Field(gt=0)]


class _Section(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class String(_Section):
    """The string of a run: what it is made of and what was measured on it."""

    material: str = Field(description="name of the material, letters, digits, _ and -", examples=["UHMWPE"])
    radius_mm: Positive = Field(description="radius of one string in mm", examples=[0.55])
    length_mm: Positive = Field(description="length l0 of the unloaded string in mm", examples=[320])
    stiffness_n_per_mm: Positive = Field(description="stiffness K of the string in N/mm", examples=[35])
    id: str | None = Field(None, description="name of this very string; runs that share it continue each other")
    strokes_before: int = Field(0, ge=0, description="strokes that the string had done before this run")

    @field_validator("material")
    @classmethod
    def _name(cls, value: str) -> str:
        if not MATERIAL_NAME.fullmatch(value):
            raise ValueError("must be letters, digits, _ and -, and begin with a letter or a digit")
        return value


class TextFile(_Section):
    """How a text recording is written."""

    delimiter: str = Field(",", min_length=1, max_length=1, description="one character; a space is any white space")
    header: bool = True
    comment: str | None = Field(None, min_length=1, max_length=1)
    encoding: str = "utf-8"


class Channel(_Section):
    """Where a channel stands in the recording: value = scale · raw + offset, then the unit."""

    column: str | int | None = Field(None, description="the column's name or its index from 0")
    unit: str | None = Field(None, description="the unit of scale · raw + offset")
    scale: Number = 1.0
    offset: Number = 0.0
    counts_per_turn: Positive | None = None


class Run(_Section):
    """`run.yaml`, checked: lengths in mm, forces in N, as their names say."""

    run: str
    actuator: str = Field("separator", description="the kind of rig")
    string: String | None = Field(None, description="the string: material, radius_mm, length_mm, stiffness_n_per_mm")
    rig: dict[str, Number] = Field(default_factory=dict, description="the rig's dimensions")
    tolerance: dict[str, Positive] = Field(default_factory=dict)
    simulation: list[dict[str, Any]] = Field(default_factory=list)
    file: TextFile = Field(default_factory=lambda: TextFile.model_validate({}))
    channels: dict[str, Channel] = Field(default_factory=dict)
    tare: Literal["string", "run"] = Field(
        "string", description='"run" where the zero was moved since the run before of the same string'
    )
    mended: dict[str, Annotated[int, Field(ge=0)]] = Field(default_factory=dict)

    @model_validator(mode="after")
    def _actuator_has_its_parts(self) -> "Run":
        known = systems()
        if self.actuator not in known:
            raise ValueError(
                f"actuator: is {self.actuator!r}, of which nothing is known; use one of {', '.join(known)}"
            )
        system = known[self.actuator]
        if system.needs_string and self.string is None:
            raise ValueError("string: is missing; add the string's material, radius_mm, length_mm, stiffness_n_per_mm")
        keys = {**system.rig, **system.optional_rig}
        for key, value in self.rig.items():
            if key not in keys:
                raise ValueError(f"rig.{key}: is not a known key; {_meant(key, keys)}")
            if (value < 0 and key not in system.may_be_negative) or (value == 0 and key in system.never_zero):
                raise ValueError(f"rig.{key}: is {value:g}; give {keys[key]} that was measured")
        for key, meaning in system.rig.items():
            if key not in self.rig:
                raise ValueError(f"rig.{key}: is missing; add {meaning} that you measured on the rig")
        for key in self.tolerance:
            if key not in system.tolerance:
                raise ValueError(f"tolerance.{key}: is not a known key; {_meant(key, system.tolerance)}")
        return self

    @property
    def system(self) -> System:
        """The base simulator of the rig, and what a recording of it holds."""
        return systems()[self.actuator]

    @property
    def string_id(self) -> str:
        """Name of the string, which is the run's own name unless `string.id` says otherwise."""
        return (self.string.id if self.string else None) or self.run


def _meant(key: str, known: Any) -> str:
    close = difflib.get_close_matches(key, list(known), n=1)
    return f"did you mean {close[0]!r}?" if close else f"remove it; known are {', '.join(known)}"


def _known_keys(where: tuple[Any, ...]) -> list[str]:
    sections: dict[str, type[BaseModel]] = {"string": String, "file": TextFile, "channels": Channel}
    return list(sections.get(str(where[0]) if len(where) > 1 else "", Run).model_fields)


def _bad(path: Path, error: ValidationError) -> BadInput:
    """First complaint of pydantic as file, field and mend."""
    complaints = error.errors(include_url=False)
    # A misspelt key is one mistake but two complaints: the unknown key says more than the missing one.
    complaint = next((one for one in complaints if one["type"] == "extra_forbidden"), complaints[0])
    where, kind = complaint["loc"], complaint["type"]
    if not where:  # a check over several keys, whose message names its field
        field, _, rest = complaint["msg"].removeprefix("Value error, ").partition(": ")
        problem, _, mend = rest.partition("; ")
        return BadInput(path, field, problem, mend)
    field = ".".join(str(part) for part in where)
    if kind == "extra_forbidden":
        return BadInput(path, field, "is not a known key", _meant(str(where[-1]), _known_keys(where)))
    section: type[BaseModel] = String if where[0] == "string" and len(where) > 1 else Run
    info = section.model_fields.get(str(where[-1]))
    hint = f" ({info.description})" if info is not None and info.description else ""
    if kind == "missing":
        return BadInput(path, field, "is missing", f"add it{hint}")
    problem = complaint["msg"].removeprefix("Value error, ")
    return BadInput(path, field, f"is {complaint['input']!r}: {problem}", f"correct it{hint}")


def parse_run(content: Any, path: Path) -> Run:
    """Check the content of a `run.yaml` that stands, or will stand, at `path`.

    Raises BadInput for an unknown or missing key, a wrong type, or a name that is not the folder's.
    """
    if not isinstance(content, dict):
        raise BadInput(path, "run.yaml", "is not a list of keys and values", "write it as the README shows")
    try:
        run = Run.model_validate(content)
    except ValidationError as error:
        raise _bad(path, error) from None
    if not RUN_NAME.fullmatch(run.run):
        raise BadInput(path, "run", f"is {run.run!r}", "use lower-case letters, digits and -, as in uhmwpe-20261121-01")
    if run.run != path.parent.name:
        raise BadInput(path, "run", f"is {run.run!r} in a folder named {path.parent.name!r}", "make both the same")
    return run
