"""The check at the end of a frame: 16 bits in protocol 1, 32 bits in protocol 2; no other version is known."""

import struct
import zlib
from binascii import crc_hqx

PROTOCOL = 2  # what is spoken where nothing else is asked for
MAX_PAYLOAD = 2048
CRC = {1: struct.Struct("<H"), 2: struct.Struct("<I")}  # by the protocol's version
VERSIONS = (2, 1)  # in the order in which they are tried: a frame of 2 passes as one of 1 once in 65,536


def checksum(data: bytes, protocol: int = PROTOCOL) -> int:
    """CRC-32 as in zip and Ethernet; in protocol 1 CRC-16/CCITT-FALSE (polynomial 0x1021, start 0xFFFF)."""
    return crc_hqx(data, 0xFFFF) if protocol == 1 else zlib.crc32(data)
