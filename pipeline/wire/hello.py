"""The HELLO: what a device says of itself before it is started, as compact JSON."""

import json
import math
import re
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any, NotRequired, TypedDict, cast

from .check import CRC, MAX_PAYLOAD, PROTOCOL
from .motion import Limits, LimitsJson

MAX_CHANNELS = 16
RATES_HZ = (1.0, 100_000.0)
MOST_STROKES = 1_000_000
LARGEST = 1e30  # of a scale or an offset: a sample times it is still a number
INTEGERS = {"i8": "<i1", "u8": "<u1", "i16": "<i2", "u16": "<u2", "i32": "<i4", "u32": "<u4"}  # to numpy's names
CHANNEL_NAME = re.compile(r"[a-z][a-z0-9_]{0,31}")


class ChannelJson(TypedDict):
    """A channel of a HELLO, as JSON has it: value = scale · integer + offset, in `unit`."""

    name: str
    unit: str
    type: str
    scale: float
    offset: float


class HelloJson(TypedDict):
    """A HELLO, as JSON has it; a device that takes no program of motion leaves `program` out."""

    device: str
    firmware: str
    nonce: str
    rate_hz: float
    strokes: int
    channels: Sequence[ChannelJson]
    protocol: int
    program: NotRequired[LimitsJson]


@dataclass(frozen=True)
class Channel:
    """One number of every SAMPLE: value = scale · integer + offset, in `unit`."""

    name: str
    unit: str
    type: str
    scale: float
    offset: float = 0.0


@dataclass(frozen=True)
class Hello:
    """A device and its coming recording; `nonce` is new with every boot, `program` are its limits, if any."""

    device: str
    firmware: str
    nonce: str
    rate_hz: float
    strokes: int
    channels: tuple[Channel, ...]
    protocol: int = PROTOCOL
    program: Limits | None = None

    @property
    def content(self) -> HelloJson:
        """The HELLO as JSON has it; a device that takes no program leaves `program` out."""
        hello = cast(HelloJson, {key: value for key, value in asdict(self).items() if key != "program"})
        if self.program:
            hello["program"] = self.program.content
        return hello

    def pack(self) -> bytes:
        """Payload of the HELLO frame; raises ValueError when it would be too long."""
        payload = json.dumps(self.content, separators=(",", ":")).encode()
        if len(payload) > MAX_PAYLOAD:
            raise ValueError(f"a HELLO of {len(payload)} bytes is longer than {MAX_PAYLOAD}")
        return payload

    @staticmethod
    def unpack(payload: bytes) -> "Hello":
        """The HELLO in a payload; keys that this version does not know are left out.

        Raises ValueError, with the reason in its text, for a payload that is not one.
        """
        try:
            content = json.loads(payload)
        except (ValueError, RecursionError):
            raise ValueError("is not JSON") from None
        if not isinstance(content, dict):
            raise ValueError("is not an object")
        protocol = _get(content, "protocol", int)
        if protocol not in CRC:
            versions = " and ".join(map(str, CRC))
            raise ValueError(f"protocol: is version {protocol}, and only the versions {versions} are known here")
        channels = _get(content, "channels", list)
        if not 1 <= len(channels) <= MAX_CHANNELS:
            raise ValueError(f"channels: must be 1 to {MAX_CHANNELS}")
        hello = Hello(
            device=_get(content, "device", str),
            firmware=_get(content, "firmware", str),
            nonce=_get(content, "nonce", str),
            rate_hz=_number(content, "rate_hz"),
            strokes=_get(content, "strokes", int),
            channels=tuple(_channel(channel) for channel in channels),
            protocol=protocol,
            program=Limits.of(content["program"]) if content.get("program") is not None and protocol > 1 else None,
        )
        if not RATES_HZ[0] <= hello.rate_hz <= RATES_HZ[1]:
            raise ValueError(f"rate_hz: must be from {RATES_HZ[0]:g} to {RATES_HZ[1]:g}")
        if not 0 <= hello.strokes <= MOST_STROKES:
            raise ValueError(f"strokes: must be from 0 to {MOST_STROKES}")
        if len({channel.name for channel in hello.channels}) < len(channels):
            raise ValueError("channels: two have the same name")
        return hello

    @property
    def sample_type(self) -> list[tuple[str, str]]:
        """Fields of a SAMPLE's payload as numpy's structured type has them."""
        return [("t_us", "<u4"), *((channel.name, INTEGERS[channel.type]) for channel in self.channels)]


def _get(content: dict[str, object], key: str, kind: type) -> Any:
    value = content.get(key)
    if not isinstance(value, kind) or isinstance(value, bool):
        raise ValueError(f"{key}: is missing or is not of type {kind.__name__}")
    if isinstance(value, str) and any("\ud800" <= character <= "\udfff" for character in value):
        raise ValueError(f"{key}: is no text that can be written")  # half a character: JSON may spell it
    return value


def _number(content: dict[str, object], key: str, default: float | None = None) -> float:
    value: Any = content.get(key, default)
    try:
        number = math.nan if isinstance(value, (bool, str)) or value is None else float(value)
    except (TypeError, OverflowError):
        number = math.nan
    if not abs(number) <= LARGEST:  # nor NaN
        raise ValueError(f"{key}: is missing or is not a number of at most {LARGEST:g}")
    return number


def _channel(content: Any) -> Channel:
    if not isinstance(content, dict):
        raise ValueError("channels: one is not an object")
    name, integer = _get(content, "name", str), _get(content, "type", str)
    if not CHANNEL_NAME.fullmatch(name) or name == "t_us":
        raise ValueError(f"channels: {name!r} is no name of a channel")
    if integer not in INTEGERS:
        raise ValueError(f"channels: {name} has the type {integer!r}; known are {', '.join(INTEGERS)}")
    unit = _get(content, "unit", str)
    return Channel(name, unit, integer, _number(content, "scale"), _number(content, "offset", 0.0))
