"""The registry of mechanisms: every one is a module in its folder, found by listing it."""

import importlib
import pkgutil
from functools import cache

from . import mechanisms as mechanisms_folder
from .interface import Mechanism


@cache
def mechanisms() -> dict[str, Mechanism]:
    """All mechanisms by id, sorted."""
    names = sorted(module.name for module in pkgutil.iter_modules(mechanisms_folder.__path__))
    all_mechanisms = (importlib.import_module(f"{mechanisms_folder.__name__}.{name}").MECHANISM for name in names)
    return {mechanism.id: mechanism for mechanism in all_mechanisms}
