"""The weights of a fitted network as plain numpy arrays, layer by layer."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Weights = NDArray[np.float32]


@dataclass(frozen=True)
class Layer:
    """One fully connected layer: `weight` of shape (inputs, outputs), `bias` of shape (outputs,), without units."""

    weight: Weights
    bias: Weights


@dataclass(frozen=True)
class Blocks:
    """A chain of coupling blocks: each block's two nets, the permutations between, the bound of every scale."""

    first: int  # columns of the half that net_1 reads
    second: int
    net_1: list[list[Layer]]
    net_2: list[list[Layer]]
    mixing: list[list[int]]
    unmixing: list[list[int]]
    bound: float  # clamp · 2/π


def layers(net: Any) -> list[Layer]:
    """The linear layers of a torch Sequential, in order."""
    return [
        Layer(part.weight.detach().numpy().T.copy(), part.bias.detach().numpy().copy())
        for part in net
        if hasattr(part, "weight")
    ]


def blocks(network: Any) -> Blocks:
    """The chain that a `coupling.InvertibleNet` is."""
    chain = list(network.blocks)
    return Blocks(
        chain[0].first,
        chain[0].second,
        [layers(block.net_1) for block in chain],
        [layers(block.net_2) for block in chain],
        [permutation.tolist() for permutation in network.mixing],
        [permutation.tolist() for permutation in network.unmixing],
        chain[0].clamp * 2.0 / np.pi,
    )
