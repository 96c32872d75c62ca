"""The author `workshop`: an empirical bench engineer, who writes effects as curves, tables, tallies and kernels."""

from pipeline.rig.authors.workshop.catalogue import LAWS
from pipeline.rig.authors.workshop.recording import make

__all__ = ["LAWS", "make"]
