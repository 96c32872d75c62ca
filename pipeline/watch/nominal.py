"""The displacement of run.yaml's simulator at a recorded twist, with its zero set by the recording."""

from types import SimpleNamespace

import numpy as np

from ..ground.kinematics import Array
from ..run.description import Run


class Nominal:
    """A simulator without memory; `usable` says whether the recording has the columns that it needs."""

    def __init__(self, run: Run | None, columns: tuple[str, ...]) -> None:
        self._run, self._zero = run, float("nan")
        system = run.system if run else None
        self.usable = bool(
            system
            and not system.remembers
            and not system.differentiates
            and {system.driver, system.channel} <= {*columns}
        )
        self._columns = columns

    def at(self, rows: Array) -> Array:
        """Displacement at samples of shape (samples, 1 + channels), shape (samples,); the first call sets the zero.

        Time in s, each channel in its own unit.
        """
        assert self._run is not None
        system = self._run.system
        motion = rows[:, 1 + self._columns.index(system.driver)]
        nothing = np.zeros_like(motion)
        load = nothing + self._run.rig.get("load_n", 0.0)
        if system.load in self._columns:
            load = rows[:, 1 + self._columns.index(system.load)]
        inputs = SimpleNamespace(
            time_s=rows[:, 0], motion=motion, rate=nothing, acceleration=nothing, load=load / system.load_unit
        )
        values = np.array([parameter.nominal for parameter in system.parameters(self._run)])
        simulated = system.simulate(values, inputs, {})
        if np.isnan(self._zero):
            reading = rows[:, 1 + self._columns.index(system.channel)]
            self._zero = float(np.median(reading[:50] - simulated[:50])) if system.free_zero else 0.0
        return np.asarray(simulated + self._zero)
