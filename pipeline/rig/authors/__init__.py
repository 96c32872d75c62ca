"""Authors of concealed physics: packages of recordings' generators, each by a hand of its own, and their register."""

import importlib
import pkgutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from .interface import Asked, Made


@dataclass(frozen=True)
class Author:
    """One author: the laws that it knows for each effect, and what makes a recording."""

    name: str
    laws: Mapping[str, tuple[str, ...]]
    make: Callable[[Asked], Made]


def names() -> tuple[str, ...]:
    """Names of the authors, which are the packages in this folder, sorted."""
    return tuple(sorted(module.name for module in pkgutil.iter_modules(__path__) if module.ispkg))


def authors() -> dict[str, Author]:
    """Every author by its name."""
    packages = {name: importlib.import_module(f"{__name__}.{name}") for name in names()}
    return {name: Author(name, package.LAWS, package.make) for name, package in packages.items()}
