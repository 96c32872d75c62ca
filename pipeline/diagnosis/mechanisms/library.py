"""The registry of mechanisms: every one is a module in its folder, found by listing it."""

import importlib
import pkgutil
from functools import cache
from pathlib import Path

from .interface import Mechanism

HELPERS = {"interface", "library", "plain_drag", "shared_laws", "shared_meanings", "shared_wander"}  # what they share


@cache
def mechanisms() -> dict[str, Mechanism]:
    """All mechanisms by id, sorted."""
    names = {module.name for module in pkgutil.iter_modules([str(Path(__file__).parent)])}
    all_mechanisms = (importlib.import_module(f"{__package__}.{name}").MECHANISM for name in sorted(names - HELPERS))
    return {mechanism.id: mechanism for mechanism in all_mechanisms}
