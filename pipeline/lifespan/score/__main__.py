"""Whole lives of strings → how often the intervals hold that were given early in these lives, beside simpler peers."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd

from ...ground.command import command
from ...ground.errors import BadInput, program
from ...ground.input.outputs import folder_to_write
from ...ground.input.parser import Parser
from ...ground.stored.files import whole, write_text
from ...ground.words.progress import steps
from ...string.from_raw import read
from ..forecast.life_questions import Answer, model_error, stroke_loss
from ..forecast.strokes_left import LEAST_STROKES, Left, first_passed
from ..stroke_health.health import Health, health
from ..stroke_health.indicators import REFERENCE
from .peers import PEERS, peer
from .scorefigure import page
from .scoretable import words

SHARES = (0.25, 0.5, 0.75)  # of the strokes to the limit
NUMBERS = (15, 30, 60)  # strokes
LEVELS = (0.9, 0.5, 0.3, 0.7, 0.8, 0.95)  # the first is the interval of the table
OURS = "this forecast"
Row = dict[str, str | float]  # of the table, by its columns; strokes are counts


def loses(truth: pd.DataFrame, loss: float) -> float:
    """First stroke of a string whose true stroke, without noise, has lost a share; infinite where none has."""
    stroke_mm = truth["stroke_mm"].to_numpy()
    past = 1.0 - stroke_mm / stroke_mm[:REFERENCE].mean() >= loss
    return float(truth["stroke"].to_numpy()[np.argmax(past)]) if past.any() else np.inf


def errs(whole_life: Answer) -> float:
    """First stroke at which the model error, measured over the whole life, passes its limit; infinite where none is."""
    passed = first_passed(whole_life.n, whole_life.values, whole_life.limit)
    return passed if np.isfinite(passed) else np.inf


def cuts(end: float) -> Iterator[tuple[str, int]]:
    """After how many strokes a string whose life is known to stroke `end` is asked, and what `end` means."""
    for share in SHARES:
        yield f"{share:.0%} of the life", int(share * end)
    for number in NUMBERS:
        yield f"{number} strokes", number


def held(forecast: Left, level: float, true: float, censored: bool) -> float:
    """Whether an interval holds the strokes left: 1 or 0; NaN without a claim, or if a censored life cannot tell.

    `true` is the strokes left, or those for which a censored life is known to have gone on.
    """
    span = forecast.span(level)
    if span.state == "no claim":
        return np.nan
    if span.high < true:
        return 0.0
    if not censored:
        return float(span.low <= true)
    return 1.0 if span.low <= true and np.isinf(span.high) else np.nan


def row(method: str, forecast: Left, true: float, censored: bool) -> Row:
    """One forecast against the truth."""
    span = forecast.span(LEVELS[0])
    scored: Row = {"method": method, "state": span.state, "left": true, "censored": censored, "median": span.median,
             "low": span.low, "high": span.high}  # fmt: skip
    return scored | {f"held_{level:.0%}": held(forecast, level, true, censored) for level in LEVELS}


def asked(string_health: Health, truth: pd.DataFrame, loss: float, drift_mm: float) -> Iterator[Row]:
    """Rows of one string: both questions, at every cut, by us and by every peer."""
    last = float(truth["stroke"].iloc[-1])
    for question, limit in (("stroke_loss", loss), ("model_error", drift_mm)):
        when = loses(truth, loss) if question == "stroke_loss" else errs(model_error(string_health, drift_mm))
        end = min(when, last)
        for cut, strokes in cuts(end):
            if strokes >= end or strokes < LEAST_STROKES:
                continue
            young = replace(string_health, strokes=string_health.strokes[string_health.strokes["stroke"] <= strokes])
            answer: Answer = stroke_loss(young, loss) if question == "stroke_loss" else model_error(young, drift_mm)
            true, censored = end - strokes, bool(np.isinf(when))
            about: Row = {"string": string_health.string, "question": question, "cut": cut, "seen": strokes}
            yield about | row(OURS, answer.left, true, censored)
            for name in PEERS:
                yield about | row(name, peer(name, answer.n, answer.values, limit), true, censored)


def score(folder: Path, loss: float, drift_mm: float) -> pd.DataFrame:
    """Rows of every string under a folder that the endurance rig wrote; raises BadInput."""
    path = folder / "truth.parquet"
    if not path.is_file():
        raise BadInput(path, "file", "is missing", f"write it: {command('rig.endurance')} --out DIR")
    try:
        truth = pd.read_parquet(path, columns=["run", "stroke", "stroke_mm"])
    except (OSError, ValueError) as error:
        raise BadInput(path, "file", "is not what the endurance rig writes", "write the folder again") from error
    rows: list[Row] = []
    for run, lived in steps(truth.groupby("run", sort=True), "string"):
        rows += asked(health([read(folder / str(run))]), lived.sort_values("stroke"), loss, drift_mm)
    return pd.DataFrame(rows)


@program
def main() -> None:
    """Command line."""
    parser = Parser(prog=command("lifespan.score"), description=__doc__)
    parser.add_argument("lives", type=Path, help="folder with run folders and truth.parquet")
    parser.add_argument("--loss", type=float, default=0.10)
    parser.add_argument("--drift-mm", type=float, default=1.0)
    parser.add_argument("--out", type=Path, required=True, help="the folder of lifespan.csv, .md and .svg; required")
    arguments = parser.parse_args()
    folder_to_write(arguments.out)
    rows = score(arguments.lives, arguments.loss, arguments.drift_mm)
    with whole(arguments.out / "lifespan.csv") as temporary:
        rows.to_csv(temporary, index=False)
    text = words(rows)
    write_text(arguments.out / "lifespan.md", text)
    page(rows, LEVELS, arguments.out / "lifespan.svg")
    print(text, end="")


if __name__ == "__main__":
    main()
