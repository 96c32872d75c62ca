"""Bytes of a file, unpacked where it is gzipped, and never more than a recording can have."""

import gzip
import os
import zlib
from pathlib import Path

from ..ground.errors import BadInput
from ..ground.stored.regular_file import open_regular

GZIP = b"\x1f\x8b"  # how such a file begins, whatever its name
PIECE = 1 << 20
BOMB_BYTES, BOMB_RATIO = 50_000_000, 200  # unpacked size from which, and packing by which, a file holds no readings
NO_READINGS = f"is packed more than {BOMB_RATIO}-fold, as no readings can be"
IS_IT = "check that it is the recording"


def is_bomb(unpacked: int, packed: int) -> bool:
    """Whether so many bytes, packed into so few, can hold no readings."""
    return unpacked > BOMB_BYTES and unpacked > BOMB_RATIO * max(packed, 1)


def unpacked(path: Path, largest: int, mend: str) -> bytes:
    """Bytes of a plain or gzipped file; raises BadInput, with the mend, for more than `largest`, and for a bomb."""
    pieces, read = [], 0
    with open_regular(path) as file:
        zipped = file.read(2) == GZIP
        file.seek(0)
        packed = os.fstat(file.fileno()).st_size
        content = gzip.GzipFile(fileobj=file) if zipped else file
        try:
            while piece := content.read(PIECE):
                pieces.append(piece)
                read += len(piece)
                if zipped and is_bomb(read, packed):
                    raise BadInput(path, "file", NO_READINGS, IS_IT)
                if read > largest:
                    raise BadInput(path, "file", f"has more than {largest / 1e6:g} MB", mend)
        except (OSError, EOFError, zlib.error) as error:
            raise BadInput(path, "file", f"cannot be read ({error})", "copy it again from the logger") from None
    return b"".join(pieces)
