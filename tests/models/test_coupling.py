"""A coupling block is the corrected eq. 6 and eq. 7; the mixing layers compose as asked."""

import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

from pipeline.models.parts.networks.coupling import Coupling, InvertibleNet, mixing_layers, product
from pipeline.models.parts.networks.training import repeatable


def shaken(module: torch.nn.Module) -> torch.nn.Module:
    """The module with every weight drawn: the zero last layers would hide most mistakes."""
    with torch.no_grad():
        for weights in module.parameters():
            weights.normal_(0.0, 0.3)
    return module.double()


@torch.no_grad()
def test_a_block_is_eq_6_with_its_second_line_corrected() -> None:
    with repeatable(0):
        block, x = shaken(Coupling(5, 8, 3, 1.0)), torch.randn(20, 5).double()

    def soft(s: torch.Tensor) -> torch.Tensor:
        return torch.atan(s) * 2 / torch.pi

    x_1, x_2 = x[:, :2], x[:, 2:]
    out_2 = block.net_2(x_2)
    y_1 = x_1 * torch.exp(soft(out_2[:, :2])) + out_2[:, 2:]
    out_1 = block.net_1(y_1)
    y_2 = x_2 * torch.exp(soft(out_1[:, :3])) + out_1[:, 3:]
    torch.testing.assert_close(block(x), torch.cat([y_1, y_2], dim=1))


def test_a_subnet_is_three_relu_layers_of_256_and_a_linear_output() -> None:
    kinds = [type(part).__name__ for part in Coupling(5, 256, 3, 1.0).net_1]
    assert kinds == ["Linear", "ReLU"] * 3 + ["Linear"]
    assert sum(weights.numel() for weights in InvertibleNet(5, 7, 256, 3, 1.0, "identity", 0).parameters()) == (
        7 * sum(a * 256 + 256 + 2 * (256 * 256 + 256) + 256 * 2 * b + 2 * b for a, b in ((2, 3), (3, 2)))
    )


@given(seed=st.integers(0, 1000), size=st.integers(2, 7), blocks=st.integers(1, 5))
@torch.no_grad()
def test_eq_7_undoes_eq_6(seed: int, size: int, blocks: int) -> None:
    with repeatable(seed):
        net, x = shaken(InvertibleNet(size, blocks, 8, 2, 1.0, "random", seed)), torch.randn(30, size).double()
    torch.testing.assert_close(net.inverse(net(x)), x, rtol=1e-8, atol=1e-8)
    torch.testing.assert_close(net(net.inverse(x)), x, rtol=1e-8, atol=1e-8)


@given(seed=st.integers(0, 1000), size=st.integers(3, 7), count=st.integers(2, 8))
def test_the_identity_composite_is_one_and_every_layer_mixes(seed: int, size: int, count: int) -> None:
    layers = mixing_layers(count, size, "identity", seed)
    assert len(layers) == count
    assert product(layers, size).tolist() == list(range(size))
    for permutation in layers:
        assert sorted(permutation.tolist()) == list(range(size))
        assert (permutation[: size // 2] >= size // 2).any()


def test_random_composites_are_random() -> None:
    composites = {tuple(product(mixing_layers(6, 5, "random", seed), 5).tolist()) for seed in range(20)}
    assert len(composites) > 10


def test_a_fresh_net_is_its_composite() -> None:
    x = torch.arange(10.0).reshape(2, 5)
    torch.testing.assert_close(InvertibleNet(5, 7, 8, 3, 1.0, "identity", 0)(x), x, rtol=0, atol=0)


@torch.no_grad()
def test_the_scale_is_bounded_however_far_the_input() -> None:
    block = shaken(Coupling(4, 8, 2, 0.5))
    scale, _ = block._scale_and_shift(block.net_1, torch.full((1, 2), 1e12).double(), None)
    assert scale.abs().max() <= 0.5


def test_an_unknown_composite_is_refused() -> None:
    with pytest.raises(ValueError, match="identity"):
        mixing_layers(3, 5, "reverse", 0)
