"""Fitted INNs → why their inverse errs: by the displacement's residual, or by inputs that should pass unchanged.

An INN's inverse is exact: fed with the network's own outputs it gives the twist without error. Measured points differ
from these outputs twice, by the displacement's residual and because the network does not hand on b, l, r, n exactly
(the leak). Each is taken alone.
"""

from pathlib import Path

import numpy as np
import pandas as pd
import torch

from ..ground.errors import program
from ..ground.input.outputs import file_to_write
from ..ground.input.parser import Parser
from ..ground.kinematics import Array
from ..ground.stored import schemas
from ..models.inn import Inn
from ..models.parts.condition_columns import contraction_and_conditions, twist_and_conditions
from ..models.parts.networks.training import repeatable, tensor
from .train import divided

SPLIT = "within"
CONDITIONS = ("b", "l", "r", "n")  # the outputs behind the displacement, in their order
SLOPE_POINTS = 2000  # at which the inverse is differentiated


def rms(errors: Array) -> float:
    """Root of the mean square. Errors of any shape; in their unit."""
    return float(np.sqrt(np.mean(np.square(errors))))


def slopes(model: Inn, outputs: torch.Tensor) -> Array:
    """Size of the derivative of θ by each output of the network, in standard deviations, shape (points, 5).

    It is a number without a unit.
    """
    sampled = outputs[:: max(len(outputs) // SLOPE_POINTS, 1)].clone().requires_grad_(True)
    (gradient,) = torch.autograd.grad(model.network.inverse(sampled)[:, 0].sum(), sampled)
    return np.asarray(gradient.abs().double().numpy())


def decomposed(model: Inn, points: pd.DataFrame) -> pd.DataFrame:
    """Errors of a fitted INN at points, taken apart; columns map, metric, unit and value.

    `rmse` is the error as of any model; `leak_rmse` the inverse's at the network's own displacement and the true
    b, l, r, n; `residual_rmse` at the measured displacement and the network's own b, l, r, n. `offset_b` is how far
    output b is from input b, `slope_b` the root mean square of ∂θ/∂b, both in standard deviations (mm for constants).
    """
    log_stroke = model.settings.log_stroke
    inputs, outputs = twist_and_conditions(points, log_stroke), contraction_and_conditions(points, log_stroke)
    with torch.no_grad():
        own, true = model.network(tensor(model.inputs.scaled(inputs))), tensor(model.outputs.scaled(outputs))

        def missed_turns(x: torch.Tensor, conditions: torch.Tensor) -> Array:
            answer = model.network.inverse(torch.cat([x[:, :1], conditions[:, 1:]], dim=1)).double().numpy()
            return np.asarray(model.inputs.restored(answer)[:, 0] - inputs[:, 0])

        forward_mm = model.outputs.restored(own.double().numpy())[:, 0] - outputs[:, 0]
        rows: list[tuple[str, str, str, float]] = [
            ("forward", "rmse", "mm", rms(forward_mm)),
            ("inverse", "rmse", "turns", rms(missed_turns(true, true))),
            ("inverse", "leak_rmse", "turns", rms(missed_turns(own, true))),
            ("inverse", "residual_rmse", "turns", rms(missed_turns(true, own))),
        ]
    steep, apart = slopes(model, true), (own - true).double().numpy()
    for column, name in enumerate(CONDITIONS, start=1):
        rows.append(("forward", f"offset_{name}", "std", rms(apart[:, column])))
        rows.append(("inverse", f"slope_{name}", "std", rms(steep[:, column])))
    return pd.DataFrame(rows, columns=["map", "metric", "unit", "value"])


def leak(points: pd.DataFrame, fitted: Path, material: str) -> pd.DataFrame:
    """The decomposed errors of a file `<variant>/within-<seed>.model` at points; columns of `schemas.METRICS`."""
    model = Inn()
    model.load(fitted)
    table = decomposed(model, points)
    table["material"], table["model"], table["split"] = material, fitted.parent.name, SPLIT
    table["seed"] = int(fitted.stem.rsplit("-", 1)[1])
    table["stroke"] = table["phase"] = table["angle_band"] = "all"
    return table[schemas.METRICS.names]


@program
def main() -> None:
    """Write `leak.parquet` of one material."""
    parser = Parser(description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("models", type=Path, nargs="+", help="fitted INNs, <variant>/within-<seed>.model")
    parser.add_argument("--out", type=Path, required=True, help="the file of the errors, Parquet; required")
    arguments = parser.parse_args()
    file_to_write(arguments.out, reads=[arguments.dataset, *arguments.models])
    _, held_out = divided(schemas.read(arguments.dataset, schemas.DATASET), SPLIT, arguments.dataset)
    with repeatable(0):
        parts = [leak(held_out, path, arguments.dataset.parent.name) for path in arguments.models]
    schemas.write(pd.concat(parts, ignore_index=True), schemas.METRICS, arguments.out)


if __name__ == "__main__":
    main()
