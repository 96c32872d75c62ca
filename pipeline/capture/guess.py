"""A guess at what a port sends if it is not the expected protocol: a sentence, and what to do about it."""

from ..wire import Decoder

TEXT_SHARE = 0.9
SLOW_TURNS = 2.3  # changes from bit to bit in a byte; 3.5 in noise, and half of it where every bit is read twice


def _bit_turns(data: bytes) -> float:
    """Mean number of changes between neighbouring bits of a byte."""
    return sum(((byte ^ (byte >> 1)) & 0x7F).bit_count() for byte in data) / len(data)


def guess(heard: bytes, baud: int) -> tuple[str, str]:
    """What bytes without a HELLO look like, and the mend; `heard` is not empty."""
    decoder = Decoder()
    good = len(decoder.feed(heard))
    if good:
        return (
            f"sends {good} good frames, but answers no GREET",
            "it may still be in an earlier recording: reset the board",
        )
    printable = sum(32 <= byte < 127 or byte in b"\r\n\t" for byte in heard) / len(heard)
    if printable > TEXT_SHARE and b"\n" in heard:
        return "prints lines of text", "record it with --text, or give it the firmware of docs/protocol.md"
    if _bit_turns(heard) < SLOW_TURNS:
        return (
            f"sends bytes that look like a lower baud rate than {baud}",
            "set --baud to the rate that the firmware uses",
        )
    if decoder.bad > 2 and max(map(len, heard.split(b"\0"))) <= 255:
        return (
            "sends pieces that end in zeros as frames do, none with our checksum: another protocol",
            "check the firmware against docs/protocol.md",
        )
    return (
        "sends noise",
        f"is its baud rate above {baud} (--baud), is this the rig's port, and do cable and ground make contact?",
    )
