"""Methods that learn without physics, on the strokes that the diagnosis is scored on; they are in `black_boxes`.

Source: Björck, Numerical Methods for Least Squares Problems, 1996 (the straight part, which is taken off before a
method learns the rest).
"""

import argparse
import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..ground.errors import BadInput, program
from ..ground.stored.files import write_text
from ..run.description import Run
from ..run.samples import read_strokes
from .black_boxes import Predict, learner, looks
from .bring import usable
from .features import Array, averaged, features, span_of

LAST, LEAST_TRAINING = 0.3, 0.4  # of the strokes, of the samples: the diagnosis' own rule


@dataclass(frozen=True)
class Asked:
    """Recordings in compared form: features and reading at the working rate of the diagnosis, and the clock.

    Rows that share a number in `zero` share the reading's zero.
    """

    table: pd.DataFrame
    measured: Array  # (rows,), in the reading's unit
    time_s: Array  # (rows,)
    zero: NDArray[np.intp]  # (rows,), as indices from 0

    @classmethod
    def of(cls, run: Run, samples: pd.DataFrame, span: float) -> "Asked":
        """The recording of a run, with its memory in shares of `span`."""
        width, step_s = 1, float(np.median(np.diff(samples["time_s"])))
        if run.system.working_hz is not None:
            width = max(1, round(1.0 / (run.system.working_hz * step_s)))
        seen = averaged(samples.iloc[:, [0, 2]], width).to_numpy()
        table = features(samples, span, smoothed=not run.system.differentiates)
        return cls(averaged(table, width), seen[:, 1], seen[:, 0], np.zeros(len(seen), np.intp))

    @classmethod
    def joined(cls, parts: list["Asked"], free_zero: bool) -> "Asked":
        """Several recordings one after the other, over their common columns; with `free_zero` each has its own zero."""
        table = pd.concat([part.table for part in parts], join="inner", ignore_index=True)
        number = [np.full(len(part.measured), at if free_zero else 0, np.intp) for at, part in enumerate(parts)]
        measured, time_s = (np.concatenate([getattr(part, name) for part in parts]) for name in ("measured", "time_s"))
        return cls(table, measured, time_s, np.concatenate(number))


@dataclass(frozen=True)
class Learnt:
    """A method after learning: one predictor per seed, which improves a straight line over the standardised columns."""

    predictors: tuple[Predict, ...]
    columns: list[str]
    mean: Array  # (columns,), each in its column's unit
    spread: Array  # (columns,), each in its column's unit
    constant: float
    slope: Array  # (columns,), in the reading's unit

    def predict(self, question: Asked) -> Array:
        """Prediction of each seed for every row, shape (seeds, rows). In the reading's unit."""
        table = (question.table[self.columns].to_numpy() - self.mean) / self.spread
        straight = self.constant + table @ self.slope
        return np.array([straight + predict(table) for predict in self.predictors])


def learn(method: str, seen: Asked, rows: int, columns: list[str]) -> Learnt:
    """Fit a method to the first rows, over some of the columns; of several zeros the first one's is predicted."""
    make, seeds = learner(method)
    inputs, measured = seen.table[columns].to_numpy()[:rows], seen.measured[:rows]
    mean, spread = inputs.mean(axis=0), inputs.std(axis=0)
    spread = np.where(spread > 1e-12, spread, 1.0)
    table = (inputs - mean) / spread
    zeros = np.eye(seen.zero.max() + 1)[seen.zero[:rows]]
    design = np.column_stack([zeros, table])
    line = np.linalg.lstsq(design, measured, rcond=1e-6)[0]
    predictors = tuple(make(table, measured - design @ line, seed) for seed in seeds)
    return Learnt(predictors, columns, mean, spread, float(line[0]), line[zeros.shape[1] :])


def first_held_out(samples: pd.DataFrame, strokes: pd.DataFrame) -> int | None:
    """First sample of the last 30 % of strokes (at least one), or None when too little is left to learn from.

    `strokes` are those of the samples, a row a stretch (`schemas.STROKES`).
    """
    numbers = np.unique(strokes["stroke"][strokes["stroke"] > 0])
    count = max(1, round(LAST * len(numbers)))
    if len(numbers) - count < 1:
        return None
    row = int(strokes["first_sample"][strokes["stroke"] >= numbers[-count]].iloc[0])
    return row if row >= LEAST_TRAINING * len(samples) else None


def held_out(run: Run, samples: pd.DataFrame, strokes: pd.DataFrame) -> dict[str, float] | None:
    """Rms error of each method on the last strokes, in the reading's unit, median of its seeds; or None."""
    row = first_held_out(samples, strokes)
    if row is None:
        return None
    seen = Asked.of(run, samples, span_of(samples.iloc[:row]))
    rows = int(np.searchsorted(seen.time_s, samples["time_s"].iloc[row]))
    errors = {}
    for method in looks():
        residual = learn(method, seen, rows, list(seen.table)).predict(seen)[:, rows:] - seen.measured[rows:]
        errors[method] = float(np.median(np.sqrt(np.mean(np.square(residual), axis=1))))
    return errors


@program
def main() -> None:
    """Write the held-out errors of one run."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.real.black_box", description=__doc__)
    parser.add_argument("run_dir", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="the file of the errors, JSON; required")
    arguments = parser.parse_args()
    errors = None
    if usable(arguments.run_dir):
        try:
            errors = held_out(*read_strokes(arguments.run_dir))
        except BadInput as error:
            print(error)
    write_text(arguments.out, json.dumps({"run": arguments.run_dir.name, "heldout": errors}, indent=1) + "\n")


if __name__ == "__main__":
    main()
