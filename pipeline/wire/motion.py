"""A program of motion: its legs, their bytes on the wire, and the check against the limits of a device."""

import math
import struct
import zlib
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from enum import IntEnum
from typing import Any, NotRequired, TypedDict, cast

LEG = struct.Struct("<HIii")  # number from 0, duration in ms, turns at its end in 1/1000, load in 1/1000 N
PROGRAM = struct.Struct("<HI")  # how many legs, CRC-32 of their payloads in order
TAKEN = struct.Struct("<HIBH")  # legs and CRC-32 as the device has them, an Answer, the leg that it refuses from 1
AS_IT_HANGS = -(2**31)  # a load that the program leaves alone
MOST_LEGS, LONGEST_MS, FURTHEST = 4096, 2**32 - 1, 2.0e6  # turns and N: what fits 32 bits
MILLI = 1000


class Answer(IntEnum):
    """What a device says of a whole program."""

    TAKEN = 0
    BROKEN = 1
    LEGS = 2
    TURNS = 3
    SPEED = 4
    ACCELERATION = 5
    LOAD = 6
    SECONDS = 7
    BUSY = 8


@dataclass(frozen=True)
class Leg:
    """One straight way of the motor, from standstill to standstill; a load in N hangs from its beginning on."""

    seconds: float
    turns: float
    load_n: float | None = None

    def pack(self, number: int) -> bytes:
        """Payload of its frame; raises ValueError for what does not fit it."""
        loads_n = 0.0 if self.load_n is None else self.load_n
        if not 0 < self.seconds * MILLI <= LONGEST_MS or not max(abs(self.turns), abs(loads_n)) <= FURTHEST:
            raise ValueError(f"leg {number + 1}: cannot be written in the numbers of the protocol")
        load = AS_IT_HANGS if self.load_n is None else round(self.load_n * MILLI)
        return LEG.pack(number, max(1, round(self.seconds * MILLI)), round(self.turns * MILLI), load)

    @staticmethod
    def unpack(payload: bytes) -> "Leg":
        """The leg in a payload of the right size."""
        _, duration_ms, turns, load = LEG.unpack(payload)
        return Leg(duration_ms / MILLI, turns / MILLI, None if load == AS_IT_HANGS else load / MILLI)


class LimitsJson(TypedDict):
    """`program` of a HELLO: a device's limits for programs, in JSON; without `load_n` its load is fixed."""

    legs: int
    turns: tuple[float, float]
    turns_per_s: float
    turns_per_s2: float
    seconds: float
    silence_s: float
    at_turns: float
    load_n: NotRequired[tuple[float, float]]


@dataclass(frozen=True)
class Limits:
    """The limits of a device for programs, as its HELLO declares them under `program`."""

    legs: int
    turns: tuple[float, float]
    turns_per_s: float
    turns_per_s2: float
    seconds: float  # of the whole program
    silence_s: float  # of the host, after which the motor is stopped
    at_turns: float  # where the motor stands
    load_n: tuple[float, float] | None = None  # None: the device cannot change the load

    @staticmethod
    def of(content: Any) -> "Limits":
        """The limits in a HELLO; raises ValueError for invalid ones."""
        if not isinstance(content, dict):
            raise ValueError("program: is not an object")
        load = content.get("load_n")
        limits = Limits(
            legs=int(_number(content, "legs", 1, MOST_LEGS)),
            turns=_pair(content.get("turns"), "turns"),
            turns_per_s=_number(content, "turns_per_s", 0, FURTHEST),
            turns_per_s2=_number(content, "turns_per_s2", 0, FURTHEST),
            seconds=_number(content, "seconds", 0, LONGEST_MS / MILLI),
            silence_s=_number(content, "silence_s", 0, 60),
            at_turns=_number(content, "at_turns", -FURTHEST, FURTHEST),
            load_n=None if load is None else _pair(load, "load_n"),
        )
        if not (limits.turns_per_s > 0 and limits.turns_per_s2 > 0 and limits.seconds > 0 and limits.silence_s > 0):
            raise ValueError("program: turns_per_s, turns_per_s2, seconds and silence_s must be above 0")
        return limits

    @property
    def content(self) -> LimitsJson:
        """The limits as a HELLO has them."""
        return cast(LimitsJson, {key: value for key, value in asdict(self).items() if value is not None})

    def way_s(self, turns: float) -> float:
        """The shortest time for a way of so many turns, in s."""
        way = abs(turns)
        if way > self.turns_per_s**2 / self.turns_per_s2:  # far enough to reach full speed
            return way / self.turns_per_s + self.turns_per_s / self.turns_per_s2
        return 2.0 * math.sqrt(way / self.turns_per_s2)


def _number(content: dict[str, object], key: str, least: float, most: float) -> float:
    value = content.get(key)
    if isinstance(value, bool) or not isinstance(value, int | float) or not least <= value <= most:
        raise ValueError(f"program.{key}: is missing or is not a number from {least:g} to {most:g}")
    return float(value)


def _pair(value: Any, key: str) -> tuple[float, float]:
    if not isinstance(value, list | tuple) or len(value) != 2:
        raise ValueError(f"program.{key}: is not a list of the least and the most")
    low, high = (_number({key: end}, key, -FURTHEST, FURTHEST) for end in value)
    if low > high:
        raise ValueError(f"program.{key}: its least is above its most")
    return low, high


def cruise(way_turns: float, seconds: float, turns_per_s2: float) -> float | None:
    """The speed in turns/s between even ramps for a way in a given time; None where the ramps are too slow."""
    way = abs(way_turns)
    room = (turns_per_s2 * seconds) ** 2 - 4.0 * turns_per_s2 * way
    return None if room < 0 else (turns_per_s2 * seconds - math.sqrt(room)) / 2.0


def packed(legs: Sequence[Leg]) -> tuple[list[bytes], int]:
    """Payloads of all LEG frames, and the CRC-32 over them."""
    payloads = [leg.pack(number) for number, leg in enumerate(legs)]
    return payloads, zlib.crc32(b"".join(payloads))


def refusal(legs: Sequence[Leg], limits: Limits) -> tuple[Answer, int, str] | None:
    """Why a program is beyond the limits: the reason, the leg from 1 (0: the whole), and a sentence; else None."""
    if not 1 <= len(legs) <= limits.legs:
        return Answer.LEGS, 0, f"it has {len(legs)} legs, and the device takes 1 to {limits.legs}"
    at = limits.at_turns
    for number, leg in enumerate(legs, 1):
        low, high = limits.turns
        if not low <= leg.turns <= high:
            return Answer.TURNS, number, f"goes to {leg.turns:g} turns, and the rig goes from {low:g} to {high:g}"
        if leg.load_n is not None and limits.load_n is None:
            return Answer.LOAD, number, f"asks for {leg.load_n:g} N, and the rig cannot change its load"
        if leg.load_n is not None and limits.load_n and not limits.load_n[0] <= leg.load_n <= limits.load_n[1]:
            least_n, most_n = limits.load_n
            loads = f"{least_n:g} to {most_n:g} N" if least_n < most_n else f"{least_n:g} N"
            return Answer.LOAD, number, f"asks for {leg.load_n:g} N, and the rig hangs {loads}"
        way = abs(leg.turns - at)
        speed = cruise(way, leg.seconds, limits.turns_per_s2)
        if speed is None:
            ramps = f"ramps of {limits.turns_per_s2:g} turns/s2 do not go {way:g} turns in {leg.seconds:g} s"
            return Answer.ACCELERATION, number, ramps
        if speed > limits.turns_per_s * (1 + 1e-9):
            most = f"and the rig makes {limits.turns_per_s:g}"
            return Answer.SPEED, number, f"needs {speed:.4g} turns/s, {most}"
        at = leg.turns
    whole_s = sum(leg.seconds for leg in legs)
    if whole_s > limits.seconds:
        return Answer.SECONDS, 0, f"it takes {whole_s:g} s, and the device takes {limits.seconds:g} s"
    return None
