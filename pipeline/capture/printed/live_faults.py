"""While printed lines come: whether their columns can be the channels that they are read as; told once."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ...ground.kinematics import Array, Geometry, Places
from ...ground.units import conversion
from ...run.description import STRING_ACTUATORS, Channel, Run
from ...run.dimensions import geometry
from ...run.doubts.exchanged_columns import as_exchanged, exchange, exchanged
from ...run.doubts.wrong_sign import FALLS, turned_sign
from ..motion_faults import FROZEN, LEAST_TURNS, MotionFaults, stands_words
from .copied_mend import copied_mends, is_by_columns
from .live_clock import LiveClock
from .read_channels import ReadChannels

MOST_SAMPLES = 4000  # are kept; then every second is left out
LEAST_SAMPLES = 20  # from so many on two columns are asked whether they are exchanged,
LEAST_SPAN_MM = 2.0  # where the string, if they are, contracted by so much
SURE = 2  # times in a row that they are found exchanged, before it is said


WHEN = ". When the recording has ended: "  # between what is wrong and what mends it


class Seen:
    """Channels of a selection of the samples so far, by name, in our units."""

    def __init__(self) -> None:
        self._values: dict[str, list[float]] = {}
        self._every = self._passed = 1

    def take(self, sample: dict[str, float]) -> None:
        """Keep a sample, if it is its turn."""
        self._passed -= 1
        if self._passed:
            return
        for name, value in sample.items():
            self._values.setdefault(name, []).append(value)
        if len(self) > MOST_SAMPLES:
            self._values = {name: values[::2] for name, values in self._values.items()}
            self._every *= 2
        self._passed = self._every

    def __len__(self) -> int:
        """How many are kept."""
        return len(self._values.get("motor_turns", []))

    def at(self, name: str, places: Places) -> Array:
        """Values of a channel in some samples, in its unit; shape (places,)."""
        return np.array(self._values[name])[places]

    def percentiles(self, name: str, q: Sequence[float]) -> Array:
        """Percentiles `q` of a channel, in its unit; shape (q,)."""
        return np.percentile(np.array(self._values[name]), q)

    def median(self, name: str) -> float:
        """Median of a channel, in its unit."""
        return float(np.median(self._values[name]))


class Reader:
    """A printed sample → the channels of a string run in our units; `places` is empty where it cannot be read so."""

    def __init__(self, run: Run, channels: ReadChannels) -> None:
        self.places: dict[str, tuple[int, float, float]] = {}
        self._load_n = run.rig.get("load_n", 0.0)
        for at, column in enumerate(channels.columns):
            place = channels.places.get(column)
            if place and place.channel in ("motor_turns", "displacement_mm", "load_n"):
                own = run.channels.get(place.channel, Channel.model_validate({}))
                try:
                    factor, shift = conversion(place.channel, place.unit, own.counts_per_turn)
                except ValueError:  # said when the recording is there
                    continue
                self.places[place.channel] = (at, factor * own.scale, factor * own.offset + shift)

    def sample(self, row: Sequence[str]) -> dict[str, float]:
        """The channels of a line; the load is the one in run.yaml if the line has none."""
        read = {name: factor * float(row[at]) + shift for name, (at, factor, shift) in self.places.items()}
        return {"load_n": self._load_n, **read}

    def quantum_mm(self, row: Sequence[str]) -> float:
        """The least step of the displacement, by the digits that are printed of it."""
        at, factor, _ = self.places["displacement_mm"]
        return abs(factor) * 10.0 ** -len(row[at].lower().partition("e")[0].partition(".")[2])


class LiveFaults:
    """Looks at every sample of a string run: whether its displacement stands, falls, or is another column."""

    def __init__(self, folder: Path, columns: Sequence[str], named_by_rig: bool = True) -> None:
        channels = ReadChannels(folder, columns)
        self._named_by_rig, self._mends = named_by_rig, list[str]()
        self.folder, self.columns, self.run = folder, columns, channels.run
        self._seen, self._found_exchanged, self._clock = Seen(), 0, LiveClock(channels)
        self._said: set[str] = set()
        self._motion: MotionFaults | None = None
        self._base: Geometry | None = None
        if self.run is not None and self.run.actuator in STRING_ACTUATORS:
            self._reader = Reader(self.run, channels)
            if {"motor_turns", "displacement_mm"} <= self._reader.places.keys():
                self._base = geometry(self.run)

    def look(self, row: Sequence[str]) -> str:
        """Take note of a sample; a sentence when something new is wrong, else nothing."""
        self._clock.take(row)
        if self._base is None or self.run is None:
            return ""
        sample = self._reader.sample(row)
        self._seen.take(sample)
        self._motion = self._motion or MotionFaults(self._reader.quantum_mm(row), self._contraction_mm)
        fault = self._motion.look(sample["motor_turns"], sample["displacement_mm"])
        if not fault or fault in self._said:
            return ""
        if exchanged_words := self.exchange(last=True):
            return exchanged_words
        if "exchanged" in self._said:
            return ""
        self._said.add(fault)
        if fault == FROZEN:
            return stands_words(max(LEAST_TURNS, self._motion.stood_turns))
        return f"displacement_mm {FALLS}; {self._mend(turned_sign(self.run))}"

    def clock(self) -> str:
        """A sentence if the time cannot be in the unit that it is read in."""
        fault = self._clock.fault()
        return f"{fault[0]}; {self._mend(fault[1])}" if fault else ""

    def exchange(self, last: bool = False) -> str:
        """A sentence if two columns seem to be exchanged; at the `last` check, one sighting is enough."""
        if self._base is None or self.run is None or "exchanged" in self._said or len(self._seen) < LEAST_SAMPLES:
            return ""
        pair = exchanged(self.run, self._seen, self._base)
        if pair is None or not self._contracted(pair):
            self._found_exchanged = 0
            return ""
        self._found_exchanged += 1
        if self._found_exchanged < SURE and not last:
            return ""
        self._said.add("exchanged")
        return self._mend(exchange(pair))

    def _mend(self, mend: str) -> str:
        """The mend with the command that carries it out; of run.yaml with all that was to be written there before."""
        commands = copied_mends([mend], self.folder, self.columns, self._named_by_rig)
        if commands and not is_by_columns(commands[0]):
            self._mends.append(mend)
            commands = copied_mends(self._mends, self.folder, self.columns, self._named_by_rig)
        return f"{mend}{WHEN}{commands[0]}" if commands else mend

    def _contraction_mm(self, turns: float) -> float:
        assert self._base is not None
        with np.errstate(all="ignore"):
            contraction_mm = float(self._base.contraction_mm(abs(turns), self._seen.median("load_n")))
        return contraction_mm if np.isfinite(contraction_mm) else 0.0

    def _contracted(self, pair: tuple[str, str]) -> bool:
        """Whether the column that would then be the displacement moved far enough, and the twist too."""
        assert self.run is not None
        seen = as_exchanged(self.run, self._seen, pair)
        span_mm, turns = (float(np.ptp(seen.percentiles(name, [1, 99]))) for name in ("displacement_mm", "motor_turns"))
        return span_mm >= LEAST_SPAN_MM and turns >= LEAST_TURNS
