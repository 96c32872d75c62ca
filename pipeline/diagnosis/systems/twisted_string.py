"""The twisted string, with a separator (eqs 1–4) and as a pair without: twist, load and acts → displacement in mm."""

from dataclasses import dataclass

import numpy as np

from pipeline.diagnosis.drivers import LOAD_UNIT_N, Drivers
from pipeline.diagnosis.interface import Parameter
from pipeline.diagnosis.record import Record
from pipeline.kinematics import RAD_PER_TURN, Array, loaded_radius
from pipeline.run_yaml import Run

TOLERANCE = {"radius": 0.03, "separator_mm": 0.5, "torsion_zone_mm": 1.0, "length_mm": 2.0}
SCALE_SIGMA, ANGLE_SIGMA_TURNS = 0.005, 0.05  # of a displacement sensor's gain and a motor's untwisted zero


@dataclass(frozen=True)
class TwistedString:
    """Stages: twist → radius → geometry → length → sensor scale. Acts enter at their stage."""

    name: str
    separated: bool
    channel: str = "displacement_mm"

    def parameters(self, run: Run) -> list[Parameter]:
        """Radius, then the dimensions of the zone or of the pair, then sensor scale and the zero of the angle."""
        assert run.string is not None
        sigma = {**TOLERANCE, **run.tolerance}
        string = run.string
        found = [Parameter("radius_mm", string.radius_mm, sigma["radius"] * string.radius_mm)]
        if self.separated:
            found += [
                Parameter("separator_mm", run.rig["separator_mm"], sigma["separator_mm"], lowest=0.0),
                Parameter("torsion_zone_mm", run.rig["torsion_zone_mm"], sigma["torsion_zone_mm"]),
            ]
        found.append(Parameter("length_mm", string.length_mm, sigma["length_mm"]))
        found.append(Parameter("scale", 1.0, SCALE_SIGMA))
        found.append(Parameter("angle_turns", 0.0, ANGLE_SIGMA_TURNS))
        found.append(Parameter("stiffness_n_per_mm", string.stiffness_n_per_mm, 0.0))
        return found

    def _geometry(self, values: Array, turns: Array, load_n: Array, radius_change: Array) -> tuple[Array, Array]:
        """Contraction in mm and the sine of the helix angle."""
        if self.separated:
            radius, separator, zone, length, _, angle, stiffness = values
            section = loaded_radius(radius, length, stiffness, load_n) * (1.0 + radius_change)
            offset = separator + RAD_PER_TURN * (turns + angle) * section
            strand = np.hypot(zone, offset)
            return strand - zone, offset / strand
        radius, length, _, angle, _ = values
        wound = RAD_PER_TURN * (turns + angle) * radius * (1.0 + radius_change)
        wound = np.clip(wound, -0.98 * length, 0.98 * length)
        return length - np.sqrt(length * length - wound * wound), wound / length

    def drivers(self, record: Record, run: Run) -> Drivers:
        """Drivers at the nominal dimensions."""
        nominal = np.array([parameter.nominal for parameter in self.parameters(run)])
        turns, load_n = record.motion, record.load
        contraction, sine = self._geometry(nominal, turns, load_n, np.zeros_like(turns))
        change = np.flatnonzero(np.diff(record.run_index, prepend=-1))
        first = np.arange(len(record)) - np.repeat(change, np.diff(change, append=len(record)))
        spread = np.subtract(*np.percentile(load_n, [95, 5]))
        return Drivers(
            record.time_s, turns, load_n / LOAD_UNIT_N, bool(spread > 0.05 * max(abs(float(np.median(load_n))), 0.1)),
            sine, sine / np.sqrt(np.maximum(1.0 - sine * sine, 1e-6)), contraction - contraction[0], record.stroke,
            record.phase, first, record.temperature_c, record.current_a,
        )  # fmt: skip

    def simulate(self, values: Array, drivers: Drivers, acts: dict[str, Array]) -> Array:
        """Displacement in mm, without its zero."""
        nothing = np.zeros_like(drivers.turns)
        turns = drivers.turns + acts.get("twist", nothing)
        load_n = drivers.load * LOAD_UNIT_N
        contraction, _ = self._geometry(values, turns, load_n, acts.get("radius", nothing))
        scale = values[-3]
        return np.asarray(scale * (contraction - acts.get("length", nothing)))


SYSTEMS = {
    "separator": TwistedString("separator", True),
    "twisted_pair": TwistedString("twisted_pair", False),
}
