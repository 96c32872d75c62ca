"""A pair of small multilayer perceptrons, one forward and one inverse, that are told the direction of motion.

Each is the plain regression of its own output, so the two are not exact inverses of each other. Load, torsion zone,
stiffness and material are inputs where they vary.

Source: Rumelhart, Hinton and Williams, Nature 323, 1986; SiLU: Elfwing, Uchibe and Doya, Neural Networks 107, 2018.
"""

import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import torch
from torch import nn
from torch.nn.functional import mse_loss

from ..ground.kinematics import Array
from .about import About
from .parts.condition_columns import contraction_and_conditions, twist_and_conditions
from .parts.conditions import Conditions
from .parts.networks.training import SavedNetwork, minimise, read_weights, repeatable, tensor, write_weights
from .parts.scaling import Scaling
from .parts.settings import Batch, Epochs, Layers, Rate, Width, checked, values

BESIDE = ("torsion_zone_mm", "load_n", "stiffness_n_per_mm")  # b, l, r and n are inputs in any case


@checked
class Settings:
    """The networks' shape and their training."""

    width: Width = 64
    layers: Layers = 2
    epochs: Epochs = 240
    batch: Batch = 125
    rate: Rate = 8e-3  # of the first epoch; a quarter cosine takes it to nearly 0


class Mlp:
    """Two SiLU networks: (θ, b, l, r, n, direction) to x and (x, b, l, r, n, direction) to θ."""

    def __init__(self, **settings: object) -> None:
        self.settings = Settings(**settings)  # type: ignore[arg-type]

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Train both networks from fresh weights on points; the seed draws the weights and the batches."""
        self.conditions = Conditions.of(points, BESIDE)
        tables = [self._twist_side(points), self._contraction_side(points)]
        self.scalings = [Scaling.of(table) for table in tables]
        twist, contraction = (
            tensor(scaling.scaled(table)) for scaling, table in zip(self.scalings, tables, strict=True)
        )

        def loss_of(rows: torch.Tensor) -> torch.Tensor:
            forward, inverse = self.networks
            x, theta = contraction[rows], twist[rows]
            return mse_loss(forward(theta), x[:, :1]) + mse_loss(inverse(x), theta[:, :1])

        s = self.settings
        rates = [s.rate * (1 + math.cos(math.pi * epoch / s.epochs)) / 2 for epoch in range(s.epochs)]
        with repeatable(seed):
            self.networks = self._fresh(twist.shape[1])
            minimise(self.networks, loss_of, len(points), s.batch, rates)

    @torch.no_grad()
    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm, shape (points,)."""
        return self._predicted(0, self._twist_side(points))

    @torch.no_grad()
    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns, shape (points,)."""
        return self._predicted(1, self._contraction_side(points))

    def save(self, path: Path) -> None:
        """Write settings, scalings and weights as plain values and tensors (they load without running code)."""
        scalings = [values for scaling in self.scalings for values in (scaling.mean, scaling.std)]
        saved: SavedNetwork = {
            "settings": values(self.settings),
            "conditions": self.conditions.saved(),
            "scalings": [torch.from_numpy(values) for values in scalings],
            "weights": self.networks.state_dict(),
        }
        write_weights(path, saved)

    def load(self, path: Path) -> None:
        """Take over the settings, scalings and weights of a file."""
        saved = read_weights(path)
        settings: Any = saved["settings"]
        self.settings = Settings(**settings)
        self.conditions = Conditions.from_saved(saved["conditions"])
        scalings = [values.numpy() for values in saved["scalings"]]
        self.scalings = [Scaling(*scalings[:2]), Scaling(*scalings[2:])]
        with repeatable(0):
            self.networks = self._fresh(len(scalings[0]))
        self.networks.load_state_dict(saved["weights"])

    def _predicted(self, side: int, table: Array) -> Array:
        """First column of the other side's table for this side's, in its own units, shape (points,)."""
        scaled = self.networks[side](tensor(self.scalings[side].scaled(table)))[:, 0].double().numpy()
        other = self.scalings[1 - side]
        return np.asarray(scaled * other.std[0] + other.mean[0])

    def _twist_side(self, points: pd.DataFrame) -> Array:
        return np.column_stack([twist_and_conditions(points), points["direction"], self.conditions.table(points)])

    def _contraction_side(self, points: pd.DataFrame) -> Array:
        return np.column_stack([contraction_and_conditions(points), points["direction"], self.conditions.table(points)])

    def _fresh(self, inputs: int) -> nn.ModuleList:
        """The untrained forward and inverse network of the settings."""
        return nn.ModuleList(_silu_net(inputs, self.settings.width, self.settings.layers) for _ in range(2))


def _silu_net(inputs: int, width: int, layers: int) -> nn.Sequential:
    """Smooth hidden layers, since the kinematics are smooth, and a linear output."""
    sizes = [inputs] + [width] * layers
    hidden = [part for a, b in pairwise(sizes) for part in (nn.Linear(a, b), nn.SiLU())]
    return nn.Sequential(*hidden, nn.Linear(width, 1))


MODEL = Mlp
ABOUT = About(needs_torch=True)
