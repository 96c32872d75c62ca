"""Laws of dry friction and of viscous loss: forces that the string's compliance makes visible."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.mechanics.engine import (
    HARD_SOLIMP,
    HARD_SOLREF,
    STICKS,
    following,
    model_text,
    push,
    simulated,
    slider,
    spring_drive,
)
from pipeline.rig.authors.mechanics.scene import STEP_S, Law, Scene, proportional

PULSE = 2.0 * np.pi * 6.0  # of the sliding parts on what holds them, in rad/s


def shoe_on_rail(scene: Scene, draw: np.random.Generator) -> Law:
    """The carriage's shoe, pressed on its rail by the load: MuJoCo's contact with Coulomb friction, and a spring."""
    yields_mm, rubbing = float(draw.uniform(0.03, 0.3)), 0.2
    press = scene.load_n / scene.usual_load_n * PULSE**2 * yields_mm / rubbing
    contact = f'solref="{HARD_SOLREF}" solimp="{HARD_SOLIMP}" friction="{rubbing} 0.005 0.0001" condim="3"'
    shoe = f'<joint name="lift" type="slide" axis="0 0 1"/><geom type="sphere" size="1" {contact}/>'
    bodies = f'<geom type="plane" size="0 0 1" pos="0 0 -1" {contact}/>' + slider("carriage", inside=shoe)
    text = model_text(bodies, spring_drive("carriage", PULSE) + push("lift"), contact=True)
    travel = scene.contraction_mm
    controls = np.column_stack([following(travel, STEP_S), -press])
    held = simulated(text, controls, STEP_S, [travel[0], 0.0]).position[:, 0] - travel
    parameters = {"presliding_mm": yields_mm, "friction_coefficient": rubbing}
    return proportional("length", "largest_mm", 4.0, held, parameters)


def strand_sliders(scene: Scene, draw: np.random.Generator) -> Law:
    """Four sliders side by side between the strands, each with its spring and its dry friction that the load sets."""
    widths = np.sort(np.exp(draw.uniform(np.log(0.03), np.log(0.6), 4)))
    power = float(draw.uniform(0.6, 1.1))
    names = [f"slider{number}" for number in range(4)]
    bodies = "".join(slider(name, f'frictionloss="1" {STICKS}') for name in names)
    text = model_text(bodies, "".join(spring_drive(name, PULSE) for name in names))
    loss = PULSE**2 * widths
    pieces = [(step, {"dof_frictionloss": loss * (load / scene.usual_load_n) ** power}) for step, load in scene.loads()]
    controls = np.tile(following(scene.turns, STEP_S), 4)
    position = simulated(text, controls, STEP_S, np.full(4, scene.turns[0]), pieces).position
    held = np.sum(position - scene.turns[:, None], axis=1)
    parameters = {f"width_{number}_turns": float(width) for number, width in enumerate(widths, 1)}
    return proportional("twist", "largest_turns", 3.0, held, parameters | {"load_power": power})


def grease_dashpot(scene: Scene, draw: np.random.Generator) -> Law:
    """Grease between the strands drags the string along with the twisting, and the string yields as a spring."""
    settle_s = float(draw.uniform(0.02, 0.08))
    damping = PULSE**2 * settle_s
    drag = f'<general joint="string" gainprm="{damping}" biastype="affine" biasprm="0 0 {-damping}"/>'
    text = model_text(slider("string", f'stiffness="{PULSE**2}" damping="{PULSE}"'), drag)
    rate = np.gradient(scene.turns, STEP_S)
    shape = -simulated(text, rate[:, None], STEP_S).position[:, 0]
    return proportional("length", "largest_mm", 4.0, shape, {"settle_s": settle_s})


def stirred_fluid(scene: Scene, draw: np.random.Generator) -> Law:
    """The winding bundle stirs a fluid: MuJoCo's drag of a body in a medium, with its square and its linear part."""
    linear, side, deflection = float(draw.uniform(0.02, 0.3)), 1.0, 0.05
    speed = float(np.abs(np.gradient(scene.turns, STEP_S)).max())
    pulse = 4.0 * PULSE  # so stiff that the paddle's inertia moves it by next to nothing
    force = deflection * pulse**2
    density = 2.0 * (1.0 - linear) * force / (side**2 * speed**2)
    viscosity = linear * force / (3.0 * np.pi * side * speed)
    inertia = side**2 / 6.0
    body = f'<body><inertial pos="0 0 0" mass="1" diaginertia="{inertia} {inertia} {inertia}"/>'
    body += '<joint name="paddle" type="slide" axis="1 0 0"/></body>'
    medium = f'density="{density:.9g}" viscosity="{viscosity:.9g}"'
    text = model_text(body, spring_drive("paddle", pulse, 0.7), medium=medium)
    shape: Array = simulated(text, following(scene.turns, STEP_S), STEP_S, scene.turns[:1]).position[:, 0] - scene.turns
    return proportional("length", "largest_mm", 4.0, shape, {"linear_share": linear})
