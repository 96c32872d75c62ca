"""The author `lattice`: internal states and their differential equations, stepped on a fine clock."""

from collections.abc import Mapping

from pipeline.rig.authors.lattice.catalogue import BY_EFFECT
from pipeline.rig.authors.lattice.recording import make

LAWS: Mapping[str, tuple[str, ...]] = {effect: tuple(law.name for law in laws) for effect, laws in BY_EFFECT.items()}

__all__ = ["LAWS", "make"]
