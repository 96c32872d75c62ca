"""The referee of purity: an effect deserves its name if it stands still as soon as its driver does.

It reruns the rig with the declared driver frozen, where little of the effect may be left, and with other things
changed, where little of it may change.
"""

from dataclasses import dataclass

from ..ground.kinematics import Array
from ..rig import effects
from ..rig.altered_motion import Otherwise
from ..rig.concealed import Parameters
from ..rig.motion_commands import Commands
from ..rig.string_state import String
from .bench import Bench
from .protocol import Protocol
from .sealed import RulingJson

LEAST_CARRIED = 0.90
MOST_CHANGED = 0.10


@dataclass(frozen=True)
class Ruling:
    """The findings of the referee."""

    driver: str
    carried: float  # share of the effect that goes when its driver stands still
    changed: dict[str, float]  # share of the effect that changes with what should make no difference

    @property
    def pure(self) -> bool:
        """Whether the effect may be called by its name."""
        return self.carried >= LEAST_CARRIED and max(self.changed.values(), default=0.0) <= MOST_CHANGED

    def told(self) -> RulingJson:
        """All of it, for the answer."""
        return {"driver": self.driver, "driver_carries": self.carried, "bystanders_change": self.changed}


def rule(name: str, parameters: Parameters, bench: Bench, protocol: Protocol) -> Ruling:
    """Rerun the rig on a bench as an effect's claim asks, and compare."""
    claim = effects.concealed(name).claims(parameters)

    def does(change: Otherwise | None = None) -> Array:
        recorded = protocol.told, protocol.step_s
        return _does(name, parameters, bench, *(change.made(*recorded) if change else recorded))

    effect = does()
    first = int(protocol.told.strokes_s[0, 1] / protocol.step_s) if claim.frozen.after_one_winding else 0
    frozen = does(claim.frozen)[first:]
    size = float(effect.std())
    changed = {change.name: float((does(change) - effect).std()) / size for change in claim.indifferent}
    return Ruling(claim.driver, 1.0 - float(frozen.std()) / size, changed)


def _does(name: str, parameters: Parameters, bench: Bench, commands: Commands, step_s: float) -> Array:
    """What the steady effect does to its quantity, of shape (steps,): rad, a factor, or mm."""
    effect = effects.make(name, {key: value for key, value in parameters.items() if key != "unsteady"})
    with_it = String(bench.true, [effect], step_s).live(commands.motor_turns, commands.load_n)
    without = String(bench.true, [], step_s).live(commands.motor_turns, commands.load_n)
    if effect.acts_on == "twist":
        return without.twist_rad - with_it.twist_rad
    if effect.acts_on == "radius":
        return with_it.radius_mm / without.radius_mm
    return with_it.reading_mm - without.reading_mm
