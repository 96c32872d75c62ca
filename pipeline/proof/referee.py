"""The referee of purity: an effect is what its name says when it stands still as soon as its driver does.

It reruns the rig with the declared driver frozen, where little of the effect may be left, and with other things
changed, where little of it may change.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..ground.kinematics import Array
from ..rig import effects
from ..rig.concealed import Other
from ..rig.motion import Commands
from ..rig.string import String
from .bench import Bench
from .protocol import Protocol

LEAST_CARRIED = 0.90
MOST_CHANGED = 0.10

Done = tuple[Commands, float]  # what is commanded, and the time that a step of it lasts
Change = Callable[[Commands, float], Done]


def _turns(made: Callable[[Array], Array]) -> Change:
    return lambda commands, step_s: (replace(commands, motor_turns=made(commands.motor_turns)), step_s)


def _load(made: Callable[[Array], Array]) -> Change:
    return lambda commands, step_s: (replace(commands, load_n=made(commands.load_n)), step_s)


def _pace(times: float) -> Change:
    return lambda commands, step_s: (commands, step_s / times)


CHANGES: Mapping[Other, Change] = {
    "in no time": _pace(1e6),
    "infinitely slowly": _pace(0.001),
    "at half speed": _pace(0.5),
    "a hundred times as fast": _pace(100.0),
    "without load": _load(lambda load_n: 1e-6 * load_n),
    "under one load": _load(lambda load_n: np.full_like(load_n, load_n.mean())),
    "under twice the load": _load(lambda load_n: 2.0 * load_n),
    "at rest": _turns(lambda turns: np.full_like(turns, turns[0])),
    "wound up once": _turns(np.maximum.accumulate),
    "half wound": _turns(lambda turns: 0.4 * turns),
    "never unwound": _turns(lambda turns: 0.5 * turns.max() + 0.5 * turns),
    "by whole turns": _turns(np.rint),
}


@dataclass(frozen=True)
class Ruling:
    """What the referee saw."""

    driver: str
    carried: float  # share of the effect that goes when its driver stands still
    changed: dict[Other, float]  # share of the effect that changes with what should make no difference

    @property
    def pure(self) -> bool:
        """Whether the effect may be called by its name."""
        return self.carried >= LEAST_CARRIED and max(self.changed.values(), default=0.0) <= MOST_CHANGED

    def told(self) -> dict[str, Any]:
        """All of it, for the answer."""
        return {"driver": self.driver, "driver_carries": self.carried, "bystanders_change": self.changed}


def rule(name: str, parameters: Mapping[str, Any], bench: Bench, protocol: Protocol) -> Ruling:
    """Rerun the rig on a bench as an effect's claim asks, and compare."""
    claim = effects.concealed(name).claims(parameters)

    def does(change: Other | None = None) -> Array:
        commands, step_s = (
            CHANGES[change](protocol.told, protocol.step_s) if change else (protocol.told, protocol.step_s)
        )
        return _does(name, parameters, bench, commands, step_s)

    effect = does()
    after = slice(int(protocol.told.strokes_s[0, 1] / protocol.step_s), None)  # what one winding does is no growth
    frozen = does(claim.frozen)[after] if claim.frozen == "wound up once" else does(claim.frozen)
    size = float(effect.std())
    changed = {change: float((does(change) - effect).std()) / size for change in claim.indifferent}
    return Ruling(claim.driver, 1.0 - float(frozen.std()) / size, changed)


def _does(name: str, parameters: Mapping[str, Any], bench: Bench, commands: Commands, step_s: float) -> Array:
    """What the steady effect does to the quantity that it acts on, of shape (steps,): rad, a factor, or mm."""
    effect = effects.make(name, {key: value for key, value in parameters.items() if key != "unsteady"})
    with_it = String(bench.true, [effect], step_s).live(commands.motor_turns, commands.load_n)
    without = String(bench.true, [], step_s).live(commands.motor_turns, commands.load_n)
    if effect.acts_on == "twist":
        return without.twist_rad - with_it.twist_rad
    if effect.acts_on == "radius":
        return with_it.radius_mm / without.radius_mm
    return with_it.reading_mm - without.reading_mm
