"""The diagnosis and the black boxes, learnt on some recordings and asked about others of the same thing."""

import argparse
from pathlib import Path
from typing import TypedDict

import numpy as np
import pandas as pd

from ..diagnosis.document.content import Simulated
from ..diagnosis.prediction.simulation import read_diagnosis, tare
from ..diagnosis.written import JSON
from ..ground.errors import BadInput, program
from ..ground.stored.files import whole
from ..string.from_raw import read
from ..string.history import Recorded
from ..string.jumps_beside import Beside
from .asked_recording import About
from .black_box import Asked, Learnt, learn
from .black_boxes import looks
from .bring import usable
from .features import Array, span_of
from .runs_to_make import ALL_OTHERS
from .verdicts import ask

COLUMNS = ["group", "learnt_from", "asked_about", "method", "rms", "centred_rms", "unit"]
LEAST_OTHERS = 2


def errors(predicted: Array, measured: Array, time_s: Array, tared: bool) -> tuple[float, float]:
    """Rms error with the zero set on the first second, where `tared`, and with the best zero of all.

    Each given has the shape (samples,): predicted and measured in the reading's unit, time in s.
    """
    residual = measured - predicted
    first = residual - tare(predicted, measured, time_s) if tared else residual
    return float(np.sqrt(np.mean(np.square(first)))), float(
        np.std(residual) if tared else np.sqrt(np.mean(np.square(residual)))
    )


class Source:
    """Recordings that every method learnt from, and their diagnosis where there is one."""

    def __init__(self, recordings: list[About], diagnosis: Path) -> None:
        self.span, self.diagnosis = max(span_of(about.samples) for about in recordings), diagnosis
        parts = [Asked.of(about.run, about.samples, self.span) for about in recordings]
        self.seen = Asked.joined(parts, recordings[0].run.system.free_zero)
        self._learnt: dict[tuple[str, ...], Learnt] = {}

    def learnt(self, method: str, columns: list[str]) -> Learnt:
        """A black box that learnt all of the recording, over some columns; fitted once."""
        key = (method, *columns)
        if key not in self._learnt:
            self._learnt[key] = learn(method, self.seen, len(self.seen.table), columns)
        return self._learnt[key]

    def asked_about(self, about: About) -> dict[str, tuple[float, float]]:
        """Both errors of every method on all of another recording, in the median of its seeds."""
        tared = about.run.system.free_zero
        predicted_by_run = {}
        if self.diagnosis.is_file():
            content = read_diagnosis(self.diagnosis)
            bare: Simulated = {"parameters": {}, "simulation": []}
            for method, verdict in (("nominal", bare), ("explained", content)):
                predicted_by_run[method] = errors(*about.simulated(verdict, self.diagnosis), tared)
        question = Asked.of(about.run, about.samples, self.span)
        columns = [name for name in self.seen.table if name in question.table]
        for method in looks():
            predicted = self.learnt(method, columns).predict(question)
            first, best = np.median(
                [errors(prediction, question.measured, question.time_s, tared) for prediction in predicted], axis=0
            )
            predicted_by_run[method] = float(first), float(best)
        return predicted_by_run


class Row(TypedDict):
    """The errors of one method on one run after learning from another; rms, in `unit`."""

    learnt_from: str
    asked_about: str
    method: str
    rms: float
    centred_rms: float
    unit: str


def rows_of(source: Source, learnt_from: str, runs: dict[str, About]) -> list[Row]:
    """A row for every run that is asked about and every method: rms error in the reading's unit."""
    rows: list[Row] = []
    for name, about in runs.items():
        unit = about.run.system.channel.rpartition("_")[2]
        for method, (first, best) in source.asked_about(about).items():
            rows.append(Row(
                learnt_from=learnt_from, asked_about=name, method=method, rms=first, centred_rms=best, unit=unit
            ))  # fmt: skip
    return rows


def of_group(runs: dict[str, About], diagnoses: dict[str, Path]) -> list[Row]:
    """Rows for every ordered pair of runs."""
    rows: list[Row] = []
    for name, recording in runs.items():
        others = {other: about for other, about in runs.items() if other != name}
        rows += rows_of(Source([recording], diagnoses[name]), name, others)
    return rows


def left_out(runs: dict[str, About], out: Path) -> list[Row]:
    """Rows for every run after learning from all the others together, whose diagnosis goes to `out`/<run>."""
    rows: list[Row] = []
    out.mkdir(parents=True, exist_ok=True)  # also where too few are left to learn from
    recorded_by_folder = {about.recorded.folder.resolve(): about.recorded for about in runs.values()}

    def reader(folder: Path) -> Recorded:
        return recorded_by_folder.get(folder.resolve()) or read(folder)

    beside = Beside(reader=reader)
    for name in runs if len(runs) > LEAST_OTHERS else ():
        others = [runs[other] for other in runs if other != name]
        ask([about.recorded.folder for about in others], out / name, reader, beside)
        source = Source(others, out / name / JSON)
        rows += rows_of(source, ALL_OTHERS, {name: runs[name]})
    return rows


def _read(folder: Path) -> About | None:
    """A recorded run, or None when it is not usable, with the reason in the report."""
    try:
        return About(read(folder)) if usable(folder) else None
    except BadInput:
        return None


@program
def main() -> None:
    """Write a row for every ordered pair of one group's runs, and for every run and all others, and every method."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.real.transfer", description=__doc__)
    parser.add_argument("run_dir", type=Path, nargs="+")
    parser.add_argument("--group", required=True)
    parser.add_argument(
        "--diagnoses", type=Path, required=True, help="the folder with a folder of each run's diagnosis"
    )
    parser.add_argument("--others", type=Path, required=True, help="folder for the diagnoses of all but one")
    parser.add_argument("--out", type=Path, required=True, help="the file of the table, csv; required")
    arguments = parser.parse_args()
    read = {folder.name: _read(folder) for folder in arguments.run_dir}
    runs = {name: rig_read for name, rig_read in read.items() if rig_read is not None}
    rows = of_group(runs, {name: arguments.diagnoses / name / JSON for name in runs})
    rows += left_out(runs, arguments.others)
    table = pd.DataFrame([{"group": arguments.group, **row} for row in rows], columns=COLUMNS)
    with whole(arguments.out) as temporary:
        table.to_csv(temporary, index=False, float_format="%.5g")
    print(f"{arguments.group}: {len(table)} errors")


if __name__ == "__main__":
    main()
