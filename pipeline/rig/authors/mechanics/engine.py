"""MuJoCo at work: a model written as text, the controls of every step, and the states that follow.

Every moving part is a joint of mass 1, so that stiffness, damping and friction are per unit of mass, and a spring's
natural frequency is the square root of its stiffness.
"""

import contextlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pipeline.ground.errors import BadInput
from pipeline.ground.kinematics import Array
from pipeline.rig.authors.interface import OutOfReach

GRAVITY_MM_PER_S2 = 9810.0
# MuJoCo's constraints are as hard as they come: what sticks yields by a ten-thousandth of what pulls it in 0.01 s
HARD_SOLREF, HARD_SOLIMP = "0.01 1", "0.9999 0.9999 0.001 0.5 2"
STICKS = f'solreffriction="{HARD_SOLREF}" solimpfriction="{HARD_SOLIMP}"'
STOPS = f'solreflimit="{HARD_SOLREF}" solimplimit="{HARD_SOLIMP}"'


class NotInstalled(BadInput, ImportError):
    """MuJoCo, whose physics this author's is, is not there."""


def mujoco_and_rollout() -> tuple[Any, Any]:
    """MuJoCo and its stepping of many steps at once; raises NotInstalled, which is an ImportError."""
    try:
        import mujoco
        from mujoco import rollout
    except ImportError as error:
        mend = "run the command by python3 env/run.py, which installs what env/requirements.lock names"
        raise NotInstalled("mechanics", "mujoco", "is not installed", mend) from error
    return mujoco, rollout


@contextlib.contextmanager
def unlogged(mujoco: Any) -> Iterator[None]:
    """Keep MuJoCo from writing its warnings to a file in the working folder, for as long as this lasts."""
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(lambda message: None)
    try:
        yield
    finally:
        mujoco.set_mju_user_warning(before)


@dataclass(frozen=True)
class States:
    """What the joints and the activations did, one row for each step: `position` and `velocity`, and `activation`."""

    position: Array
    velocity: Array
    activation: Array


def slider(name: str, joint: str = "", inside: str = "") -> str:
    """A body of mass 1 that moves along x, with more of its joint's attributes and more inside of it."""
    inertia = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
    return f'<body>{inertia}<joint name="{name}" type="slide" axis="1 0 0" {joint}/>{inside}</body>'


def spring_drive(joint: str, pulse: float, damping_ratio: float = 0.3, more: str = "") -> str:
    """Two actuators that pull a joint to where it should be, as a spring does, and to the speed, as a dashpot does.

    `pulse` is the natural frequency in rad/s; the joint follows a steady speed without a lag.
    """
    stiffness, damping = pulse**2, 2.0 * damping_ratio * pulse
    spring = f'<general joint="{joint}" gainprm="{stiffness}" biastype="affine" biasprm="0 {-stiffness} 0" {more}/>'
    dashpot = f'<general joint="{joint}" gainprm="{damping}" biastype="affine" biasprm="0 0 {-damping}"/>'
    return spring + dashpot


def push(joint: str) -> str:
    """An actuator whose control is the force on a joint."""
    return f'<motor joint="{joint}"/>'


def model_text(
    bodies: str,
    actuators: str = "",
    tendons: str = "",
    medium: str = "",
    contact: bool = False,
    gravity_mm_per_s2: float = 0.0,
) -> str:
    """The text of a model: bodies in the world, actuators and tendons; geoms touch only where `contact` is true.

    `medium` holds the attributes of the fluid around the bodies.
    """
    touch = "enable" if contact else "disable"
    return (
        '<mujoco><compiler angle="radian" inertiafromgeom="false" autolimits="true"/>'
        f'<option integrator="implicitfast" cone="elliptic" impratio="10" gravity="0 0 {-gravity_mm_per_s2}" {medium}>'
        f'<flag contact="{touch}"/></option><worldbody>{bodies}</worldbody>'
        f"<tendon>{tendons}</tendon><actuator>{actuators}</actuator></mujoco>"
    )


def following(values: Array, step_s: float) -> Array:
    """The two controls of a spring drive that should follow `values`: themselves and their rate."""
    return np.column_stack([values, np.gradient(values, step_s)])


def simulated(
    text: str,
    controls: Array,
    step_s: float,
    start: Sequence[float] | Array = (),
    pieces: Sequence[tuple[int, Mapping[str, Array]]] = (),
) -> States:
    """Step a model through its controls (one row a step); row i of the states is before the controls of row i act.

    `start` holds the first positions and then the first activations (0 where it is empty). `pieces` are
    (first row, fields of the model that change there and the values that they get). Raises OutOfReach where the
    simulation is not stable, and NotInstalled.
    """
    mujoco, rollout = mujoco_and_rollout()
    model = mujoco.MjModel.from_xml_string(text)
    model.opt.timestep = step_s
    data = mujoco.MjData(model)
    if len(start):
        data.qpos[:] = start[: model.nq]
        data.act[:] = start[model.nq :]
    kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
    state = np.empty(mujoco.mj_stateSize(model, kind))
    mujoco.mj_getState(model, data, state, kind)
    states_so_far = [state[None, :]]
    begins = [row for row, _ in pieces] or [0]
    with unlogged(mujoco):
        for number, (first, last) in enumerate(zip(begins, [*begins[1:], len(controls)], strict=True)):
            for field, values in pieces[number][1].items() if pieces else ():
                getattr(model, field)[:] = values
                mujoco.mj_setConst(model, mujoco.MjData(model))
            if last > first:
                states, _ = rollout.rollout(model, data, states_so_far[-1][-1:], control=controls[None, first:last])
                states_so_far.append(states[0])
    rows = np.concatenate(states_so_far)[: len(controls)]
    if not np.isfinite(rows).all() or np.any(np.diff(rows[:, 0]) <= 0.0):  # from where it fails on, its clock stands
        raise OutOfReach("MuJoCo's simulation is not stable at this size")
    q, v = 1 + model.nq, 1 + model.nq + model.nv
    return States(rows[:, 1:q], rows[:, q:v], rows[:, v : v + model.na])
