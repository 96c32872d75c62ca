"""A set-up of the synthetic rig: its run.yaml, its motion, and its hidden effects."""

from pathlib import Path
from typing import Annotated

import yaml
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from ..ground.errors import BadInput
from ..ground.kinematics import Geometry
from ..run.description import Run, parse_run
from . import effects
from .motion_commands import Motion
from .sensors import Sensor

SHIPPED = Path(__file__).parent / "setups"
CHANNELS = ("motor_turns", "displacement_mm", "load_n")


class SetUp(BaseModel):
    """One file of `setups/`, checked."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    run: dict[str, object] = Field(description="run.yaml, but for the run's name")
    motion: Motion
    rate_hz: Annotated[float, Field(ge=1, le=10_000)]
    steps_per_sample: Annotated[int, Field(ge=1)] = 4
    clock_start_us: Annotated[int, Field(ge=0, lt=1 << 32)] = 0
    sensors: dict[str, Sensor]
    effects: dict[str, dict[str, object]] = Field(description="hidden from the analytic model")


def names() -> list[str]:
    """Names of the set-ups that are shipped."""
    return sorted(path.stem for path in SHIPPED.glob("*.yaml"))


def read_setup(which: str) -> SetUp:
    """The set-up of that name, or in that YAML file; raises BadInput."""
    path = SHIPPED / f"{which}.yaml" if which in names() else Path(which)
    try:
        setup = SetUp.model_validate(yaml.safe_load(path.read_text(encoding="utf-8")))
    except (OSError, UnicodeDecodeError):
        mend = f"give a YAML file or one of {', '.join(names())}"
        raise BadInput(which, "set-up", "is not there or cannot be read", mend) from None
    except yaml.YAMLError:
        raise BadInput(path, "set-up", "is not YAML", "check its indentation, colons and quotes") from None
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        field = ".".join(str(part) for part in first["loc"]) or "set-up"
        raise BadInput(path, field, first["msg"], f"see {SHIPPED / 'paper.yaml'}") from None
    for name, parameters in setup.effects.items():
        try:
            effects.make(name, parameters)
        except ValueError as error:
            raise BadInput(path, f"effects.{name}", str(error), "correct it") from None
    for name in setup.sensors:
        if name not in CHANNELS:
            mend = f"the rig has {', '.join(CHANNELS)}"
            raise BadInput(path, f"sensors.{name}", "is not a channel of the rig", mend)
    described(setup, path.parent / "any" / "run.yaml")
    return setup


def described(setup: SetUp, path: Path) -> Run:
    """The run.yaml of the set-up at `path`, as a checked run; raises BadInput."""
    return parse_run({"run": path.parent.name, **setup.run}, path)


def dimensions(run: Run) -> Geometry:
    """The measured dimensions of string and rig; raises BadInput for dimensions that the rig cannot simulate."""
    if run.actuator != "separator" or run.string is None:
        mend = "use actuator: separator"
        raise BadInput("set-up", "run.actuator", f"is {run.actuator}, which the rig does not have", mend)
    string = run.string
    return Geometry(
        run.actuator,
        string.radius_mm,
        string.length_mm,
        string.nominal_stiffness_n_per_mm,
        run.rig["torsion_zone_mm"],
        run.rig["separator_mm"],
    )
