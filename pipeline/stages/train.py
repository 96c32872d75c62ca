"""Fit a model on the training points of a dataset's split and predict its held-out points, both ways."""

import argparse
import logging
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ..ground.command import HOUSE, command
from ..ground.errors import program
from ..ground.input.outputs import file_to_write
from ..ground.input.parser import Parser
from ..ground.stored import schemas
from ..ground.stored.given_table import opened
from ..models.interface import Model
from ..models.parts.configured import configured, fitting
from ..models.parts.divided import SPLITS, divided
from ..models.parts.fitted_to import note_points
from ..models.parts.saved import write_bytes
from ..models.parts.settings import shown


def predictions(model: Model, test: pd.DataFrame) -> pd.DataFrame:
    """Both predictions of a fitted model for held-out points, one row each (`schemas.PREDICTIONS`).

    Each map is handed the points without the answer it is to give. Raises ArithmeticError when a prediction is
    not finite.
    """
    table = pd.DataFrame(
        {
            "point": test.index.to_numpy(np.int32),
            "displacement_mm": model.forward(test.assign(displacement_mm=np.nan)),
            "motor_turns": model.inverse(test.assign(motor_turns=np.nan)),
        }
    )
    lost = int((~np.isfinite(table.to_numpy(np.float64))).any(axis=1).sum())
    if lost:
        raise ArithmeticError(f"{lost} of {len(table)} predictions are not finite")
    return table


def seed(text: str) -> int:
    """A seed from a command line, for argparse: a whole number from 0 to 2^32 - 1."""
    if not (text.isascii() and text.isdigit() and len(text) <= 10 and int(text) < 2**32):
        raise argparse.ArgumentTypeError(f"{shown(text)!r} is no whole number from 0 to {2**32 - 1}")
    return int(text)


def arguments(words: list[str]) -> Any:
    """The command line."""
    parser = Parser(prog=command("stages.train"), description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("--model", required=True, help=f"a file of {HOUSE}/models, without .py")
    parser.add_argument("--split", required=True, choices=SPLITS)
    parser.add_argument("--seed", type=seed, default=0)
    parser.add_argument("--settings", default="{}", metavar="JSON", help="the model's settings")
    parser.add_argument("--out-model", type=Path, required=True, help="the file of the model; required")
    parser.add_argument(
        "--out-predictions", type=Path, required=True, help="the file of the predictions, Parquet; required"
    )
    return parser.parse_args(words)


def main() -> None:
    """Fit, save, predict."""
    options = arguments(sys.argv[1:])
    # A stream handler flushes every line: progress shows while the fit runs, also through a pipe.
    logging.basicConfig(level=logging.INFO, stream=sys.stdout, format=f"{options.model}: %(message)s")
    model = configured(options.model, options.settings)
    for option, path in (("--out-model", options.out_model), ("--out-predictions", options.out_predictions)):
        file_to_write(path, option, reads=[options.dataset])
    dataset = opened(options.dataset, schemas.DATASET, f"make it: {command('stages.dataset')}")
    train, test = divided(dataset, options.split, options.dataset)
    if test.empty:
        print(f"skipped: too few strokes for the split {options.split}; an empty model and no predictions say so")
        write_bytes(options.out_model, b"")
        schemas.write(pd.DataFrame(columns=schemas.PREDICTIONS.names), schemas.PREDICTIONS, options.out_predictions)
        return
    with fitting(options.model):
        model.fit(train, options.seed)
        predicted = predictions(model, test)
    model.save(options.out_model)
    note_points(options.out_model, train, options.split)
    schemas.write(predicted, schemas.PREDICTIONS, options.out_predictions)


if __name__ == "__main__":
    program(main)()
