"""How well a motion that nobody recorded is foretold: an error band, and the reading by each rival explanation.

The band holds nine of ten readings if what acts is named rightly: it covers how well the numbers of the fit are known,
and what the simulator missed unseen strokes by, or the noise where that is more. It covers no wrong explanation, no
other string, and no motion beyond what was recorded.

Source: the Laplace approximation of a posterior, MacKay, Neural Computation 4, 1992 (what the fit leaves open); Brent,
Algorithms for Minimization without Derivatives, 1973 (the root that nine of ten readings lie within).
"""

import copy
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, FiniteFloat, NonNegativeInt
from scipy.optimize import brentq
from scipy.special import ndtr

from ...ground.errors import BadInput
from ...ground.kinematics import Array
from ...run.description import Run
from ..choice.outcome import rms
from ..document.content import Simulated, Verdict
from ..document.form import Form, formed
from ..fit.adopt import is_number
from ..fit.intervals import Z90
from ..fit.problem import Problem
from .simulation import measured_since, read_diagnosis, tared

SMALL = 0.1  # of a sigma: a step so short is straight
HELD, FAR, MOST = 0.9, 8.0, 20_000  # of the readings; sigmas that hold all; rows that tell a distance
MEND = "give a diagnosis.json as it was made"
Zeroed = Callable[[Simulated], Array]  # the reading that a simulator gives a motion, with its zero


class _Doubt(Form):
    name: str
    moves: list[FiniteFloat]
    id: str = ""
    entry: NonNegativeInt = 0


class _Rival(Form):
    ids: list[str]
    parameters: dict[str, dict[str, object]]
    simulation: list[Any]  # each is checked where it acts


class _Fit(Form):
    heldout: dict[str, object] | None = None


class _Read(Form):
    """The parts of a diagnosis that this module reads; a file may lack any of them."""

    fit: _Fit | None = None
    uncertainty: list[_Doubt] = Field(default_factory=list)
    alternatives: list[list[str]] = Field(default_factory=list)
    rivals: list[_Rival] = Field(default_factory=list)


@dataclass(frozen=True)
class Foretold:
    """One sigma of each sample, in the channel's unit, from the fit's uncertain numbers; and the error so far.

    `missed`: rms, in the channel's unit, of unseen strokes where `held_out`, else of the noise; by the diagnosis
    `content`, if one is known.
    """

    sigma: Array  # (samples,)
    missed: float
    held_out: bool
    content: Verdict | None = None

    @property
    def half_width(self) -> Array:
        """Half of the band that holds nine of ten readings. Shape (samples,), in the channel's unit."""
        return Z90 * np.hypot(self.sigma, self.missed)

    def expected(self, rows: NDArray[np.bool_]) -> float:
        """The error that is expected in some rows, rms in the channel's unit; `rows`, of shape (samples,), a mask."""
        return float(np.hypot(rms(self.sigma[rows]), self.missed))

    def within(self, rows: NDArray[np.bool_], gaps: Sequence[Array]) -> float:
        """How close to the best curve nine of ten readings of some rows lie, whichever explanation is right.

        `rows` is a mask. `gaps` say by how much the curve of each explanation that ties is more. Both of shape
        (samples,); gaps and answer in the channel's unit.
        """
        places = np.flatnonzero(rows)
        places = places[:: 1 + len(places) // MOST]
        sigma = np.maximum(np.hypot(self.sigma[places], self.missed), np.finfo(float).tiny)
        return max(_nine_of_ten(sigma, gap) for gap in (np.zeros(len(places)), *(gap[places] for gap in gaps)))


def _nine_of_ten(sigma: Array, gap: Array) -> float:
    """The distance that nine of ten normal numbers keep to 0; `gap` are their means. Shape (numbers,), in one unit."""

    def lacking(distance: float) -> float:
        return float(np.mean(ndtr((distance - gap) / sigma) - ndtr((-distance - gap) / sigma))) - HELD

    return float(brentq(lacking, 0.0, float(np.abs(gap).max() + FAR * sigma.max())))


def band(problem: Problem, content: Verdict, path: Path, run: str, zeroed: Zeroed | None = None) -> Foretold | None:
    """The error band of a diagnosis on the motion of a problem; None where its file lacks what the band needs.

    `zeroed` gives the reading of a simulator, where its zero is not that of `tared`. Raises BadInput for doubts that
    are none.
    """
    formed(_Read, content, path, MEND)
    ending = problem.system.channel.rpartition("_")[2]
    fit = content.get("fit") or {}
    stated: tuple[tuple[Mapping[str, object], str], ...] = (
        (fit, f"noise_floor_{ending}"), (fit.get("heldout") or {}, f"explained_{ending}"),
    )  # fmt: skip
    noise, unseen = (_size(part.get(key)) for part, key in stated)
    if not content.get("uncertainty") or noise is None:
        return None
    simulated = zeroed or (lambda simulator: tared(problem, simulator, path, run))
    before = simulated(content)
    variance = np.zeros(len(before))
    for direction in range(max(len(doubt["moves"]) for doubt in content["uncertainty"])):
        moved = simulated(_moved(content, direction))
        with np.errstate(over="ignore"):  # what is infinite is refused below
            variance += np.square((moved - before) / SMALL)
    if not np.isfinite(variance).all():
        raise BadInput(path, "uncertainty", "moves a number so far that nothing is foretold", MEND)
    missed = max(noise, unseen or 0.0)
    return Foretold(np.sqrt(variance), missed, missed > noise, content)


def _size(value: Any) -> float | None:
    return float(value) if is_number(value) else None


def _moved(content: Verdict, direction: int) -> Simulated:
    """The simulator of a diagnosis, moved a short step along one direction of uncertainty."""
    parameters: dict[str, Any] = copy.deepcopy(content["parameters"])
    simulation: list[Any] = copy.deepcopy(list(content["simulation"]))
    for doubt in content["uncertainty"]:
        moves = doubt["moves"]
        step = SMALL * moves[direction] if direction < len(moves) else 0.0
        if "id" not in doubt:
            dimension = parameters.get(doubt["name"])
            if isinstance(dimension, dict) and is_number(dimension.get("value")):
                dimension["value"] += step
            continue
        acting = [entry for entry in simulation if isinstance(entry, dict) and entry.get("id") == doubt["id"]]
        if doubt.get("entry", 0) < len(acting):  # what came out with no strength is not in it
            values = acting[doubt.get("entry", 0)].setdefault("parameters", {})
            values[doubt["name"]] = values.get(doubt["name"], 0.0) + step
    return {"run": content.get("run", ""), "parameters": parameters, "simulation": simulation}


def curves(problem: Problem, content: Verdict, path: Path, run: str, zeroed: Zeroed | None = None) -> dict[str, Array]:
    """The reading by each tied explanation, keyed by its mechanisms: shape (samples,), in the channel's unit.

    `zeroed` is as in `band`. Raises BadInput for rivals that are none.
    """
    formed(_Read, content, path, MEND)
    curve_by_ids = {}
    alternatives = content.get("alternatives", [])
    for rival in content.get("rivals", []):
        if rival["ids"] in alternatives:
            simulated: Simulated = {
                "run": content.get("run", ""), "parameters": rival["parameters"], "simulation": rival["simulation"],
            }  # fmt: skip
            curve = zeroed(simulated) if zeroed else tared(problem, simulated, path, run)
            curve_by_ids[" + ".join(rival["ids"])] = curve
    return curve_by_ids


def adopted_diagnosis(run: Run) -> tuple[Path, Verdict | None]:
    """The diagnosis.json that a run adopted last, with its content; None where it is gone or has changed.

    Raises BadInput for a file that is no diagnosis.
    """
    path = Path((run.adopted[-1].diagnosis if run.adopted else None) or "diagnosis.json")
    if not run.adopted or not path.is_file() or measured_since(run):
        return path, None
    content = read_diagnosis(path)
    return path, content if list(content["simulation"]) == list(run.simulation) else None
