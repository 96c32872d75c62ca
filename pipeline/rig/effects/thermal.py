"""The string's length follows its temperature: heat comes from the room, and from the work on the string.

Source: Carslaw and Jaeger, Conduction of Heat in Solids, 1959 (bodies that exchange heat in proportion to their
difference).
"""

import math

import numpy as np

from ...ground.kinematics import Array
from .. import altered_motion
from ..concealed import Claim, Concealed, Parameters, Scene, uniform
from ..effect import Effect, Lived, compiled


class Model(Effect):
    """Two bodies, the string and the rig about it, that exchange heat with each other and the room.

    The string, T, is warmed by a share of the motor's work on it and settles to the rig, B, within `string_s`;
    the rig takes `rig_share` of that heat and settles to the room within `rig_s`. The room is warmer by
    `room_k` between two times, as when the sun comes in. A thermocouple follows T within `sensor_s`.
    """

    acts_on = "length"

    def __init__(
        self,
        expansion_mm_per_k: float = 0.02,
        heating_k_per_j: float = 2.0,
        room_k: float = 0.0,
        warm_s: tuple[float, float] = (100.0, 250.0),
        string_s: float = 40.0,
        rig_s: float = 300.0,
        rig_share: float = 0.2,
        sensor_s: float = 3.0,
    ) -> None:
        self.expansion_mm_per_k, self.heating_k_per_j = expansion_mm_per_k, heating_k_per_j
        self.room_k, self.warm_s = room_k, warm_s
        self.string_s, self.rig_s, self.rig_share, self.sensor_s = string_s, rig_s, rig_share, sensor_s
        self.state = np.zeros(3)  # string, rig and thermocouple above the room's first temperature, in K
        self.time_s = 0.0

    def run(self, lived: Lived) -> Array:
        """Lengthening in mm; writes the temperature channel as well."""
        step_s = lived.step_s
        time_s = self.time_s + step_s * np.arange(len(lived.load_n))
        self.time_s += step_s * len(time_s)
        begins, ends = ((1.0 + np.tanh((time_s - at) / 12.0)) / 2.0 for at in self.warm_s)
        torque_n_mm = lived.load_n * lived.radius_mm * lived.helix_sine
        warming_k = self.heating_k_per_j * torque_n_mm / 1e3 * np.abs(lived.turned_rad)
        rates = (step_s / self.string_s, step_s / self.rig_s, self.rig_share, -math.expm1(-step_s / self.sensor_s))
        string_k, sensor_k = _warm(warming_k, self.room_k * (begins - ends), rates, self.state)
        lived.temperature_c = lived.temperature_c + sensor_k
        return np.asarray(self.expansion_mm_per_k * string_k)


@compiled
def _warm(warming_k: Array, room_k: Array, rates: tuple[float, ...], state: Array) -> tuple[Array, Array]:
    to_rig, to_room, rig_share, to_sensor = rates
    string_k, sensor_k = np.empty(len(room_k)), np.empty(len(room_k))
    for step in range(len(room_k)):
        # implicit in both bodies, so that any step will do
        a, b = 1.0 + to_rig, 1.0 + to_rig * rig_share + to_room
        string, rig = state[0] + warming_k[step], state[1] + to_room * room_k[step]
        whole = a * b - to_rig * to_rig * rig_share
        state[0] = (b * string + to_rig * rig) / whole
        state[1] = (a * rig + to_rig * rig_share * string) / whole
        state[2] += (state[0] - state[2]) * to_sensor
        string_k[step], sensor_k[step] = state[0], state[2]
    return string_k, sensor_k


class Hidden(Concealed):
    """A string that lengthens by two hundredths of a millimetre a kelvin, and more, or shrinks."""

    claim = Claim("temperature", altered_motion.AT_REST)
    grows, either_sign = ("expansion_mm_per_k",), True

    def draw(self, scene: Scene, rng: np.random.Generator) -> Parameters:
        """Half of the strings warm themselves, and nobody measures how much; the others are warmed by the room."""
        if rng.random() < 0.5:
            heating, string_s = uniform(rng, 1.0, 4.0), uniform(rng, 25.0, 60.0)
            return {"heating_k_per_j": heating, "string_s": string_s, "expansion_mm_per_k": 0.02}
        warm_s = (scene.lasts_s * uniform(rng, 0.15, 0.4), scene.lasts_s * uniform(rng, 0.55, 0.8))
        room: Parameters = {"heating_k_per_j": 0.0, "room_k": uniform(rng, 4.0, 12.0), "warm_s": warm_s}
        times = {"string_s": uniform(rng, 8.0, 30.0), "rig_s": uniform(rng, 60.0, 150.0)}
        return {**room, **times, "expansion_mm_per_k": 0.02}

    def claims(self, parameters: Parameters) -> Claim:
        """Heat that comes from the room stands still when time does, not when the string does."""
        warm = self.warms_the_room(parameters)
        return Claim("temperature", altered_motion.IN_NO_TIME, (altered_motion.AT_REST,)) if warm else self.claim

    def warms_the_room(self, parameters: Parameters) -> bool:
        """Whether the heat comes from the room, which nobody can know without a thermometer."""
        return bool(parameters.get("room_k"))
