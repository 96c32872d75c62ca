"""A conditional INN on top of eq. 4: small coupling blocks that bend what the physics says, knowing the direction.

As the paper's INN it maps five numbers to five, but the first is eq. 4's contraction, not θ: the physics bends the
curve and the network corrects it, so that fewer and narrower blocks do. Contractions enter and leave as roots √(x + c),
about proportional to the twist: in x itself, which grows as θ² at first, the first turns are too small for a network to
see. The direction of motion, and where they vary the load, the torsion zone, the stiffness and the material, are
conditions that every block reads. The permutations compose to the identity (`coupling.mixing_layers`), so the forward
error alone trains both ways. θ follows by the blocks backwards and eq. 5. Backwards the blocks want b, l, r and n as
they came out, which is a little off: a few steps of the secant make good for it, and both ways undo each other.

Source: Ardizzone et al., "Guided Image Generation with Conditional Invertible Neural Networks", arXiv:1907.02392,
2019.
"""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import torch
from torch.nn.functional import mse_loss

from ..ground.kinematics import Array, point_contraction_mm, point_motor_turns
from .about import About
from .parts.box import Box
from .parts.condition_columns import conditions
from .parts.conditions import Conditions
from .parts.networks.coupling import InvertibleNet
from .parts.networks.secant import FLATTEST, NEAREST, SECANTS, STEEPEST
from .parts.networks.training import SavedNetwork, minimise, read_weights, repeatable, tensor, write_weights
from .parts.scaling import Scaling
from .parts.settings import Batch, Blocks, Clamp, Drawn, Epochs, Layers, Rate, Width, checked, values

SIZE = 5
BESIDE = ("torsion_zone_mm", "load_n", "stiffness_n_per_mm")  # b, l, r and n are among the five
WARM_UP = 0.1  # of the epochs
ABOVE_ZERO = 0.005  # of the contraction's range, that the root's argument stays above 0 in the whole box


@checked
class Settings:
    """The network's shape, its training, and what it is told."""

    blocks: Blocks = 5
    width: Width = 32
    layers: Layers = 2
    clamp: Clamp = 1.0
    permutation_seed: Drawn = 0
    epochs: Epochs = 60
    batch: Batch = 125
    rate: Rate = 4e-3  # the highest; it rises to it and falls as a cosine
    direction: bool = True  # whether it may know winding from unwinding


class Cinn:
    """The conditional INN with eq. 4 as its base."""

    def __init__(self, **settings: object) -> None:
        self.settings = Settings(**settings)  # type: ignore[arg-type]

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Train from fresh weights on points; the seed draws the weights and the batches."""
        self.box, self.conditions = Box.of(points), Conditions.of(points, BESIDE)
        low_mm, high_mm = self.box.low["displacement_mm"], self.box.high["displacement_mm"]
        self.shift_mm = max(-low_mm, 0.0) + ABOVE_ZERO * (high_mm - low_mm)
        inputs, outputs = self._physics_side(points), self._measured_side(points)
        self.inputs, self.outputs = Scaling.of(inputs), Scaling.of(outputs)
        x, y = tensor(self.inputs.scaled(inputs)), tensor(self.outputs.scaled(outputs))
        net_conditions, s = tensor(self._given(points)), self.settings
        warm = max(1, round(WARM_UP * s.epochs))
        rates = [s.rate * min((i + 1) / warm, (1 + math.cos(math.pi * i / s.epochs)) / 2) for i in range(s.epochs)]
        with repeatable(seed):
            self.network = self._fresh()
            minimise(
                self.network,
                lambda rows: mse_loss(self.network(x[rows], net_conditions[rows]), y[rows]),
                len(points),
                s.batch,
                rates,
            )

    @torch.no_grad()
    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm, shape (points,): the first of the five outputs."""
        scaled = tensor(self.inputs.scaled(self._physics_side(points)))
        root = self.outputs.restored(self.network(scaled, tensor(self._given(points))).double().numpy())[:, 0]
        return np.asarray(np.square(root) - self.shift_mm)

    @torch.no_grad()
    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns, shape (points,), within the twists that were seen."""
        net_conditions, wanted = tensor(self._given(points)), tensor(self.outputs.scaled(self._measured_side(points)))
        # b, l, r and n are the same numbers on both sides, and so are their scalings
        reached = self.network.inverse(wanted, net_conditions)[:, :1]
        slope, last, missed = torch.ones_like(reached), reached, torch.zeros_like(reached)
        for step in range(SECANTS):
            short = wanted[:, :1] - self.network(torch.cat([reached, wanted[:, 1:]], dim=1), net_conditions)[:, :1]
            if step:
                apart = reached - last
                secant = ((missed - short) / torch.where(apart.abs() < NEAREST, NEAREST, apart)).clamp(
                    FLATTEST, STEEPEST
                )
                slope = torch.where(apart.abs() < NEAREST, slope, secant)
            last, missed, reached = reached, short, reached + short / slope
        root = self.inputs.restored(torch.cat([reached, wanted[:, 1:]], dim=1).double().numpy())[:, 0]
        base_mm = np.square(root) - self.shift_mm
        return self.box.clipped("motor_turns", point_motor_turns(points.assign(displacement_mm=base_mm)))

    def save(self, path: Path) -> None:
        """Write settings, scalings and weights as plain values and tensors (they load without running code)."""
        scalings = [self.inputs.mean, self.inputs.std, self.outputs.mean, self.outputs.std]
        saved: SavedNetwork = {
            "settings": values(self.settings),
            "box": self.box.saved(),
            "conditions": self.conditions.saved(),
            "shift_mm": self.shift_mm,
            "scalings": [torch.from_numpy(values) for values in scalings],
            "weights": self.network.state_dict(),
        }
        write_weights(path, saved)

    def load(self, path: Path) -> None:
        """Take over what a file holds."""
        saved = read_weights(path)
        settings: Any = saved["settings"]
        self.settings = Settings(**settings)
        self.box, self.conditions = Box.from_saved(saved["box"]), Conditions.from_saved(saved["conditions"])
        self.shift_mm = saved["shift_mm"]
        scalings = [values.numpy() for values in saved["scalings"]]
        self.inputs, self.outputs = Scaling(*scalings[:2]), Scaling(*scalings[2:])
        with repeatable(0):
            self.network = self._fresh()
        self.network.load_state_dict(saved["weights"])

    def _physics_side(self, points: pd.DataFrame) -> Array:
        """Root of the contraction by eq. 4, then b, l, r and n, shape (points, 5)."""
        return np.column_stack([self._root(point_contraction_mm(points)), conditions(points, log_stroke=True)])

    def _measured_side(self, points: pd.DataFrame) -> Array:
        """Root of the measured contraction, then b, l, r and n, shape (points, 5)."""
        measured_mm = points["displacement_mm"].to_numpy(float)
        return np.column_stack([self._root(measured_mm), conditions(points, log_stroke=True)])

    def _root(self, contraction_mm: Array) -> Array:
        """√(x + c); values below −c, beyond the box, are taken as −c."""
        return np.sqrt(np.maximum(contraction_mm + self.shift_mm, 0.0))

    def _given(self, points: pd.DataFrame) -> Array:
        """The conditions of the blocks, shape (points, conditions): direction, then the other conditions that vary."""
        way = points["direction"].to_numpy(float)[:, None]
        others = self.conditions.table(points)
        return np.column_stack([way, others]) if self.settings.direction else others

    def _fresh(self) -> InvertibleNet:
        """The untrained network of the settings."""
        s, condition_count = self.settings, self.conditions.size + self.settings.direction
        return InvertibleNet(
            SIZE, s.blocks, s.width, s.layers, s.clamp, "identity", s.permutation_seed, conditions=condition_count
        )


MODEL = Cinn
ABOUT = About(needs_torch=True)
