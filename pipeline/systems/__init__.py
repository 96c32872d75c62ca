"""The registry of systems: every module of this folder that holds `SYSTEMS`, found by listing it."""

import importlib
import pkgutil
from functools import cache

from .interface import Parameter, System

__all__ = ["Parameter", "System", "systems"]


@cache
def systems() -> dict[str, System]:
    """All systems by the `actuator` of `run.yaml` that they simulate."""
    names = sorted(module.name for module in pkgutil.iter_modules(__path__) if module.name != "interface")
    modules = (importlib.import_module(f"{__name__}.{name}") for name in names)
    return {system.name: system for module in modules for system in module.SYSTEMS}
