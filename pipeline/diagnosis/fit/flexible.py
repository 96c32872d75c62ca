"""What a regression without physics predicts of strokes that no fit has seen: the level that physics has to reach.

Source: Friedman, "Greedy function approximation: a gradient boosting machine", Annals of Statistics 29, 2001.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...ground.kinematics import Array
from ..document.effects_named import Location
from ..recording.drivers import Drivers
from . import generic, locate
from .problem import Problem, State

MEMORIES = (0.02, 0.1)  # of the range of motion, over which a reversal is felt
SEED = 0  # of the boosted trees


@dataclass(frozen=True)
class Foretold:
    """What the regression adds to a simulator at the recording's own rate, where that lies, and what it follows."""

    added: Array  # one value a sample of the recording, in the reading's unit
    location: Location  # as `locate.box` says it, over the strokes that were held out
    driver: str  # as `generic.groups` calls it


def inputs(drivers: Drivers, span: float) -> dict[str, Array]:
    """The signals that the regression may use, by name: motion, its rates, its memory, load, and every other input.

    Time is left out: it would tell nothing of strokes to come. `span` is the range of the motion, in the motion's unit;
    memory is measured in shares of it. Each of shape (samples,), in its own unit.
    """
    by_name = {"motion": drivers.motion, "rate": drivers.rate, "acceleration": drivers.slope(drivers.rate)}
    by_name |= {f"way over {share:g} of the range": drivers.directed(share * span) for share in MEMORIES}
    by_name["load"] = drivers.load
    others = {"temperature": drivers.temperature_c, "current": drivers.current_a}
    return by_name | {name: drivers.smooth(other) for name, other in others.items() if other is not None}


def signals(drivers: Drivers) -> Array:
    """The columns that the regression uses from a recording, shape (samples, columns), each in its own unit.

    A load that hardly changes is left out.
    """
    by_name = inputs(drivers, drivers.span)
    return np.column_stack([column for name, column in by_name.items() if name != "load" or drivers.loaded])


def foretold(problem: Problem, fine: Problem, state: State, unseen: NDArray[np.bool_]) -> Foretold:
    """Boosted trees, fitted to the residual of a state in the rows that a fit saw, and asked about all rows.

    `fine` is the recording at its own rate, `unseen` the rows of `problem` that no fit saw.
    `unseen` has the shape (samples,); a mask has no unit.
    """
    from ...ground.numbers.regression import boosted_trees  # seconds to import, and asked only where something is left

    residual, inputs = problem.measured - problem.simulate(state), signals(problem.drivers)
    predict = boosted_trees(inputs[~unseen], residual[~unseen], SEED)
    added = predict(inputs)
    return Foretold(
        added if fine is problem else predict(signals(fine.drivers)),
        locate.box(np.where(unseen, added - added[unseen].mean(), 0.0), problem),
        follows(problem.drivers, added),
    )


def follows(drivers: Drivers, signal: Array) -> str:
    """The driver whose own columns fit a signal best; all strokes count, as the last ones alone show little.

    Shape (samples,), in any unit.
    """
    energy_by_driver: dict[str, float] = {}
    for name, columns in generic.groups(drivers).items():
        if name == "time" or not len(columns):
            continue
        table = np.vstack([np.ones(len(signal)), columns]).T
        solution = np.linalg.lstsq(table, signal, rcond=1e-8)[0]
        energy_by_driver[name] = float(np.mean(np.square(signal - table @ solution)))
    return min(energy_by_driver, key=lambda name: energy_by_driver[name])
