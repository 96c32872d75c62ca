"""The readings of a run's rests, which tell its zero: small enough to be kept without the samples.

Source: Hampel, "The influence curve and its role in robust estimation", Journal of the American Statistical Association
69, 1974 (the median of distances as their spread); Gasser, Sroka and Jennen-Steinmetz, "Residual variance and residual
pattern in nonlinear regression", Biometrika 73, 1986 (noise from second differences).
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
import pandas as pd

from ..ground.kinematics import Array
from ..ground.numbers import quantiles
from ..ground.numbers.spans import blocks
from ..ground.stored import schemas
from ..run.description import Run
from .history import Recorded

LEAST_FLOOR_MM = 1e-4  # a noise floor that no sensor's is below

Rest = tuple[int, int]  # its first sample, and the first after it


@dataclass(frozen=True)
class Rests:
    """The rests of one run in their order: before its first stroke, and after each.

    `levels_mm` is what each rest reads more than the nominal model, `turns` and `load_n` are where it rests, `after` is
    the stroke that it follows, 0 before the first. `range_turns` is the range of the whole motion. `strokes` is how
    many strokes the run holds.
    """

    run: Run
    folder: Path
    started_utc: str
    span_s: tuple[float, float]
    strokes: int
    after: tuple[int, ...]
    turns: tuple[float, ...]
    load_n: tuple[float, ...]
    levels_mm: tuple[float, ...]
    range_turns: float
    noise_mm: float

    @classmethod
    def of(cls, recorded: Recorded) -> "Rests":
        """The rests of a run of a string."""
        rests, reach = rests_of(recorded), recorded.rows.extremes("motor_turns")
        turns, load_n = (tuple(_middle(recorded, name, rest) for rest in rests) for name in ("motor_turns", "load_n"))
        levels_mm = tuple(recorded.level_mm(*rest) for rest in rests)
        later = recorded.strokes[(recorded.strokes["phase"] == "rest") & (recorded.strokes["stroke"] > 0)]
        return cls(
            recorded.run, recorded.folder, recorded.started_utc, recorded.span_s, int(recorded.strokes["stroke"].max()),
            (0, *later["stroke"].astype(int)), turns, load_n, levels_mm, float(np.ptp(reach)), noise_mm(recorded),
        )  # fmt: skip


def rests_of(recorded: Recorded) -> list[Rest]:
    """The rest before the first stroke, or else the first sample, and each rest after a stroke."""
    table = recorded.strokes[recorded.strokes["phase"] == "rest"]
    first, later = table[table["stroke"] == 0][-1:], table[table["stroke"] > 0]
    both = pd.concat([first, later])
    between = [(int(a), int(b) + 1) for a, b in zip(both["first_sample"], both["last_sample"], strict=True)]
    return between if len(first) else [(0, 1), *between]


def noise_mm(recorded: Recorded) -> float:
    """Noise floor of a run's displacement in mm: the spread of its rough part, or of its rests if that is larger."""
    rows, name = recorded.rows, "displacement_mm"
    last = len(rows) - 2
    spans = [(first, min(stop, last)) for first, stop in rows.spans if first < last]
    rough = quantiles.median(
        lambda: (np.abs(np.diff(rows.read(name, first, stop + 2), 2)) for first, stop in spans), last
    )
    spreads = [_spread_mm(recorded, rest) for rest in rests_of(recorded) if rest[1] - rest[0] > 2]
    return max(1.4826 * rough / np.sqrt(6.0), float(np.median(spreads)) if spreads else 0.0)


def _read(recorded: Recorded, name: str, rest: Rest) -> Iterator[Array]:
    """A channel in a rest, piece by piece."""
    return (recorded.rows.read(name, *part) for part in blocks(*rest, schemas.ROW_GROUP))


def _middle(recorded: Recorded, name: str, rest: Rest) -> float:
    """Median of a channel in a rest."""
    return quantiles.median(partial(_read, recorded, name, rest), rest[1] - rest[0])


def _spread_mm(recorded: Recorded, rest: Rest) -> float:
    """How far the displacement of a rest scatters about its median, robustly."""
    name = "displacement_mm"
    middle = _middle(recorded, name, rest)
    off = quantiles.median(lambda: (np.abs(part - middle) for part in _read(recorded, name, rest)), rest[1] - rest[0])
    return 1.4826 * off
