"""The paper's invertible neural network: (θ, b, l, r, n) ↔ (x, b, l, r, n) through 7 coupling blocks.

What the paper fixes: 7 blocks with mixing layers between, nets of three fully connected layers of 256 ReLU
neurons, learning rates 8e-4, 4e-4, 1e-4, 5e-5. What it leaves open is chosen here:

- Reading of "each scale and shift net": GLOW's, one net of three ReLU layers and a linear output that gives s
  and t together, two nets a block. It halves the cost of a net each for s and t, and is what the common INN
  library does.
- The rates hold for equal quarters of the epochs; Adam; the mean squared error of all five outputs.
- `loss` "forward" trains on the outputs alone, "both" adds the inputs that the inverse gives, at twice the cost.
- `composite` "identity" closes the chain of permutations (see `coupling.mixing_layers`), without which
  "forward" ruins the inverse.
- The scaling of the inputs: standardised, n on a log(1 + n) axis, `log_stroke` false for n itself. On n itself
  the network fits the strokes it saw as well, but strays two strokes later.

The direction of motion is not among the five inputs, faithful to the paper: this model cannot tell winding from
unwinding, and half the hysteresis loop is its floor.

Source: Liu, Wei, Gao and Gong, "Kinematic Modeling of Twisted String Actuator Based on Invertible Neural Networks".
"""

from pathlib import Path
from typing import Annotated, Any, Literal

import pandas as pd
import torch
from pydantic import Field
from torch.nn.functional import mse_loss

from ..ground.kinematics import Array
from .about import About
from .parts.condition_columns import contraction_and_conditions, twist_and_conditions
from .parts.networks.coupling import InvertibleNet
from .parts.networks.training import SavedNetwork, minimise, read_weights, repeatable, tensor, write_weights
from .parts.scaling import Scaling
from .parts.settings import Batch, Blocks, Clamp, Drawn, Epochs, Layers, Rate, Width, checked, values

SIZE = 5


@checked
class Settings:
    """The network's shape and its training."""

    blocks: Blocks = 7
    width: Width = 256
    layers: Layers = 3
    clamp: Clamp = 1.0  # largest |s| of a block
    composite: Literal["identity", "random"] = "identity"
    permutation_seed: Drawn = 0
    loss: Literal["forward", "both"] = "forward"
    log_stroke: bool = True
    epochs: Epochs = 24
    batch: Batch = 125
    rates: Annotated[tuple[Rate, ...], Field(min_length=1, max_length=100, strict=False)] = (8e-4, 4e-4, 1e-4, 5e-5)


class Inn:
    """The paper-faithful INN with constant columns, leak and loss made safe or, by its settings, shown."""

    def __init__(self, **settings: object) -> None:
        self.settings = Settings(**settings)  # type: ignore[arg-type]

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Train from fresh weights on points; the seed draws the weights and the batches."""
        log_stroke = self.settings.log_stroke
        inputs = twist_and_conditions(points, log_stroke)
        outputs = contraction_and_conditions(points, log_stroke)
        self.inputs, self.outputs = Scaling.of(inputs), Scaling.of(outputs)
        x, y = tensor(self.inputs.scaled(inputs)), tensor(self.outputs.scaled(outputs))
        settings = self.settings

        def loss_of(rows: torch.Tensor) -> torch.Tensor:
            loss = mse_loss(self.network(x[rows]), y[rows])
            return loss if settings.loss == "forward" else loss + mse_loss(self.network.inverse(y[rows]), x[rows])

        with repeatable(seed):
            self.network = self._fresh()
            steps = [settings.rates[i * len(settings.rates) // settings.epochs] for i in range(settings.epochs)]
            minimise(self.network, loss_of, len(points), settings.batch, steps)

    @torch.no_grad()
    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm, shape (points,): the first of the five outputs."""
        scaled = self.inputs.scaled(twist_and_conditions(points, self.settings.log_stroke))
        return self.outputs.restored(self.network(tensor(scaled)).double().numpy())[:, 0]

    @torch.no_grad()
    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns, shape (points,): the first of the five inputs."""
        scaled = self.outputs.scaled(contraction_and_conditions(points, self.settings.log_stroke))
        return self.inputs.restored(self.network.inverse(tensor(scaled)).double().numpy())[:, 0]

    def save(self, path: Path) -> None:
        """Write settings, scalings and weights as plain values and tensors (they load without running code)."""
        scalings = [self.inputs.mean, self.inputs.std, self.outputs.mean, self.outputs.std]
        saved: SavedNetwork = {
            "settings": values(self.settings),
            "scalings": [torch.from_numpy(values) for values in scalings],
            "weights": self.network.state_dict(),
        }
        write_weights(path, saved)

    def load(self, path: Path) -> None:
        """Take over the settings, scalings and weights of a file."""
        saved = read_weights(path)
        settings: Any = saved["settings"]
        self.settings = Settings(**settings)
        scalings = [values.numpy() for values in saved["scalings"]]
        self.inputs, self.outputs = Scaling(*scalings[:2]), Scaling(*scalings[2:])
        with repeatable(0):
            self.network = self._fresh()
        self.network.load_state_dict(saved["weights"])

    def _fresh(self) -> InvertibleNet:
        """The untrained network of the settings."""
        s = self.settings
        return InvertibleNet(SIZE, s.blocks, s.width, s.layers, s.clamp, s.composite, s.permutation_seed)


MODEL = Inn
ABOUT = About(needs_torch=True)
