"""twistbench: recordings of a twisted string actuator, its kinematic models, and which physics a simulator leaves out.

In memory: `Recording`, `points`, `fit`, `load`, `answers`, `model_names`, `FittedModel`, `Diagnosis`, `Mechanism`,
`Interval`, `BadInput`. Each is imported when it is first used. What a person runs are programs beside them, each with
--help.

Importing it gives this process one thread of linear algebra, whatever the environment says.

Small fits with more threads are up to ten times slower and, because sums are then taken in another order, differ in
their last digits. Runs go side by side as processes instead. The libraries read these variables when they are first
imported, so they are set here, which every program passes before numpy.
"""

import importlib as _importlib
import os as _os
import sys as _sys
from typing import TYPE_CHECKING as _TYPE_CHECKING

__version__ = "0.2.0"  # the one place that says it

ONE_THREAD = (
    "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS", "NUMEXPR_NUM_THREADS", "NUMEXPR_MAX_THREADS", "NUMBA_NUM_THREADS",
)  # fmt: skip

for _name in ONE_THREAD:
    if not (_name.startswith("NUMBA") and "numba" in _sys.modules):  # which refuses a change once it runs
        _os.environ[_name] = "1"
if "numpy" in _sys.modules:  # imported by a program that uses twistbench: its libraries read the variables before us
    from threadpoolctl import threadpool_limits as _threadpool_limits

    _threadpool_limits(1)

_NOTEBOOK = {
    "Recording": "recording",
    "points": "models",
    "fit": "models",
    "FittedModel": "models",
    "load": "models",
    "answers": "asked_model",
    "model_names": "models",
    "Diagnosis": "diagnosis",
    "Mechanism": "mechanism",
    "Interval": "mechanism",
}
if _TYPE_CHECKING:
    from .ground.errors import BadInput as BadInput
    from .notebook.asked_model import answers as answers
    from .notebook.diagnosis import Diagnosis as Diagnosis
    from .notebook.mechanism import Interval as Interval
    from .notebook.mechanism import Mechanism as Mechanism
    from .notebook.models import FittedModel as FittedModel
    from .notebook.models import fit as fit
    from .notebook.models import load as load
    from .notebook.models import model_names as model_names
    from .notebook.models import points as points
    from .notebook.recording import Recording as Recording

__all__ = [
    "BadInput", "Diagnosis", "FittedModel", "Interval", "Mechanism", "Recording", "answers", "fit", "load",
    "model_names", "points",
]  # fmt: skip


def __getattr__(name: str) -> object:
    """A public name, imported when it is first asked for: a program that needs none of them starts no slower."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    home = f".notebook.{_NOTEBOOK[name]}" if name in _NOTEBOOK else ".ground.errors"
    return getattr(_importlib.import_module(home, __name__), name)


def __dir__() -> list[str]:
    return [*globals(), *__all__]
