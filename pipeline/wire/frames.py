"""One frame: COBS(kind u8, seq u32, payload, check) and a zero byte; all numbers little-endian."""

import struct
from dataclasses import dataclass, field
from enum import IntEnum

from .check import CRC, MAX_PAYLOAD, PROTOCOL, VERSIONS, checksum
from .cobs import stuff, unstuff
from .hello import Hello

HEAD = struct.Struct("<BI")
MAX_STUFFED = (HEAD.size + MAX_PAYLOAD + CRC[2].size) * 255 // 254 + 1  # what a frame can be without its zero byte


class Kind(IntEnum):
    """The kind of a frame: from the device below 0x80, from the host above."""

    HELLO = 1
    SAMPLE = 2
    EVENT = 3
    END = 4
    TAKEN = 5
    GREET = 0x81
    START = 0x82
    STOP = 0x83
    ACK = 0x84
    LEG = 0x85
    PROGRAM = 0x86
    BEAT = 0x87


class Event(IntEnum):
    """The meaning of an EVENT frame; its value is the number of the stroke or of the fault."""

    STROKE_START = 1
    STROKE_END = 2
    FAULT = 3


class Reason(IntEnum):
    """Why a recording ended."""

    COMPLETE = 0
    STOPPED = 1
    FAULT = 2
    SILENCE = 3  # of the host


EVENT = struct.Struct("<IBi")  # t_us, code, value
END = struct.Struct("<IB")  # samples sent, reason


@dataclass(frozen=True)
class Frame:
    """A frame whose check was right; `kind` is a Kind, or a number that a later protocol may know."""

    kind: int
    seq: int
    payload: bytes = b""
    protocol: int = PROTOCOL


def encode(kind: int, seq: int, payload: bytes = b"", protocol: int = PROTOCOL) -> bytes:
    """Bytes of a frame on the wire, its ending zero included; raises ValueError for a payload that is too long."""
    if len(payload) > MAX_PAYLOAD:
        raise ValueError(f"a payload of {len(payload)} bytes is longer than {MAX_PAYLOAD}")
    body = HEAD.pack(kind, seq & 0xFFFFFFFF) + payload
    return stuff(body + CRC[protocol].pack(checksum(body, protocol))) + b"\0"


def decode(stuffed: bytes, protocol: int | None = PROTOCOL) -> Frame | None:
    """The frame in the bytes between two zeros, or None when it is damaged; by either version's check if None."""
    body = unstuff(stuffed) if len(stuffed) <= MAX_STUFFED else None
    for version in VERSIONS if protocol is None else (protocol,):
        crc = CRC[version]
        if body is None or len(body) < HEAD.size + crc.size:
            continue
        if checksum(body[: -crc.size], version) == crc.unpack(body[-crc.size :])[0]:
            kind, seq = HEAD.unpack_from(body)
            return Frame(kind, seq, body[HEAD.size : -crc.size], version)
    return None


def greeting(frame: Frame | None) -> Hello | None:
    """The HELLO in a frame, if there is one and its check is that of the version it names."""
    if frame is None or frame.kind != Kind.HELLO:
        return None
    try:
        hello = Hello.unpack(frame.payload)
    except ValueError:
        return None
    return hello if hello.protocol == frame.protocol else None


@dataclass(frozen=True)
class Heard:
    """A good frame in a stream: its exact bytes, and the position in the chunk where it ends."""

    frame: Frame
    raw: bytes
    end: int


@dataclass
class Decoder:
    """Frames out of chunks of any size; after garbage the next zero byte puts it right.

    `bad` counts what stood between two zeros and was no frame. It holds at most one frame's bytes. Without a
    `protocol` it takes frames of either version until a HELLO says which one is spoken, and from there on no other.
    """

    protocol: int | None = None
    bad: int = 0
    _rest: bytearray = field(default_factory=bytearray)
    _overlong: bool = False

    @property
    def rest(self) -> bytes:
        """Bytes after the last zero: the beginning of a frame, unless they are already too many for one."""
        return bytes(self._rest)

    def feed(self, chunk: bytes) -> list[Heard]:
        """Whole frames that end in `chunk`."""
        frames = []
        at = 0
        while (zero := chunk.find(b"\0", at)) >= 0:
            self._keep(chunk[at:zero])
            at = zero + 1
            frame = None if self._overlong else decode(bytes(self._rest), self.protocol)
            if frame is not None:
                if self.protocol is None and greeting(frame) is not None:
                    self.protocol = frame.protocol
                frames.append(Heard(frame, bytes(self._rest) + b"\0", at))
            elif self._rest or self._overlong:
                self.bad += 1
            self._rest.clear()
            self._overlong = False
        self._keep(chunk[at:])
        return frames

    def _keep(self, piece: bytes) -> None:
        if self._overlong or len(self._rest) + len(piece) > MAX_STUFFED:
            self._overlong = True
            self._rest.clear()
        else:
            self._rest += piece
