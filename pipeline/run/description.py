"""The keys of `run.yaml`, checked one by one: the string, the rig, the file and its channels."""

from pathlib import Path
from typing import Annotated, Any, Literal, Required

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, ValidationError, model_validator
from typing_extensions import TypedDict

from ..ground import names
from ..ground.errors import BadInput
from ..ground.input.bare_columns import all_written_out
from ..ground.input.complaint import bad_section, key_name, meant, short
from ..ground.input.plain_numbers import Number, Positive, Times, no_bool
from ..ground.input.text_file import TextFile
from ..ground.kinematics import usual_stiffness
from ..ground.names import MATERIAL_NAME, RUN_NAME
from ..ground.numbers.too_short import too_short
from ..systems import System, systems

__all__ = ["MATERIAL_NAME", "RUN_NAME", "STRING_ACTUATORS", "Channel", "Run", "String", "TextFile", "parse_run"]
STRING_ACTUATORS = ("separator", "twisted_pair")


def _column(value: Any) -> Any:
    return names.column(value) if isinstance(value, str) else value


class _Section(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class String(_Section):
    """The string of a run: its material and its measured dimensions."""

    material: Annotated[str, AfterValidator(names.material)] = Field(
        description="name of the material, letters, digits, _ and -", examples=["UHMWPE"]
    )
    radius_mm: Positive = Field(description="radius of one string in mm", examples=[0.55])
    length_mm: Positive = Field(description="length l0 of the unloaded string in mm", examples=[320])
    stiffness_n_per_mm: Positive | None = Field(
        None, description="stiffness K of the string in N/mm; left out or null where nobody measured it", examples=[35]
    )
    id: Annotated[str, AfterValidator(names.string_id)] | None = Field(
        None, description="name of this very string; runs that share it continue each other"
    )
    strokes_before: Times = Field(0, description="strokes that the string had done before this run")

    @property
    def nominal_stiffness_n_per_mm(self) -> float:
        """The measured stiffness, or the usual one of a string of this size, in N/mm."""
        return self.stiffness_n_per_mm or usual_stiffness(self.radius_mm, self.length_mm)


class Included(TypedDict, total=False):
    """A mechanism that the simulator already includes, as a diagnosis gives it."""

    __pydantic_config__ = ConfigDict(extra="forbid")  # type: ignore[misc]
    id: Required[str]
    parameters: dict[str, Number]


class Fitted(_Section):
    """A dimension from run.yaml at the time of adopting, and the value fitted together with the effects."""

    nominal: Number
    fitted: Number


class Adopted(_Section):
    """What `pipeline.adopt` put into `simulation`: the effects, the verdict on them, and the explanations that tied."""

    effects: list[str]
    verdict: Literal["explained", "ambiguous"]
    tied: list[list[str]] = Field(default_factory=list)
    diagnosis: str | None = Field(None, description="the diagnosis.json that was adopted")
    runs: list[str] | None = Field(None, description="the runs that the effects were fitted to")
    next_experiment: list[str] | str | None = Field(
        None, description="the run that decides between what tied, in words"
    )
    dimensions: dict[str, Fitted] | None = Field(None, description="the dimensions that fit with the effects")
    against_advice: list[str] | None = Field(
        None, description="where it was adopted against the verdict's advice: that advice, and what to record instead"
    )


class Channel(_Section):
    """Where a channel stands in the recording: value = scale · raw + offset, then the unit."""

    column: Annotated[str | int | None, BeforeValidator(no_bool), AfterValidator(_column)] = Field(
        None, description="the column's name or its index from 0"
    )
    unit: str | None = Field(None, description="the unit of scale · raw + offset")
    scale: Number = 1.0
    offset: Number = 0.0
    counts_per_turn: Positive | None = None
    step_s: Positive | None = Field(None, description="of time_s: what lies between two rows of a file without a clock")


Tare = Literal["string", "run", "checked"]  # what a run says of its zero: nothing, that it was moved, that it was not


class Run(_Section):
    """`run.yaml`, checked: lengths in mm, forces in N, as their names say."""

    run: str
    actuator: str = Field("separator", description="the kind of rig")
    string: String | None = Field(None, description="the string: material, radius_mm, length_mm")
    rig: dict[str, Number] = Field(default_factory=dict, description="the rig's dimensions")
    tolerance: dict[str, Positive] = Field(default_factory=dict)
    simulation: list[Included] = Field(default_factory=list)
    adopted: list[Adopted] = Field(default_factory=list, description="where `simulation` came from, by verdict")
    file: TextFile = Field(default_factory=lambda: TextFile.model_validate({}))
    channels: Annotated[dict[str, Channel], BeforeValidator(all_written_out)] = Field(default_factory=dict)
    tare: Tare = Field(
        "string",
        description='"run" where the zero was moved since the run before of the string, "checked" if it was not',
    )
    mended: dict[str, Times] = Field(default_factory=dict)

    @model_validator(mode="after")
    def _actuator_has_its_parts(self) -> "Run":
        all_systems = systems()
        if self.actuator not in all_systems:
            raise ValueError(
                f"actuator: is {short(self.actuator)}, of which nothing is known; use one of {', '.join(all_systems)}"
            )
        system = all_systems[self.actuator]
        if system.needs_string and self.string is None:
            raise ValueError("string: is missing; add the string's material, radius_mm, length_mm")
        keys = {**system.rig, **system.optional_rig}
        for key, value in self.rig.items():
            if key not in keys:
                raise ValueError(f"rig.{key_name(key)}: is not a known key; {meant(key, keys)}")
            if (value < 0 and key not in system.may_be_negative) or (value == 0 and key in system.never_zero):
                raise ValueError(f"rig.{key}: is {value:g}; give {keys[key]} that was measured")
        if lacking := [key for key in system.rig if key not in self.rig]:
            are, add = "are" if lacking[1:] else "is", " and ".join(dict.fromkeys(system.rig[key] for key in lacking))
            raise ValueError(f"rig.{', rig.'.join(lacking)}: {are} missing; add {add} that you measured{self._or_else}")
        if self.string and (wrong := too_short(self.string.length_mm, self.rig.get("torsion_zone_mm", 0.0))):
            raise ValueError(wrong)
        for key in self.tolerance:
            if key not in system.tolerance:
                raise ValueError(f"tolerance.{key_name(key)}: is not a known key; {self._as_share(key)}")
        return self

    def _as_share(self, key: str) -> str:
        """The mend of a tolerance under an unknown key, such as one in mm where a share is expected."""
        share, nominal, tolerances = key.removesuffix("_mm"), getattr(self.string, key, None), self.system.tolerance
        if share not in tolerances or not nominal:
            return meant(key, tolerances)
        return f"write {share}: {self.tolerance[key] / nominal:.3g}, which is a share of {nominal:g} mm"

    @property
    def _or_else(self) -> str:
        """The mend for a key that this kind of rig does not have."""
        without = "; a rig without a separator is actuator: twisted_pair, as an option --actuator twisted_pair"
        return without if self.actuator == "separator" else ""

    @property
    def system(self) -> System:
        """The base simulator of the rig, which also names the channels of a recording."""
        return systems()[self.actuator]

    @property
    def string_id(self) -> str:
        """Name of the string, which is the run's own name unless `string.id` says otherwise."""
        return (self.string.id if self.string else None) or self.run


SECTIONS: dict[str, type[BaseModel]] = {"string": String, "file": TextFile, "channels": Channel}


def parse_run(content: Any, path: Path) -> Run:
    """Check the content of a `run.yaml` that stands, or will stand, at `path`.

    Raises BadInput for an unknown or missing key, a wrong type, or a name that is not the folder's.
    """
    if not isinstance(content, dict):
        raise BadInput(path, "run.yaml", "is not a list of keys and values", "write it as the README shows")
    try:
        run = Run.model_validate(content)
    except ValidationError as error:
        raise bad_section(path, error, Run, SECTIONS) from None
    names.checked(names.run_name, run.run, path, "run")
    if run.run != path.parent.name:
        raise BadInput(path, "run", f"is {run.run!r} in a folder named {short(path.parent.name)}", "make both the same")
    return run
