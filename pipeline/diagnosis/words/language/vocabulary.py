"""What things are called on a rig: its motion, its reading, its directions; by the names of its columns."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from ....ground.units import unit_of
from ....systems import System

ANGLES = ("deg", "rad", "turns")
LENGTHS = ("m", "cm", "mm", "µm")
PHASES = ("winding", "hold", "unwinding", "rest", "all")


@dataclass(frozen=True)
class Vocabulary:
    """Words and units of one kind of rig; `ending` is that of the JSON's keys."""

    string: str  # what transmits: "string", "drive"
    motion: str  # what the motor does: "twist", "motor angle", "position"
    rate: str  # of the motion
    reading: str  # what is predicted
    motion_unit: str
    unit: str  # of the reading
    load_unit: str
    driver: str  # column of the motion
    load: str | None  # column of the load
    ending: str
    twisted: bool
    usual: Mapping[str, float] = field(default_factory=dict)  # keys of `tolerance:` with their defaults
    shares: Mapping[str, float] = field(default_factory=dict)  # those that are shares
    measured: Mapping[str, str] = field(default_factory=dict)  # how a dimension is measured, by its name
    differentiates: bool = False  # whether the reading follows derivatives of the motion
    channel: str = ""  # column of the reading

    @classmethod
    def of(cls, system: System) -> "Vocabulary":
        """Words of a system: those of a string where it is one, else from the names of its columns."""
        twisted = system.needs_string
        motion, motion_unit = _named(system.driver)
        reading, unit = _named(system.channel)
        return cls(
            "string" if twisted else "drive", "twist" if twisted else motion,
            "twisting rate" if twisted else "speed", reading, motion_unit, unit,
            unit_of(system.load) if system.load else "", system.driver, system.load,
            system.channel.rpartition("_")[2], twisted, system.tolerance,
            {key: usual for key, usual in system.tolerance.items() if key not in system.absolute}, system.measured,
            system.differentiates, system.channel,
        )  # fmt: skip

    @property
    def ways(self) -> tuple[str, str]:
        """The two directions."""
        if self.twisted:
            return "winding", "unwinding"
        up, down = directions(self.motion_unit)
        return f"the way {up}", f"the way {down}"

    @property
    def verbs(self) -> tuple[str, str]:
        """What a technician does with the motor, up and down."""
        return ("wind", "unwind") if self.twisted else ("go", "go back")

    @property
    def fields(self) -> dict[str, str]:
        """Words that a mechanism's sentence may use."""
        ways = self.ways
        return {
            "string": self.string, "motion": self.motion, "rate": self.rate, "reading": self.reading,
            "up": ways[0], "down": ways[1],
        }  # fmt: skip

    def phase(self, phase: str) -> str:
        """A phase of the strokes."""
        up, down = self.ways
        phrases = {"winding": f"on {up}", "unwinding": f"on {down}", "hold": "in holds", "rest": "at rest"}
        if self.twisted:
            phrases |= {"winding": "while winding", "unwinding": "while unwinding"}
        return phrases.get(phase, "in all phases")

    def follows(self, driver: str, loaded: bool = True) -> str:
        """What an effect follows, as the library or the generic dictionary calls it, in this rig's words."""
        phrase = FOLLOWED.get(driver, driver)
        if not loaded:
            phrase = phrase.replace(" and the load", "").replace("the load and ", "")
        if self.twisted:
            return phrase
        phrase = phrase.replace("twisting rate", self.rate).replace("displacement rate", f"rate of the {self.reading}")
        return phrase.replace("twist", self.motion).replace("displacement", self.reading)


def directions(motion_unit: str) -> tuple[str, str]:
    """The names of both directions where nothing is wound: for a place, an angle, or a value such as a voltage."""
    return ("forward", "back") if motion_unit in (*LENGTHS, *ANGLES) else ("up", "down")


# how the words of `Mechanism.driver` and of `generic.groups`, which decide, are said
FOLLOWED = {
    "direction x load": "the direction of motion and the load",
    "direction": "the direction of motion",
    "load x worked strokes": "the load and the strokes worked so far",
    "worked strokes": "the strokes worked so far",
    "torque (load x twist)": "the torque, which is load times twist",
    "reading at its end": "the end of the reading's range",
    "nothing: a constant": "a constant",
    "sudden events on the length": "sudden events in the length",
    "sudden events on the twist": "sudden losses of twist",
    "absolute time": "the time alone, in motion and at rest",
    "load": "the load",
    "temperature": "the temperature",
    "current": "the motor's current",
    "time": "the time",
    "speed": "the speed",
    "travel": "the distance travelled",
    "acceleration": "starts and stops",
    "angle within the turn": "the angle within the turn",
    "time under load": "time under load",
    "displacement rate": "the displacement rate",
    "twisting rate": "the twisting rate",
    "twist": "the twist",
    "time, as a steady oscillation": "the time: it oscillates steadily",
}


def _named(column: str) -> tuple[str, str]:
    """The name of a column's quantity, and its unit: `jaw angle` and `deg` for `jaw_deg`."""
    unit = unit_of(column)
    stem = column.removesuffix(f"_{unit.lower()}") if unit != "1" else column
    words = (stem if stem != column else column.rpartition("_")[0] or column).replace("_", " ")
    return (f"{words} angle" if unit in ANGLES and "angle" not in words else words), unit
