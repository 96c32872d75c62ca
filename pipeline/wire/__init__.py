"""Frames to bytes and back; no I/O, no clock, and nothing of ours is imported (docs/protocol.md)."""

from pipeline.wire.account import Account, End, Gap
from pipeline.wire.check import PROTOCOL
from pipeline.wire.frames import Decoder, Event, Frame, Heard, Kind, Reason, encode
from pipeline.wire.hello import Channel, Hello
from pipeline.wire.recording import Recording, read_account, read_recording

__all__ = [
    "PROTOCOL",
    "Account",
    "Channel",
    "Decoder",
    "End",
    "Event",
    "Frame",
    "Gap",
    "Heard",
    "Hello",
    "Kind",
    "Reason",
    "Recording",
    "encode",
    "read_account",
    "read_recording",
]
