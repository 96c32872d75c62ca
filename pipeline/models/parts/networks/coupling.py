"""The paper's coupling blocks (eqs 6, 7) and the mixing layers between them, as torch modules.

Source: Dinh, Sohl-Dickstein and Bengio, "Density estimation using Real NVP", ICLR 2017; Kingma and Dhariwal, "Glow",
NeurIPS 2018; He et al., "Delving Deep into Rectifiers", ICCV 2015 (the first weights).
"""

from itertools import pairwise
from typing import cast

import torch
from torch import Tensor, nn


def relu_net(inputs: int, outputs: int, width: int, layers: int) -> nn.Sequential:
    """`layers` fully connected ReLU layers of `width` neurons, then a linear layer that starts at zero.

    So every block starts as the identity: the inverse of a fresh network cannot blow up. The hidden layers start
    with He's weights: with torch's smaller ones narrow nets stay on the plateau around the identity.
    """
    net = nn.Sequential()
    for size, next_size in pairwise([inputs] + [width] * layers):
        hidden = nn.Linear(size, next_size)
        nn.init.kaiming_normal_(hidden.weight, nonlinearity="relu")
        net.extend([hidden, nn.ReLU()])
    last = nn.Linear(width, outputs)
    nn.init.zeros_(last.weight)
    nn.init.zeros_(last.bias)
    return net.append(last)


class Coupling(nn.Module):
    """One invertible block: y₁ = x₁·exp(s₂(x₂)) + t₂(x₂), y₂ = x₂·exp(s₁(y₁)) + t₁(y₁) (eq. 6, corrected).

    As printed, the second line has s₁(y₂) and t₂(y₁), implicit and not what eq. 7 inverts. Each s is bounded
    softly, clamp·(2/π)·atan(s): the paper says only that exp avoids "numerical complications", and without a
    bound the inverse loses its digits away from the data. Conditions, which pass through unmoved, are read by both
    nets beside the half that they know.
    """

    def __init__(self, size: int, width: int, layers: int, clamp: float, conditions: int = 0) -> None:
        super().__init__()
        self.first, self.second, self.clamp = size // 2, size - size // 2, clamp
        self.net_1 = relu_net(self.first + conditions, 2 * self.second, width, layers)  # s₁, t₁: read y₁, move x₂
        self.net_2 = relu_net(self.second + conditions, 2 * self.first, width, layers)  # s₂, t₂: read x₂, move x₁

    def forward(self, x: Tensor, conditions: Tensor | None = None) -> Tensor:
        """y for x, both (points, size), under conditions, shape (points, conditions); all without units (eq. 6)."""
        x_1, x_2 = x.split([self.first, self.second], dim=1)
        s_2, t_2 = self._scale_and_shift(self.net_2, x_2, conditions)
        y_1 = x_1 * torch.exp(s_2) + t_2
        s_1, t_1 = self._scale_and_shift(self.net_1, y_1, conditions)
        return torch.cat([y_1, x_2 * torch.exp(s_1) + t_1], dim=1)

    def inverse(self, y: Tensor, conditions: Tensor | None = None) -> Tensor:
        """x for y, both of shape (points, size) (eq. 7); without a unit. x₂ comes first: x₁ needs it."""
        y_1, y_2 = y.split([self.first, self.second], dim=1)
        s_1, t_1 = self._scale_and_shift(self.net_1, y_1, conditions)
        x_2 = (y_2 - t_1) * torch.exp(-s_1)
        s_2, t_2 = self._scale_and_shift(self.net_2, x_2, conditions)
        return torch.cat([(y_1 - t_2) * torch.exp(-s_2), x_2], dim=1)

    def _scale_and_shift(self, net: nn.Sequential, half: Tensor, conditions: Tensor | None) -> tuple[Tensor, Tensor]:
        scale, shift = net(half if conditions is None else torch.cat([half, conditions], dim=1)).chunk(2, dim=1)
        return self.clamp * (2.0 / torch.pi) * torch.atan(scale), shift


def mixing_layers(count: int, size: int, composite: str, seed: int) -> list[Tensor]:
    """`count` permutations of `size` columns, each of shape (size,), drawn by the seed; layer p maps x to x[:, p].

    Each takes at least one column across the split of the blocks, or it would mix nothing. `composite`
    "random" leaves their product to chance: then output x may be fed from input b, and a network trained on
    its forward error alone leaks through constant inputs into the inverse. "identity" closes the chain with
    the inverse of the others, so that θ comes out as x and b, l, r, n as themselves. Layers hold columns, as indices.
    """
    if composite not in ("identity", "random"):
        raise ValueError(f'composite: "{composite}" is neither "identity" nor "random"')
    generator = torch.Generator().manual_seed(seed)

    def mixes(permutation: Tensor) -> bool:
        return bool((permutation[: size // 2] >= size // 2).any())

    while True:
        layers = [torch.randperm(size, generator=generator) for _ in range(count)]
        if composite == "identity" and layers:
            layers[-1] = torch.argsort(product(layers[:-1], size))
        # A single layer whose composite is the identity can only be the identity itself.
        if all(map(mixes, layers)) or (composite == "identity" and count < 2):
            return layers


def product(layers: list[Tensor], size: int) -> Tensor:
    """The one permutation that equals the layers one after the other. Shape (size,): columns, as indices."""
    columns = torch.arange(size)
    for permutation in layers:
        columns = columns[permutation]
    return columns


class InvertibleNet(nn.Module):
    """Coupling blocks with mixing layers between them, from (points, size) to (points, size) and back."""

    def __init__(
        self,
        size: int,
        blocks: int,
        width: int,
        layers: int,
        clamp: float,
        composite: str,
        seed: int,
        conditions: int = 0,
    ) -> None:
        super().__init__()
        self.blocks = nn.ModuleList(Coupling(size, width, layers, clamp, conditions) for _ in range(blocks))
        self.mixing = mixing_layers(blocks - 1, size, composite, seed)
        self.unmixing = [torch.argsort(permutation) for permutation in self.mixing]

    def forward(self, x: Tensor, conditions: Tensor | None = None) -> Tensor:
        """Outputs for inputs, both of shape (points, size); without a unit, as they are standardised."""
        for number, block in enumerate(self.blocks):
            x = block(x if number == 0 else x[:, self.mixing[number - 1]], conditions)
        return x

    def inverse(self, y: Tensor, conditions: Tensor | None = None) -> Tensor:
        """Inputs for outputs, both of shape (points, size): the blocks backwards; without a unit."""
        for number in reversed(range(len(self.blocks))):
            y = cast(Coupling, self.blocks[number]).inverse(y, conditions)
            y = y if number == 0 else y[:, self.unmixing[number - 1]]
        return y
