"""What a regression without physics foretells of strokes that no fit has seen: the level that physics has to reach."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..ground.kinematics import Array
from . import generic, locate
from .drivers import Drivers
from .problem import Problem, State

MEMORIES = (0.02, 0.1)  # of the range of motion, over which a reversal is felt
SEED = 0


@dataclass(frozen=True)
class Foretold:
    """What the regression adds to a simulator, at the recording's own rate, and where and following what."""

    added: Array  # one value a sample of the recording
    location: dict[str, Any]  # as `locate.box` says it, over the strokes that were held out
    driver: str  # as `generic.groups` calls it


def signals(drivers: Drivers) -> Array:
    """What the regression is told, shape (samples, columns): motion, its rates, its memory, and every other input.

    Time is none of them: of strokes to come it would tell nothing. Each in its own unit.
    """
    columns = [drivers.motion, drivers.rate, drivers.slope(drivers.rate)]
    columns += [drivers.directed(share * drivers.span) for share in MEMORIES]
    columns += [drivers.load] if drivers.loaded else []
    columns += [drivers.smooth(other) for other in (drivers.temperature_c, drivers.current_a) if other is not None]
    return np.column_stack(columns)


def foretold(problem: Problem, fine: Problem, state: State, unseen: NDArray[np.bool_]) -> Foretold:
    """What boosted trees learn of what a state leaves of the rows that a fit saw, told of all rows.

    `fine` is the recording at its own rate, `unseen` the rows of `problem` that no fit saw.
    `unseen` has the shape (samples,); a mask has no unit.
    """
    from ..ground.regression import boosted_trees  # seconds to import, and asked only where something is left

    left, inputs = problem.measured - problem.simulate(state), signals(problem.drivers)
    predict = boosted_trees(inputs[~unseen], left[~unseen], SEED)
    added = predict(inputs)
    return Foretold(
        added if fine is problem else predict(signals(fine.drivers)),
        locate.box(np.where(unseen, added - added[unseen].mean(), 0.0), problem),
        follows(problem.drivers, added),
    )


def follows(drivers: Drivers, signal: Array) -> str:
    """The driver whose own columns come nearest to a signal; not of the last strokes alone, which show little.

    Shape (samples,), in any unit.
    """
    left: dict[str, float] = {}
    for name, columns in generic.groups(drivers).items():
        if name == "time" or not len(columns):
            continue
        table = np.vstack([np.ones(len(signal)), columns]).T
        solution = np.linalg.lstsq(table, signal, rcond=1e-8)[0]
        left[name] = float(np.mean(np.square(signal - table @ solution)))
    return min(left, key=lambda name: left[name])
