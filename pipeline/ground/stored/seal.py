"""A check sum in every stored file: it shows on reading that a bit has changed, or that the end is missing."""

import errno
import hashlib
import json
import mmap
import os
import stat
import struct
from pathlib import Path
from typing import Any, BinaryIO

MARK = b"twistbench sha-256 "
SEAL_BYTES = len(MARK) + hashlib.sha256().digest_size
PARQUET_TAIL = struct.Struct("<I4s")  # the footer's length, then Parquet's own mark
CHUNK_BYTES = 1 << 22


class Damaged(Exception):
    """A file whose check sum is missing or does not fit its content."""


def content_of(path: Path | str) -> memoryview:
    """The bytes of a file, mapped and not copied; raises OSError."""
    if not stat.S_ISREG(os.stat(path).st_mode):  # a pipe would never end, a folder has no bytes
        raise OSError(errno.EINVAL, "is not a file", str(path))
    with open(path, "rb") as file:
        if not os.fstat(file.fileno()).st_size:
            return memoryview(b"")
        return memoryview(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))


def _seal(*parts: bytes | memoryview) -> bytes:
    digest = hashlib.sha256()
    for part in parts:
        digest.update(part)
    return MARK + digest.digest()


def _footer_bytes(end: bytes | memoryview, whole: int) -> int:
    """Length of a Parquet file's footer with its tail, from the file's last bytes; raises Damaged."""
    if len(end) == PARQUET_TAIL.size:
        length, mark = PARQUET_TAIL.unpack(end)
        if mark == b"PAR1" and length + PARQUET_TAIL.size + SEAL_BYTES <= whole:
            return int(length) + PARQUET_TAIL.size
    raise Damaged("its end is missing")


def seal_parquet(temporary: Path) -> None:
    """Put the seal of a whole Parquet file between its data and its footer, where no reader of Parquet looks."""
    with open(temporary, "rb+") as file:
        size = file.seek(0, os.SEEK_END)
        file.seek(size - PARQUET_TAIL.size)
        start = size - _footer_bytes(file.read(), size + SEAL_BYTES)
        file.seek(0)
        digest = hashlib.sha256()
        _digest(file, start, digest)
        footer = file.read()
        digest.update(footer)
        file.seek(start)
        file.write(MARK + digest.digest() + footer)


def is_sealed(file: BinaryIO) -> bool:
    """Whether an open file carries our seal, right or wrong, anywhere; reads it once, in pieces."""
    file.seek(0)
    before = b""
    while part := file.read(CHUNK_BYTES):
        if MARK in before + part:
            return True
        before = part[1 - len(MARK) :]
    return False


def check_parquet(content: memoryview) -> None:
    """Raise Damaged unless a Parquet file's content fits its seal."""
    start = len(content) - _footer_bytes(content[-PARQUET_TAIL.size :], len(content))
    if content[start - SEAL_BYTES : start] != _seal(content[: start - SEAL_BYTES], content[start:]):
        raise Damaged("its check sum is missing or wrong")


def check_parquet_file(file: BinaryIO) -> None:
    """Raise Damaged unless an open Parquet file's content fits its seal; reads it once, in pieces."""
    size = file.seek(0, os.SEEK_END)
    file.seek(max(size - PARQUET_TAIL.size, 0))
    start = size - _footer_bytes(file.read(), size)
    file.seek(start - SEAL_BYTES)
    stored_seal = file.read(SEAL_BYTES)
    digest = hashlib.sha256()
    for begin, end in ((0, start - SEAL_BYTES), (start, size)):
        file.seek(begin)
        _digest(file, end - begin, digest)
    if stored_seal != MARK + digest.digest():
        raise Damaged("its check sum is missing or wrong")


def _digest(file: BinaryIO, bytes_left: int, digest: "hashlib._Hash") -> None:
    """Add that many of a file's next bytes to a check sum."""
    while bytes_left:
        part = file.read(min(CHUNK_BYTES, bytes_left))
        digest.update(part)
        bytes_left -= len(part)


def sealed(content: bytes) -> bytes:
    """A content with its seal at its end, for files of any other kind."""
    return content + _seal(content)


def opened(content: bytes | memoryview) -> memoryview:
    """The content without its seal; raises Damaged."""
    content = memoryview(content)
    inside = content[:-SEAL_BYTES]
    if len(content) < SEAL_BYTES or content[-SEAL_BYTES:] != _seal(inside):
        raise Damaged("its check sum is missing or wrong")
    return inside


def sealed_json(content: Any) -> str:
    """A content as JSON that holds the check sum of the content's own JSON beside it."""
    text = json.dumps(content)
    return f'{{"sha256": "{hashlib.sha256(text.encode()).hexdigest()}",\n"content": {text}}}\n'


def opened_json(stored: bytes | memoryview) -> Any:
    """The content of such JSON; raises Damaged where any byte is not as `sealed_json` writes it."""
    stored = bytes(stored)
    try:
        content = json.loads(stored)["content"]
        whole = sealed_json(content).encode() == stored
    except (ValueError, TypeError, KeyError, RecursionError):
        whole = False
    if not whole:
        raise Damaged("its check sum is missing or wrong")
    return content


def check(path: Path) -> None:
    """Raise Damaged unless a stored table (`.parquet`), note (`.json`) or model is as written; raises OSError."""
    content = content_of(path)
    if path.suffix == ".parquet":
        check_parquet(content)
    elif path.suffix == ".json":
        opened_json(content)
    else:
        opened(content)
