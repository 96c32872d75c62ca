"""The author `mechanics`: hidden physics that MuJoCo simulates: joints, tendons, limits, dry friction, contacts."""

from pipeline.rig.authors.mechanics.catalogue import LAWS
from pipeline.rig.authors.mechanics.making import make

__all__ = ["LAWS", "make"]
