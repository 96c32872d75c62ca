"""While printed lines come: whether the time can be in the unit that run.yaml reads it in."""

from collections.abc import Sequence

from ...ground.units import conversion
from ...run.description import STRING_ACTUATORS, Channel, Run
from ...run.table.rate import is_rate, no_rate, unit_of_rate
from .holes import Steps
from .read_channels import ReadChannels

LEAST_SAMPLES = 6  # by whose steps the unit is judged
FASTEST_S = 5e-4  # between two lines: no port prints faster, so 100 in a step are ms and not us


class LiveClock:
    """The first steps of the time of a string run; it judges them once."""

    def __init__(self, channels: ReadChannels) -> None:
        self._steps, self._samples, self._at = Steps(), 0, -1
        if channels.run is not None and channels.run.actuator in STRING_ACTUATORS:
            self._place(channels, channels.run)

    def _place(self, channels: ReadChannels, run: Run) -> None:
        for at, column in enumerate(channels.columns):
            place = channels.places.get(column)
            if place and place.channel == "time_s":
                scale = run.channels.get("time_s", Channel.model_validate({})).scale
                try:
                    self._at, self._unit, self._s = at, place.unit, conversion("time_s", place.unit)[0] * scale
                except ValueError:  # said when the recording is there
                    return

    def take(self, row: Sequence[str]) -> None:
        """Take note of a line's time."""
        if self._at >= 0:
            self._samples += 1
            self._steps.take(float(row[self._at]))

    def fault(self) -> tuple[str, str] | None:
        """What is wrong with the steps, and the mend, once they are enough and where one unit alone makes a rate."""
        if self._at < 0 or self._samples < LEAST_SAMPLES:
            return None
        self._at, step_s = -1, self._steps.usual * self._s
        told_unit = unit_of_rate(step_s, self._unit, fastest_s=FASTEST_S)
        if not step_s or is_rate(step_s) or not told_unit.startswith("to "):
            return None
        return f"time_s is read in {self._unit}: {no_rate(step_s)}", f"set channels.time_s.unit {told_unit}"
