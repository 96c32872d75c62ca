"""Consistent Overhead Byte Stuffing: any bytes as bytes without a zero, at one byte more per 254 (Cheshire 1997)."""


def stuff(data: bytes) -> bytes:
    """`data` without zero bytes; the zero that ends a frame is not added."""
    stuffed = bytearray()
    groups = data.split(b"\0")
    for number, group in enumerate(groups):
        while len(group) >= 254:
            stuffed += b"\xff" + group[:254]
            group = group[254:]
            if not group and number == len(groups) - 1:
                return bytes(stuffed)  # a full last group needs no empty one after it
        stuffed.append(len(group) + 1)
        stuffed += group
    return bytes(stuffed)


def unstuff(stuffed: bytes) -> bytes | None:
    """The unstuffed bytes, or None for bytes that stuffing cannot make."""
    data = bytearray()
    at = 0
    while at < len(stuffed):
        code = stuffed[at]
        group = stuffed[at + 1 : at + code]
        if code == 0 or len(group) != code - 1 or 0 in group:
            return None
        data += group
        at += code
        if code < 255 and at < len(stuffed):
            data.append(0)
    return bytes(data) if stuffed else None
