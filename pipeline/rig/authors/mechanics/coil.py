"""Laws of overtwist: a coil that forms late and melts early, so that the string runs ahead with a loop of its own."""

import numpy as np

from pipeline.rig.authors.mechanics.engine import HARD_SOLREF, following, model_text, simulated, spring_drive
from pipeline.rig.authors.mechanics.scene import STEP_S, Law, Scene, proportional

PULSE = 2.0 * np.pi * 6.0  # of a coil that springs open, in rad/s
REACH = 0.02  # turns over which strands still stick to each other


def _opened(scene: Scene, melts: float, sticks: float) -> np.ndarray:
    """How far coils stand open, in turns: past `melts` turns they would, but first they stick by adhesion."""
    touch = f'solref="{HARD_SOLREF}" solimp="0.999 0.9999 0.001 0.5 2" condim="1" margin="{REACH}" gap="{REACH}"'
    lift = f'<joint name="coil" type="slide" axis="0 0 1"/><geom type="sphere" size="1" {touch}/>'
    inertia = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
    bodies = f'<geom type="plane" size="0 0 1" pos="0 0 -1" {touch}/><body name="strands">{inertia}{lift}</body>'
    adhesion = f'<adhesion body="strands" ctrlrange="0 1" gain="{PULSE**2 * sticks:.9g}"/>'
    text = model_text(bodies, spring_drive("coil", PULSE, 0.7) + adhesion, contact=True)
    wanted = np.maximum(scene.turns - melts, -0.05)
    controls = np.column_stack([following(wanted, STEP_S), np.ones(len(wanted))])
    return np.maximum(simulated(text, controls, STEP_S, [0.0]).position[:, 0], 0.0)


def adhering_coil(scene: Scene, draw: np.random.Generator) -> Law:
    """A coil sticks by MuJoCo's adhesion until the twist tears it open, and lies down again at a smaller twist."""
    top = float(scene.turns.max())
    melts, sticks = float(draw.uniform(0.5, 0.78)) * top, float(draw.uniform(0.04, 0.12)) * top
    shape = _opened(scene, melts, sticks)
    return proportional("length", "largest_mm", 6.0, shape, {"melts_turns": melts, "sticks_turns": sticks})


def two_coils(scene: Scene, draw: np.random.Generator) -> Law:
    """Two coils, the second past a larger twist than the first."""
    top = float(scene.turns.max())
    melts = np.array([draw.uniform(0.45, 0.6), draw.uniform(0.65, 0.8)]) * top
    sticks = draw.uniform(0.03, 0.1, 2) * top
    shape = sum(_opened(scene, *pair) for pair in zip(melts.tolist(), sticks.tolist(), strict=True))
    parameters = {"first_melts_turns": melts[0], "second_melts_turns": melts[1], "sticks_turns": sticks[0]}
    numbers = {name: float(value) for name, value in parameters.items()}
    return proportional("length", "largest_mm", 6.0, np.asarray(shape), numbers)
