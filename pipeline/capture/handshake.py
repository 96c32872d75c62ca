"""The beginning of a recording: ask the device for its HELLO, check it, and tell the device to start."""

import time

from ..ground.errors import BadInput
from ..wire import Decoder, Frame, Hello, Kind, encode
from ..wire.check import VERSIONS
from .guess import guess
from .port import Port, Unplugged

SILENCE_S = 3.0
GREET_AGAIN_S = 1.0
LATE_HELLO_S = 0.5
KEPT = 1 << 14  # bytes of what is no HELLO, to guess from


def greet(port: Port, name: str, baud: int) -> tuple[Hello, bytes]:
    """The device's HELLO, and the bytes with which the recording begins; asked in every version of the protocol.

    Whatever came before the HELLO, and answers to a second GREET, are no part of the recording: no device sends
    samples before START. Raises BadInput for a port without a device that speaks this protocol.
    """
    decoder = Decoder()
    heard_bytes = greeted = 0
    sample = b""
    next_s = began_s = time.monotonic()
    try:
        while (now_s := time.monotonic()) - began_s < SILENCE_S:
            if now_s >= next_s:
                port.write(b"".join(encode(Kind.GREET, greeted, protocol=version) for version in VERSIONS))
                greeted, next_s = greeted + 1, now_s + GREET_AGAIN_S
            chunk = port.read()
            heard_bytes += len(chunk)
            sample += chunk[: KEPT - len(sample)]
            for heard in decoder.feed(chunk):
                if heard.frame.kind == Kind.HELLO:
                    hello = _checked(heard.frame, name)
                    return hello, heard.raw + _late(port, decoder, greeted - 1)
    except Unplugged as error:
        raise BadInput(name, "port", f"went away ({error})", "plug the rig in again") from None
    if heard_bytes:
        what, mend = guess(sample, baud)
        raise BadInput(name, "device", f"{what} ({heard_bytes} bytes and no HELLO in {SILENCE_S:g} s)", mend)
    mend = "check the cable, the power and that this is the rig's port"
    raise BadInput(name, "device", f"said nothing for {SILENCE_S:g} s", mend)


def _late(port: Port, decoder: Decoder, answers: int) -> bytes:
    """Wait for late answers to earlier GREETs; returns the beginning of a frame that follows them."""
    until_s = time.monotonic() + (LATE_HELLO_S if answers else 0.0)
    while answers > 0 and time.monotonic() < until_s:
        answers -= sum(heard.frame.kind == Kind.HELLO for heard in decoder.feed(port.read()))
    return decoder.rest


def _checked(frame: Frame, name: str) -> Hello:
    try:
        hello = Hello.unpack(frame.payload)
        if hello.protocol != frame.protocol:
            raise ValueError(f"protocol: is version {hello.protocol}, under the check of version {frame.protocol}")
        return hello
    except ValueError as error:
        field, colon, problem = str(error).rpartition(": ")
        field = f"HELLO.{field}" if colon else "HELLO"
        mend = "bring the firmware, or this program, up to date (docs/protocol.md)"
        raise BadInput(name, field, problem, mend) from None


def check_rate(hello: Hello, baud: int, name: str) -> None:
    """Raise BadInput when the line cannot carry the samples that the device is to send."""
    payload = bytes(4 + sum(int(c.type[1:]) // 8 for c in hello.channels))
    sample = encode(Kind.SAMPLE, 0, payload, hello.protocol)
    needed = len(sample) * 10 * hello.rate_hz
    if needed > baud:
        problem = f"{hello.rate_hz:g} Hz need {needed:.0f} Bd, more than {baud}"
        raise BadInput(name, "--baud", problem, "raise the baud rate on both sides or lower the sample rate")
