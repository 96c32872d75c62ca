"""The accuracy of a run's measured dimensions, each in its own unit; and likely mistakes in it."""

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from ...ground.errors import BadInput
from ...ground.units import unit_of
from ..description import Run

MOST = 0.3  # of a dimension: who measured it knows it better
MEANING = {"scale": "gain of the sensor", "angle_turns": "zero of the motor"}  # of names that do not say it
FINEST_MM = 0.002  # what a micrometer tells of a soft string's radius


class Tolerance(NamedTuple):
    """One sigma of a dimension, in the dimension's unit; `share`: whether run.yaml gives it as a share of it."""

    key: str
    value: float
    sigma: float
    unit: str
    share: bool
    given: bool

    @property
    def part(self) -> float:
        """The tolerance as a share of the dimension; 0 where the dimension is 0."""
        return self.sigma / abs(self.value) if self.value else 0.0


def tolerances(run: Run) -> Iterator[Tolerance]:
    """The tolerances in force, given or default, in the order of the rig's dimensions."""
    system = run.system
    for parameter in system.parameters(run):
        key = next((key for key in system.tolerance if parameter.name in (key, f"{key}_mm")), None)
        if key is not None:
            unit = unit_of(parameter.name).replace("1", "")
            share, is_given = key not in system.absolute, key in run.tolerance
            yield Tolerance(key, parameter.nominal, parameter.sigma, unit, share, is_given)


def read_back(run: Run) -> str:
    """A line for each dimension: its tolerance in its own unit, marked if it is a default."""
    parts = []
    for tolerance in tolerances(run):
        name, unit = tolerance.key.removesuffix(f"_{tolerance.unit}").replace("_", " "), f" {tolerance.unit}".rstrip()
        notes = [f"a share: {100.0 * tolerance.part:.3g} %"] if tolerance.share else []
        notes += [] if tolerance.given else ["default"]
        note = f" ({', '.join(notes)})" if notes else ""
        name += f" ({MEANING[tolerance.key]})" if tolerance.key in MEANING else ""
        parts.append(f"{name} {tolerance.value:.4g}{unit} ± {tolerance.sigma:.3g}{unit}{note}")
    return "\n  ".join(["Tolerances, one sigma each:", *parts]) if parts else ""


def tolerance_questions(run: Run, path: Path) -> list[BadInput]:
    """Tolerances in `path` that are possible, but likely mistakes: each with its mend."""
    return [_question(tolerance, path) for tolerance in tolerances(run) if _odd(tolerance)]


def _odd(tolerance: Tolerance) -> bool:
    if not tolerance.given:  # a coarse default is a dimension in another unit, or one too small for it
        return tolerance.part > MOST and tolerance.unit == "mm"
    too_fine = tolerance.share and tolerance.unit == "mm" and tolerance.sigma < FINEST_MM
    return too_fine or tolerance.part > MOST


def _question(tolerance: Tolerance, path: Path) -> BadInput:
    """Why a tolerance is odd, and what was likely meant."""
    whole = f"{tolerance.value:.4g} {tolerance.unit}".rstrip()
    sigma = f"{tolerance.sigma:.3g} {tolerance.unit}".rstrip()
    field = f"tolerance.{tolerance.key}"
    if not tolerance.given:
        problem = f"is {sigma}, the default, {tolerance.part:.0%} of {whole}"
        mend = f"give {tolerance.key} in {tolerance.unit}; if it is so small, say with {field} how well you measured it"
        return BadInput(path, field, problem, mend)
    if not tolerance.share:
        problem = f"is {sigma}, {tolerance.part:.0%} of {whole}: who measured it knows it better"
        return BadInput(path, field, problem, f"give {field} in {tolerance.unit}")
    written = tolerance.part
    finest = FINEST_MM if tolerance.unit == "mm" else 0.0
    problem = f"is {written:.4g}, a share: {100.0 * written:.3g} % of {whole}, or ± {sigma}"
    meant = [
        f"{part:.3g} if {written:.4g} {word} was meant"
        for part, word in ((written / 100.0, "%"), (written / abs(tolerance.value), tolerance.unit))
        if word and part <= MOST and part * abs(tolerance.value) >= finest
    ]
    why = "finer than a micrometer tells" if written <= MOST else "more than anybody errs by who measured it"
    return BadInput(path, field, f"{problem}, {why}", f"write {field} as {' or '.join(meant) or 'the share of it'}")
