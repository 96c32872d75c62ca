"""A program of motion for a rig: read from a file, checked against the rig's limits, and taken as a whole."""

import json
import time
from collections.abc import Sequence
from pathlib import Path
from typing import NotRequired, TypedDict

from ..ground.errors import BadInput
from ..ground.stored.regular_file import read_regular
from ..wire import Decoder, Hello, Kind, encode
from ..wire.motion import PROGRAM, TAKEN, Answer, Leg, packed, refusal
from .port import Port, Unplugged

ANSWER_S, TRIES = 1.0, 3
LARGEST_PROGRAM = 100_000_000  # bytes: a diagnosis.json may be given
PAUSE_S = 0.002  # after each frame: a small board has room for two of them
ALIKE = 0.02  # of a load: two medians of one load cell differ by less
SAYS = {
    Answer.BROKEN: "it did not get it whole",
    Answer.BUSY: "it is recording",
    Answer.LEGS: "it has more legs than it can keep",
    Answer.TURNS: "it goes beyond its turns",
    Answer.SPEED: "it is too fast",
    Answer.ACCELERATION: "it starts or stops too quickly",
    Answer.LOAD: "it does not have that load",
    Answer.SECONDS: "it takes too long",
}


class LegJson(TypedDict):
    """One leg as JSON has it: how long in s, the motor's turns at its end, and the load in N that hangs in it."""

    seconds: float
    motor_turns: float
    load_n: NotRequired[float | None]


def as_legs(entries: Sequence[LegJson], hanging_n: float | None = None) -> list[Leg]:
    """Legs in the form of `next_run` in a diagnosis.json; a load that hangs already, all the time, is left out.

    Raises ValueError for what are none.
    """
    try:
        legs = [
            Leg(float(entry["seconds"]), float(entry["motor_turns"]), None if load_n is None else float(load_n))
            for entry in entries
            for load_n in [entry.get("load_n")]
        ]
    except (TypeError, KeyError, AttributeError):
        raise ValueError("each leg needs seconds and motor_turns, and may have load_n, all of them numbers") from None
    packed(legs)  # raises for numbers that the protocol cannot write
    same_n = ALIKE * abs(hanging_n or 0.0)
    if hanging_n is not None and all(leg.load_n is None or abs(leg.load_n - hanging_n) <= same_n for leg in legs):
        legs = [Leg(leg.seconds, leg.turns) for leg in legs]
    return legs


def read_legs(path: Path) -> list[Leg]:
    """The legs of a file: a list of them, or a diagnosis.json with a `next_run`; raises BadInput."""
    mend = "give a diagnosis.json with a next_run, or a list of legs as it has them"
    try:
        content = json.loads(read_regular(path, LARGEST_PROGRAM, "--program"))
        run = (content.get("next_run") or {}) if isinstance(content, dict) else {"legs": content}
        legs = as_legs(run.get("legs") or [], run.get("load"))
    except (ValueError, AttributeError, RecursionError) as error:
        raise BadInput(path, "--program", f"holds no program ({error})", mend) from None
    if not legs:
        raise BadInput(path, "--program", "proposes no run", mend)
    return legs


def check(hello: Hello, legs: Sequence[Leg], name: str) -> None:
    """Raise BadInput for a rig that takes no program, or not this one."""
    if hello.program is None:
        problem = "takes no program: its HELLO declares no limits of one"
        raise BadInput(name, "HELLO.program", problem, "move the motor by hand, or bring its firmware up to date")
    reason = refusal(legs, hello.program)
    if reason is not None:
        _, number, sentence = reason
        field = f"program, leg {number}" if number else "program"
        raise BadInput(name, field, sentence, "choose another run, or widen the limits in the firmware if that is safe")


def strokes_of(legs: Sequence[Leg], at_turns: float) -> int:
    """How many strokes a program has that starts at `at_turns`: as often as it begins to wind."""
    count, winding = 0, False
    for leg in legs:
        if leg.turns != at_turns:
            count += leg.turns > at_turns and not winding
            winding = leg.turns > at_turns
        at_turns = leg.turns
    return count


def load(port: Port, hello: Hello, legs: Sequence[Leg], name: str) -> None:
    """Hand a program over, until the device says that it has the whole of it; nothing moves yet. Raises BadInput."""
    check(hello, legs, name)
    payloads, crc = packed(legs)
    frames = [encode(Kind.LEG, number, payload, hello.protocol) for number, payload in enumerate(payloads)]
    frames.append(encode(Kind.PROGRAM, len(payloads), PROGRAM.pack(len(payloads), crc), hello.protocol))
    decoder, answer, leg = Decoder(hello.protocol), None, 0
    try:
        for _ in range(TRIES):
            for frame in frames:
                port.write(frame)
                time.sleep(PAUSE_S)
            answer, leg = _answer(port, decoder, len(payloads), crc)
            if answer == Answer.TAKEN:
                return
            if answer not in (None, Answer.BROKEN):
                break
    except Unplugged as error:
        raise BadInput(name, "port", f"went away ({error})", "plug the rig in again") from None
    if answer is None:
        raise BadInput(name, "program", "the device did not answer it; nothing was moved", "check cable and firmware")
    why = SAYS[Answer(answer)] if answer in SAYS else f"its reason is {answer}"
    field = f"program, leg {leg}" if leg else "program"
    raise BadInput(name, field, f"the device refused it: {why}", "choose another run; nothing was moved")


def _answer(port: Port, decoder: Decoder, count: int, crc: int) -> tuple[int | None, int]:
    """The device's answer on exactly this program, and its leg; None if no answer comes in time."""
    until_s = time.monotonic() + ANSWER_S
    while time.monotonic() < until_s:
        for heard in decoder.feed(port.read()):
            if heard.frame.kind == Kind.TAKEN and len(heard.frame.payload) == TAKEN.size:
                legs, theirs, answer, leg = TAKEN.unpack(heard.frame.payload)
                if answer != Answer.TAKEN or (legs, theirs) == (count, crc):
                    return answer, leg
    return None, 0
