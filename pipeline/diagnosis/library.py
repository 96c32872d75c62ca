"""The registries: every mechanism and every system is a module in its folder, found by listing it."""

import importlib
import pkgutil
from functools import cache

from pipeline.diagnosis import mechanisms as mechanisms_folder
from pipeline.diagnosis import systems as systems_folder
from pipeline.diagnosis.interface import Mechanism, System


@cache
def mechanisms() -> dict[str, Mechanism]:
    """All mechanisms by id, sorted."""
    names = sorted(module.name for module in pkgutil.iter_modules(mechanisms_folder.__path__))
    found = (importlib.import_module(f"{mechanisms_folder.__name__}.{name}").MECHANISM for name in names)
    return {mechanism.id: mechanism for mechanism in found}


@cache
def systems() -> dict[str, System]:
    """All systems by the actuators that they simulate."""
    names = sorted(module.name for module in pkgutil.iter_modules(systems_folder.__path__))
    modules = (importlib.import_module(f"{systems_folder.__name__}.{name}") for name in names)
    return {name: system for module in modules for name, system in module.SYSTEMS.items()}
