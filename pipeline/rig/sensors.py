"""The rig's sensors: they add noise to the truth, and round to the sensor's quantum."""

from typing import Annotated

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from ..ground.kinematics import Array
from ..ground.units import unit_of
from ..wire.hello import INTEGERS, Channel


class Sensor(BaseModel):
    """One channel: noise (1 sigma, white) and quantum in the channel's unit, and the integer that it is sent as."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    quantum: Annotated[float, Field(gt=0, allow_inf_nan=False)]
    noise: Annotated[float, Field(ge=0, allow_inf_nan=False)] = 0.0
    type: str = Field("i32", pattern=f"^({'|'.join(INTEGERS)})$")
    zeroed: bool = Field(False, description="counts from where it stands when the recording starts")


def declare(sensors: dict[str, Sensor]) -> tuple[Channel, ...]:
    """The channels as a device's HELLO declares them."""
    return tuple(Channel(name, unit_of(name), sensor.type, sensor.quantum) for name, sensor in sensors.items())


def read(sensor: Sensor, truth: Array, rng: np.random.Generator, zero: float | None = None) -> Array:
    """Counts of a sensor, whole numbers within its integer's range; of the shape of `truth`.

    `truth` has the shape (samples,), in the sensor's unit. `zero` is where a sensor that counts from where it stands
    stood when it was set to zero: at the first sample unless given.
    """
    start = truth[0] if zero is None else zero
    value = truth - (start if sensor.zeroed else 0.0) + sensor.noise * rng.standard_normal(len(truth))
    range_ = np.iinfo(INTEGERS[sensor.type])
    return np.clip(np.rint(value / sensor.quantum), range_.min, range_.max)
