"""Frames to bytes and back; no I/O, no clock, and nothing of ours is imported (docs/protocol.md)."""

from pipeline.wire.frames import Decoder, Event, Frame, Heard, Kind, Reason, encode
from pipeline.wire.hello import PROTOCOL, Channel, Hello
from pipeline.wire.recording import Account, End, Recording, read_recording

__all__ = [
    "PROTOCOL",
    "Account",
    "Channel",
    "Decoder",
    "End",
    "Event",
    "Frame",
    "Heard",
    "Hello",
    "Kind",
    "Reason",
    "Recording",
    "encode",
    "read_recording",
]
