"""Frames to bytes and back; no I/O, no clock, and nothing of ours is imported (docs/protocol.md)."""

from .check import PROTOCOL
from .decoded_recording import PIECE, Pieces, Recording, read_account, read_pieces, read_recording
from .frame_account import Account, End, Gap
from .frames import Decoder, Event, Frame, Heard, Kind, Reason, encode
from .growing_account import Ledger
from .hello import Channel, Hello

__all__ = [
    "PIECE",
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
    "Ledger",
    "Pieces",
    "Reason",
    "Recording",
    "encode",
    "read_account",
    "read_pieces",
    "read_recording",
]
