"""Each effect's parameters, drawn for a bench and a protocol, as a function of one strength."""

from collections.abc import Callable

import numpy as np

from ..ground.outside_library import is_outside
from ..rig import effects
from ..rig.concealed import Parameters, Scene
from .bench import Bench
from .protocol import Protocol
from .wander import wander

Strength = Callable[[float], Parameters]  # at 1 the effect is of a size that is often met

OPEN_SET = tuple(name for name in effects.names() if is_outside(name))
NAMED = tuple(name for name in effects.names() if not is_outside(name))
EITHER_SIGN = tuple(name for name in effects.names() if effects.concealed(name).either_sign)
# Once, these were drawn all together and one of them taken. Cases that are published came of it, so that the same seed
# must go on to draw all of them. An effect that is added draws alone, and stands in no list.
TOGETHER = (
    *("axial_elasticity", "backlash", "eccentricity", "end_stop", "friction_hysteresis", "jam", "load_swing"),
    *("overtwist", "radius_compaction", "sensor_drift", "sensor_lag", "shaft_windup", "slack", "stick_slip"),
    *("stiffening", "viscous_loss", "wear", "x_ballooning", "x_encoder_interpolation", "x_floor_sway"),
    *("x_humidity", "x_magnetic_scale", "x_string_tangling"),
)


def draw_effect(
    name: str, bench: Bench, protocol: Protocol, rng: np.random.Generator, steady: bool = False
) -> Strength:
    """Parameters of an effect by its strength, with shape and sign drawn; unless `steady`, some strengths wander."""
    scene, hidden = _scene(bench, protocol, rng), effects.concealed(name)
    drawn = {each: effects.concealed(each).draw(scene, rng) for each in (TOGETHER if name in TOGETHER else (name,))}
    shape = drawn[name]
    sign = float(rng.choice([-1.0, 1.0])) if hidden.either_sign else 1.0
    if hidden.wanders and not steady:
        shape["unsteady"] = wander(hidden.wanders, rng)
    return lambda strength: hidden.at(shape, sign * strength, scene)


def _scene(bench: Bench, protocol: Protocol, rng: np.random.Generator) -> Scene:
    """The bench and the motion as an effect's own file asks for them."""
    phase_rad = float(rng.uniform(0.0, 2.0 * np.pi))
    size = {"stroke_mm": bench.stroke_mm, "torque_n_mm": bench.torque_n_mm, "top_turns": bench.top_turns}
    return Scene(
        bench.true, bench.loads_n[0], commands=protocol.told, step_s=protocol.step_s, phase_rad=phase_rad, **size
    )
