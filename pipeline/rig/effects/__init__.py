"""The rig's effects: one file each, named as its mechanism in docs/physics.md, found by being there.

Each holds its class `Model`, the machine, and its class `Hidden`, how a bench conceals it.

Their state equations are the rig's own. The library that explains recordings must not share them, so nothing
here is imported by, or imports, `pipeline.diagnosis` or `pipeline.models`.
"""

import importlib
import pkgutil
from collections.abc import Mapping
from functools import cache
from typing import Any

from ..concealed import Concealed
from ..effect import Effect
from ..wandering_strength import Unsteady


def names() -> list[str]:
    """Names of all effects that the rig can simulate."""
    return sorted(module.name for module in pkgutil.iter_modules(__path__))


def make(name: str, parameters: Mapping[str, object]) -> Effect:
    """A fresh effect of that name; raises ValueError for a name or a parameter that it does not know.

    Any effect can have the parameter `unsteady`, with the arguments of `pipeline.rig.wandering_strength.Unsteady`.
    """
    if name not in names():
        raise ValueError(f"is not an effect of the rig; known are {', '.join(names())}")
    model: type[Effect] = importlib.import_module(f"{__name__}.{name}").Model
    own = {key: value for key, value in parameters.items() if key != "unsteady"}
    try:
        effect = model(**own)
        if "unsteady" not in parameters:
            return effect
        waves: Any = parameters["unsteady"]
        return Unsteady(effect, **waves)
    except TypeError as error:
        raise ValueError(f"has other parameters ({error})") from None


@cache
def concealed(name: str) -> Concealed:
    """How a bench conceals the effect of that name."""
    hidden: Concealed = importlib.import_module(f"{__name__}.{name}").Hidden()
    return hidden
