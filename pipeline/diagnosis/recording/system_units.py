"""Names and units of what acts, in a system's own words: the library is written for a string, in mm, turns and 10 N."""

import re
from dataclasses import dataclass

from ...ground.units import unit_of
from ...systems import System


@dataclass(frozen=True)
class Units:
    """Units of a system's motion, of its reading, and of its load, of which mechanisms see multiples of `load_size`."""

    motion: str
    reading: str
    load: str
    load_size: float

    @classmethod
    def of(cls, system: System) -> "Units":
        """Units of a system, from the endings of its columns."""
        load = unit_of(system.load) if system.load else "load"
        return cls(unit_of(system.driver), unit_of(system.channel), load, system.load_unit)

    @property
    def _load(self) -> str:
        return f"{self.load_size:g}{self.load}"

    def name(self, name: str) -> str:
        """A name of the library in these units, as `straight_mm_per_turn_s` or `toe_5_n_mm`."""
        words = {"mm": self.reading, "turns": self.motion, "turn": self.motion.rstrip("s")}
        if not self._strange:
            return name

        def load(match: re.Match[str]) -> str:
            return f"{float(match[1]) / 10.0 * self.load_size:g}_{self.load}"

        own_name = re.sub(r"([0-9.]+)_n(?=_|$)", load, name)

        def word(ours: str) -> str:
            stem = ours.rstrip("0123456789")  # the power of a unit stays
            return words[stem] + ours[len(stem) :] if stem in words else ours

        return "_".join(map(word, own_name.split("_"))).lower()

    def unit(self, unit: str) -> str:
        """A unit of the library in these units, as `mm/10N`."""
        words = {"mm": self.reading, "turns": self.motion, "turn": self.motion.rstrip("s"), "10N": self._load}
        return re.sub(r"10N|mm|turns?", lambda match: words[match.group()], unit) if self._strange else unit

    @property
    def _strange(self) -> bool:
        return (self.motion, self.reading, self._load) != ("turns", "mm", "10N")
