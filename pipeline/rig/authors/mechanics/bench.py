"""Effects whose names begin with `x_`: what else spoils a bench."""

import numpy as np

from pipeline.rig.authors.mechanics.engine import (
    HARD_SOLREF,
    STOPS,
    following,
    model_text,
    push,
    simulated,
    slider,
    spring_drive,
)
from pipeline.rig.authors.mechanics.scene import STEP_S, Law, Scene, proportional

PULSE = 2.0 * np.pi * 8.0  # of the carriage on its string, in rad/s


def shaken_bench(scene: Scene, draw: np.random.Generator) -> Law:
    """A fan beside the bench, which comes on and goes off, shakes the sensor's post: a mass on a spring rings."""
    post_hz, fan_hz = float(draw.uniform(1.0, 3.0)), float(draw.uniform(0.6, 2.5))
    time_s = scene.time_s
    switched = np.sort(draw.uniform(0.0, time_s[-1], 6))
    runs = np.searchsorted(switched, time_s) % 2 == int(draw.integers(2))
    unbalance = runs * np.sin(2.0 * np.pi * fan_hz * time_s)
    pulse = 2.0 * np.pi * post_hz
    text = model_text(slider("post", f'stiffness="{pulse**2}" damping="{0.06 * pulse}"'), push("post"))
    shape = simulated(text, unbalance[:, None], STEP_S).position[:, 0]
    return proportional("sensor", "largest_mm", 3.0, shape, {"post_hz": post_hz, "fan_hz": fan_hz})


def second_weight(scene: Scene, draw: np.random.Generator) -> Law:
    """A second weight, which nobody knows of, stands on the floor until a cord of some length lifts it.

    Cord and floor are MuJoCo's limits. What the weight adds to the tension lengthens the string above that height.
    """
    travel = scene.contraction_mm
    low, high = float(travel.min()), float(travel.max())
    lifted_at = low + float(draw.uniform(0.3, 0.75)) * (high - low)
    cord = f'<fixed range="-1000 {lifted_at:.9g}" solreflimit="0.03 1" solimplimit="0.95 0.99 0.5 0.5 2">'
    cord += '<joint joint="carriage" coef="1"/><joint joint="weight" coef="-1"/></fixed>'
    bodies = slider("carriage") + slider("weight", f'range="0 1000" damping="6" {STOPS}')
    text = model_text(bodies, spring_drive("carriage", PULSE, 0.5) + push("weight"), cord)
    pulled = np.full((len(travel), 1), -(PULSE**2))
    controls = np.column_stack([following(travel, STEP_S), pulled])
    shape = simulated(text, controls, STEP_S, [travel[0], 0.0]).position[:, 0] - travel
    return proportional("length", "largest_mm", 4.0, shape, {"lifted_at_mm": lifted_at})


def bumpy_rail(scene: Scene, draw: np.random.Generator) -> Law:
    """The sensor's wheel rolls over bumps on its rail: a sphere in contact with cylinders that lie across."""
    travel = scene.contraction_mm - scene.contraction_mm.min()
    span = float(travel.max())
    count = int(draw.integers(1, 4))
    places = np.sort(draw.uniform(0.1, 0.95, count)) * span
    wheel = float(draw.uniform(0.08, 0.2)) * span
    hard = f'solref="{HARD_SOLREF}" solimp="0.99 0.999 0.01 0.5 2" condim="1"'
    bodies = f'<geom type="plane" size="0 0 1" pos="0 0 {-wheel:.9g}" {hard}/>'
    bump = f'<geom type="cylinder" size="{wheel:.9g} 50" euler="1.5707963 0 0" {hard}'
    bodies += "".join(f'{bump} pos="{place:.9g} 0 {-1.96 * wheel:.9g}"/>' for place in places)
    lift = '<joint name="lift" type="slide" axis="0 0 1" damping="40"/>'
    bodies += slider("carriage", 'armature="1000"', f'{lift}<geom type="sphere" size="{wheel:.9g}" {hard}/>')
    drive = spring_drive("carriage", 20.0 * PULSE, 0.7)
    text = model_text(bodies, drive + push("lift"), contact=True)
    pressed = np.full((len(travel), 1), -2000.0)
    controls = np.column_stack([following(travel, STEP_S), pressed])
    settled = simulated(text, np.tile(controls[:1], (400, 1)), STEP_S, [travel[0], 0.0]).position[-1]
    height = simulated(text, controls, STEP_S, settled).position[:, 1]
    parameters = {f"bump_{number}_mm": float(place) for number, place in enumerate(places, 1)}
    return proportional("sensor", "largest_mm", 3.0, height, parameters | {"wheel_mm": wheel})
