"""The kind of rig that a `diagnosis.json` is about: its keys tell the reading's unit, the motion and the dimensions."""

from collections.abc import Mapping
from pathlib import Path

from ..diagnosis.document.content import Verdict
from ..ground.errors import BadInput
from ..ground.units import unit_of
from ..systems import System, systems

FLOOR = "noise_floor_"  # what the key of the noise floor begins with; it ends in the unit of the reading


def kind_of_rig(path: Path, content: Verdict, actuator: str | None) -> str:
    """The `actuator` of the rig that a diagnosis is about: the given one where it fits, else the one that fits best.

    `path` is the file, for errors. Raises BadInput where the given kind is none or measures in another unit, and
    where none or several fit.
    """
    fit: Mapping[str, object] = content.get("fit") or {}
    units = {key.removeprefix(FLOOR) for key in fit if key.startswith(FLOOR)}
    measured = [name for name, system in systems().items() if unit_of(system.channel) in units]
    if actuator is None:
        best = _best([systems()[name] for name in measured], content)
        if len(best) == 1:
            return best[0].name
        fits = f"fits {', '.join(system.name for system in best)}" if best else f"has no {FLOOR}… of a known rig"
        raise BadInput(path, "fit", fits, "say the kind of rig, as in Diagnosis.read(path, actuator='cable_drive')")
    if actuator not in systems():
        raise BadInput("Diagnosis.read", "actuator", f"{actuator!r} is none", f"take one of {', '.join(systems())}")
    if actuator not in measured:
        channel, unit = systems()[actuator].channel, " or ".join(sorted(units)) or "no known unit"
        mend = f"take one of {', '.join(measured)}" if measured else "give a diagnosis.json as it was made"
        problem = f"{actuator!r} measures {channel}, and {path} is about a reading in {unit}"
        raise BadInput("Diagnosis.read", "actuator", problem, mend)
    return actuator


def _best(fitting: list[System], content: Verdict) -> list[System]:
    """Those whose motion places the mismatch, of which the diagnosis has every dimension of the rig, and most such."""
    mismatch = content.get("mismatch")
    placed: Mapping[str, object] = mismatch["location"] if mismatch else {}
    by_motion = [system for system in fitting if system.driver in placed] or fitting
    whole = [system for system in by_motion if set(system.rig) <= set(content["parameters"])]
    most = max((len(system.rig) for system in whole), default=0)
    return [system for system in whole if len(system.rig) == most]
