"""Laws of the sensor: a reading that comes late, and a path of the string that turns with the shaft."""

import numpy as np

from pipeline.ground.kinematics import RAD_PER_TURN, Array
from pipeline.rig.authors.mechanics.engine import model_text, mujoco_and_rollout, simulated, slider
from pipeline.rig.authors.mechanics.scene import STEP_S, Law, Scene

AROUND = 720  # angles of one turn at which the path's length is found


def filtered(scene: Scene, draw: np.random.Generator) -> Law:
    """The reading passes a filter of one pole, which is the activation of one of MuJoCo's actuators."""

    def act(lag_s: float, given: Array) -> Array:
        filters = f'<general joint="idle" dyntype="filterexact" dynprm="{lag_s:.9g}" gainprm="0"/>'
        text = model_text(slider("idle"), filters)
        through = 0.5 * (given + np.append(given[1:], given[-1]))  # the filter holds a control for all of its step
        return simulated(text, through[:, None], STEP_S, [0.0, given[0]]).activation[:, 0] - given

    return Law("sensor", "lag_s", (1e-3, 1.0), act)


def heavy_pickup(scene: Scene, draw: np.random.Generator) -> Law:
    """The sensor's arm has mass, rides on a spring and is damped against the frame: two poles."""
    damping = float(draw.uniform(0.5, 1.0))

    def act(lag_s: float, given: Array) -> Array:
        pulse = 2.0 * damping / lag_s
        spring = f'<general joint="arm" gainprm="{pulse**2:.9g}" biastype="affine" '
        spring += f'biasprm="0 {-(pulse**2):.9g} {-2.0 * damping * pulse:.9g}"/>'
        return simulated(model_text(slider("arm"), spring), given[:, None], STEP_S, given[:1]).position[:, 0] - given

    return Law("sensor", "lag_s", (3e-3, 1.0), act, {"damping_ratio": damping})


def _path_mm(inside: str, axis: str, guide: str) -> Array:
    """Length of the path from a guide to a point on a shaft at AROUND angles of one turn, in mm, its mean taken off."""
    mujoco, _ = mujoco_and_rollout()
    shaft = '<body><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
    shaft += f'<joint type="hinge" axis="{axis}"/><site name="eye" pos="{inside}"/></body>'
    path = '<spatial><site site="guide"/><site site="eye"/></spatial>'
    model = mujoco.MjModel.from_xml_string(model_text(f'<site name="guide" pos="{guide}"/>{shaft}', tendons=path))
    data = mujoco.MjData(model)
    lengths = np.empty(AROUND)
    for step in range(AROUND):
        data.qpos[0] = RAD_PER_TURN * step / AROUND
        mujoco.mj_forward(model, data)
        lengths[step] = data.ten_length[0]
    return lengths - lengths.mean()


def _once_a_turn(scene: Scene, draw: np.random.Generator, path: Array, parameters: dict[str, float]) -> Law:
    """A law whose ripple over the turn is the path's, from a random angle on."""
    start, largest = float(draw.uniform(0.0, 1.0)), float(np.abs(path).max())
    around = (scene.turns + start) % 1.0
    ripple = np.interp(around, np.arange(AROUND + 1) / AROUND, np.append(path, path[0])) / largest
    numbers = {"start_turns": start} | parameters
    return Law("length", "amplitude_mm", (1e-5, 2.0), lambda size, given: size * ripple, numbers, wanders=True)


def orbiting_eyelet(scene: Scene, draw: np.random.Generator) -> Law:
    """The string's eyelet orbits beside the shaft's axis, close before a guide that is out of line: with harmonics."""
    off, near = float(draw.uniform(0.8, 1.6)), float(draw.uniform(0.6, 1.5))
    path = _path_mm("1 0 0", "0 0 1", f"{off} 0 {near}")
    return _once_a_turn(scene, draw, path, {"guide_off": off, "guide_near": near})


def tilted_axis(scene: Scene, draw: np.random.Generator) -> Law:
    """The shaft's axis leans to the string, so that its eyelet goes to and fro once a turn: nearly a sine."""
    leans = float(draw.uniform(0.05, 0.2))
    return _once_a_turn(scene, draw, _path_mm("1 0 0", f"{leans} 0 1", "0 0 150"), {"leans": leans})
