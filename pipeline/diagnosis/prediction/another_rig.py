"""Whether a run is of another string or rig than the runs that a diagnosis was made of."""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from ...ground.errors import BadInput
from ...run.description import Run
from ...run.folder import read_run
from ..document.content import Simulated
from ..fit.adopt import is_number
from .later_run import places_beside

SIGMAS = 1.0  # tolerances by which two measurements of one dimension may differ
ROUNDED = 1e-6  # of a dimension: a smaller difference comes from rounding alone


def other_dimensions(content: Simulated, run: Run) -> dict[str, tuple[float, float]]:
    """The dimensions that differ between run.yaml and the diagnosis by more than a tolerance: there, and here."""
    differing = {}
    for parameter in run.system.parameters(run):
        entry = content["parameters"].get(parameter.name)
        nominal: Any = entry.get("nominal") if isinstance(entry, dict) else None
        if parameter.name == run.system.homed or not is_number(nominal):
            continue
        before = float(nominal)
        if abs(parameter.nominal - before) > max(SIGMAS * parameter.sigma, ROUNDED * abs(before)):
            differing[parameter.name] = (before, parameter.nominal)
    return differing


def of_same_string(content: Simulated, run: Run, folder: Path) -> list[Path]:
    """The folders of a diagnosis' runs beside `folder`, if the runs in them all name the string of the run there."""
    runs, own = content.get("run"), run.string.id if run.string else None
    names = runs if isinstance(runs, list) else [runs]
    places = places_beside(folder, names) if own and run.run not in names else []
    try:
        ids = [string.id if (string := read_run(place).string) else None for place in places]
    except BadInput:
        return []
    return [folder.parent / place.name for place in places] if ids == [own] * len(names) else []


def other_names(content: Simulated, run: Run, folder: Path, at_hand: Sequence[Run] = ()) -> tuple[str, str] | None:
    """The string's name in a diagnosis' runs, and in the run in `folder`; None where they agree.

    The runs are those `at_hand`, or else those beside `folder`.
    """
    own = run.string.id if run.string else None
    for other in (at_hand or _runs_beside(content, folder)) if own else ():
        if other.string and other.string.id and other.string.id != own:
            return other.string.id, str(own)
    return None


def _runs_beside(content: Simulated, folder: Path) -> Iterator[Run]:
    """The runs of a diagnosis beside `folder`, as far as they can be read."""
    runs = content.get("run")
    for place in places_beside(folder, runs if isinstance(runs, list) else [runs]):
        with suppress(BadInput):  # the diagnosis was made of it; what is wrong with it now is said where it is read
            yield read_run(place)
