"""Author `kinetics`: every effect is a population of small elements with distributed thresholds, barriers or times."""

from collections.abc import Mapping

from pipeline.rig.authors.interface import Asked, Made
from pipeline.rig.authors.kinetics.recording import recorded
from pipeline.rig.authors.kinetics.register import BY_EFFECT

LAWS: Mapping[str, tuple[str, ...]] = {effect: tuple(law.name for law in laws) for effect, laws in BY_EFFECT.items()}


def make(request: Asked) -> Made:
    """One recording with the effects asked, all of it drawn from the seed; raises OutOfReach."""
    return recorded(request, {})


__all__ = ["LAWS", "make"]
