"""With copied weights our coupling blocks are those of FrEIA, the library that INN papers are written with."""

import math

import pytest
import torch
from FrEIA import modules as freia

from pipeline.models.parts.networks.coupling import Coupling, InvertibleNet, relu_net
from pipeline.models.parts.networks.training import repeatable

# FrEIA bounds s by clamp · 0.636 · atan, we by clamp · (2/π) · atan, of which 0.636 is the rounded value.
ROUNDED = 0.636 * math.pi / 2.0


def theirs(ours: Coupling, conditions: int) -> torch.nn.Module:
    """FrEIA's block with the weights of ours."""
    size = ours.first + ours.second
    block = freia.GLOWCouplingBlock(
        [(size,)],
        dims_c=[(conditions,)] if conditions else [],
        subnet_constructor=lambda inputs, outputs: relu_net(inputs, outputs, 16, 2),
        clamp=ours.clamp / ROUNDED,
    ).double()
    block.subnet1.load_state_dict(ours.net_1.state_dict())
    block.subnet2.load_state_dict(ours.net_2.state_dict())
    return block


@pytest.mark.parametrize("size", [2, 4, 5])
@pytest.mark.parametrize("conditions", [0, 3])
@pytest.mark.parametrize("clamp", [0.7, 2.0])
@torch.no_grad()
def test_a_block_is_freias_both_ways(size: int, conditions: int, clamp: float) -> None:
    with repeatable(size):
        block = Coupling(size, 16, 2, clamp, conditions).double()
        for weights in block.parameters():
            weights.normal_(0.0, 0.5)
        x, condition = torch.randn(50, size).double(), torch.randn(50, conditions).double() if conditions else None
    oracle, condition_list = theirs(block, conditions), [condition] if conditions else []
    (expected,), _ = oracle([x], condition_list, rev=False)
    (back,), _ = oracle([x], condition_list, rev=True)
    torch.testing.assert_close(block(x, condition), expected, rtol=1e-12, atol=1e-12)
    torch.testing.assert_close(block.inverse(x, condition), back, rtol=1e-12, atol=1e-12)
    assert (block(x, condition) - x).abs().max() > 0.1


@torch.no_grad()
def test_a_whole_net_is_freias_blocks_and_permutations() -> None:
    with repeatable(1):
        net, x = InvertibleNet(5, 4, 16, 2, 1.0, "random", 3).double(), torch.randn(40, 5).double()
        for weights in net.parameters():
            weights.normal_(0.0, 0.3)
    expected = x
    for number, block in enumerate(net.blocks):
        if number:
            fixed = freia.PermuteRandom([(5,)])
            fixed.perm = torch.nn.Parameter(net.mixing[number - 1], requires_grad=False)
            (expected,), _ = fixed([expected])
        (expected,), _ = theirs(block, 0)([expected])
    torch.testing.assert_close(net(x), expected, rtol=1e-11, atol=1e-11)
