"""What the INN and the MLP are held to beyond the interface."""

import logging
import subprocess
import sys

import numpy as np
import pandas as pd
import pytest
import torch
from made_dataset import made_dataset

from pipeline.ground.words import progress
from pipeline.models.inn import Inn
from pipeline.models.mlp import Mlp
from pipeline.models.parts.condition_columns import contraction_and_conditions, twist_and_conditions
from pipeline.models.parts.networks.coupling import mixing_layers, product
from pipeline.models.parts.networks.training import Adam, minimise, repeatable, tensor
from pipeline.models.parts.scaling import Scaling

SMALL = {"width": 32, "layers": 2, "epochs": 24, "batch": 60, "rates": (4e-3, 2e-3, 5e-4, 2e-4)}

B_FEEDS_X = {"permutation_seed": 1, "epochs": 16}  # of the random chains one that takes output x from input b


def rmse(error: np.ndarray) -> float:
    return float(np.sqrt(np.mean(np.square(error))))


def trained(points: pd.DataFrame, seed: int = 0, **settings: object) -> Inn:
    model = Inn(**{**SMALL, **settings})
    model.fit(points, seed)
    return model


def test_constant_columns_become_zeros_and_others_standard() -> None:
    values = np.column_stack([np.arange(10.0), np.full(10, 0.1) + 1e-17, np.full(10, 400.0), np.zeros(10)])
    scaling = Scaling.of(values)
    assert scaling.std[1:].tolist() == [1.0, 1.0, 1.0]
    scaled = scaling.scaled(values)
    np.testing.assert_allclose([scaled[:, 0].mean(), scaled[:, 0].std()], [0.0, 1.0], atol=1e-12)
    np.testing.assert_allclose(scaled[:, 1:], 0.0, atol=1e-12)
    np.testing.assert_allclose(scaling.restored(scaled), values)


def test_a_small_difference_of_radius_is_not_a_constant() -> None:
    assert Scaling.of(np.array([[0.4], [0.4001]])).std[0] == pytest.approx(5e-5)


def test_features_are_the_papers_five(points: pd.DataFrame, pair_points: pd.DataFrame) -> None:
    row = points.iloc[[70]]
    theta, x, log_2 = row["motor_turns"].item(), row["displacement_mm"].item(), float(np.log1p(1.0))
    assert twist_and_conditions(row, False).tolist() == [[theta, 8.0, 400.0, 0.4, 1.0]]
    assert contraction_and_conditions(row, False).tolist() == [[x, 8.0, 400.0, 0.4, 1.0]]
    assert twist_and_conditions(row).tolist() == [[theta, 8.0, 400.0, 0.4, log_2]]
    assert (twist_and_conditions(pair_points)[:, 1] == 0.0).all()
    without = pair_points.drop(columns="separator_mm")
    np.testing.assert_array_equal(twist_and_conditions(without), twist_and_conditions(pair_points))


def test_the_inn_comes_back_to_where_it_started(points: pd.DataFrame) -> None:
    model = trained(points)
    x = tensor(model.inputs.scaled(twist_and_conditions(points)))
    with torch.no_grad():
        assert (model.network.inverse(model.network(x)) - x).abs().max() < 1e-5


def test_the_inn_has_no_direction(points: pd.DataFrame) -> None:
    model = trained(points, epochs=2)
    np.testing.assert_array_equal(model.forward(points.assign(direction=0)), model.forward(points))


def test_the_chain_of_the_next_tests_feeds_x_from_b() -> None:
    assert product(mixing_layers(6, 5, "random", B_FEEDS_X["permutation_seed"]), 5)[0] == 1


@pytest.mark.long
def test_the_identity_composite_cures_what_forward_loss_does_to_the_inverse(points: pd.DataFrame) -> None:
    """A random chain feeds output x from a constant input; both kinds fit forward, one also inverts."""
    truth = points["motor_turns"].to_numpy()
    cured, ill = (trained(points, composite=composite, **B_FEEDS_X) for composite in ("identity", "random"))
    assert rmse(ill.forward(points) - points["displacement_mm"]) < 0.5
    assert rmse(cured.inverse(points) - truth) < 0.5 * rmse(ill.inverse(points) - truth)


@pytest.mark.long
def test_a_loss_of_both_ways_trains_the_inverse_too(points: pd.DataFrame) -> None:
    truth = points["motor_turns"].to_numpy()
    ill, both = (trained(points, composite="random", loss=loss, **B_FEEDS_X) for loss in ("forward", "both"))
    assert rmse(both.inverse(points) - truth) < 0.7 * rmse(ill.inverse(points) - truth)


def test_inn_rates_hold_for_equal_quarters(points: pd.DataFrame, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[float] = []
    monkeypatch.setattr("pipeline.models.inn.minimise", lambda *words: seen.extend(words[-1]))
    Inn(epochs=8, width=4).fit(points, 0)
    assert seen == [8e-4, 8e-4, 4e-4, 4e-4, 1e-4, 1e-4, 5e-5, 5e-5]


def test_the_optimiser_steps_as_torchs_own_to_the_last_bit() -> None:
    ways = []
    for kind in (Adam, torch.optim.Adam):
        with repeatable(3):
            net = torch.nn.Sequential(torch.nn.Linear(3, 9), torch.nn.Tanh(), torch.nn.Linear(9, 1), torch.nn.Dropout())
            optimiser = kind(net.parameters(), lr=3e-3, fused=True)
            for step in range(40):
                optimiser.param_groups[0]["lr"] = 3e-3 / (1 + step)
                optimiser.zero_grad()
                net(torch.randn(7, 3)).square().sum().backward()
                optimiser.step()
        ways.append([each.detach().numpy().tobytes() for each in net.parameters()])
    assert ways[0] == ways[1]


FITS = """
import sys
import torch
from pipeline.models.parts.networks.training import minimise, repeatable
with repeatable(0):
    net = torch.nn.Linear(1, 1)
    minimise(net, lambda rows: net(rows[:, None].float()).square().mean(), 4, 2, (0.1,))
    assert torch.are_deterministic_algorithms_enabled()
compiler = [name for name in sys.modules if name.startswith(("torch._dynamo", "torch._inductor"))]
sys.exit(f"it imported {compiler[0]}" if compiler else 0)
"""


def test_a_fit_does_not_import_torchs_compiler() -> None:
    done = subprocess.run([sys.executable, "-c", FITS], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_the_mlp_uses_the_direction() -> None:
    points = made_dataset(60)
    model = Mlp(width=32, epochs=60, batch=60)
    model.fit(points, 0)
    top = points["motor_turns"] > 15
    up, down = (model.forward(points.assign(direction=sign))[top] for sign in (1, -1))
    # Unwinding, the string is ±0.1 turn behind the motor: it is the shorter one.
    assert 0.05 < (down - up).mean() < 0.6
    knowing = rmse(model.forward(points) - points["displacement_mm"])
    assert knowing < rmse(model.forward(points.assign(direction=-points["direction"])) - points["displacement_mm"])


@pytest.mark.parametrize("settings", [{"loss": "backward"}, {"composite": "none"}])
def test_unknown_settings_are_refused(settings: dict[str, str], points: pd.DataFrame) -> None:
    with pytest.raises(ValueError, match=next(iter(settings))):
        Inn(**settings, width=4, epochs=1).fit(points, 0)
    with pytest.raises(ValueError, match="depth"):
        Inn(depth=3)
    with pytest.raises(ValueError, match="depth"):
        Mlp(depth=3)


def test_progress_is_logged_and_a_lost_loss_is_an_error(
    caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(progress, "LOGGED_S", 0.0)
    net = torch.nn.Linear(1, 1)
    with caplog.at_level(logging.INFO):
        minimise(net, lambda rows: net(rows[:, None].float()).square().mean(), 10, 4, [0.1, 0.1])
    assert [record.message.split(",")[0] for record in caplog.records] == ["epoch 2 of 2"]
    assert capsys.readouterr().err == "epoch 1 of 2, 0 s so far\nepoch 2 of 2, 0 s so far\n"
    with pytest.raises(ArithmeticError, match="nan in epoch 1"):
        minimise(net, lambda rows: net(rows[:, None].float()).mean() * torch.nan, 10, 4, [0.1])


def test_the_inn_is_the_papers_by_default() -> None:
    from pipeline.models.inn import Settings

    default = Settings()
    assert (default.blocks, default.width, default.layers) == (7, 256, 3)
    assert default.rates == (8e-4, 4e-4, 1e-4, 5e-5)
    assert default.composite == "identity" and default.log_stroke
