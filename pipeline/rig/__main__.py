"""Be a synthetic rig behind a pseudo-terminal: one recording after another, at a pace that a person can watch."""

import math
import os
import signal
import sys
from pathlib import Path
from types import FrameType

from ..ground import command as called
from ..ground.errors import program
from ..ground.input.parser import Parser
from .commanded import Commanded
from .device import Device
from .kept_string import Standing
from .options import (
    again,
    base_of,
    command,
    free_name,
    material_of,
    number_of,
    record_into,
    seed_of,
    string_of,
    waiting,
)
from .recorded_at_once import simulate
from .serial_line import line, serve
from .setup import names, read_setup

MOST_STROKES = 1000
FORECAST = 12  # strokes that a forecast of the life needs at least; a test holds it to that program's own number
RAW = Path("raw")  # of the folder in which the rig is started: where pipeline.new_run makes a run's folder
ANEW = "rig: every recording is of a new string: give each a run and a --string-id of its own"
STAYS = "rig: every recording is of the same string: give each a run of its own and the same --string-id"
KEPT = "rig: its displacement sensor keeps its zero from recording to recording, so no run needs --tare run"
ZEROED = "rig: its displacement sensor is set to zero at each start, so every run after the first has --tare run"
PACE = 5.0  # the paper's nine strokes in a minute


def _end(number: int, frame: FrameType | None) -> None:
    """End in good order, with the status of a program that the signal ended."""
    sys.exit(128 + number)


def paced(pace: float, rate_hz: float) -> str:
    """The speed of the rig, and how many samples a second the host therefore gets."""
    if math.isinf(pace):
        return "without any waiting"
    faster = "" if pace == 1.0 else f", so its {rate_hz:g} samples a second come as {pace * rate_hz:g}"
    return f"at {pace:g} times real time{faster}"


def strokes_of(count: int) -> str:
    """How many strokes a recording has, and how to change that."""
    sentence = f"every recording has {count} stroke{'s' if count != 1 else ''}; --strokes N is for another number"
    return (
        f"{sentence} ({called.program_name('lifespan')} needs {FORECAST} to foretell)" if count < FORECAST else sentence
    )


def others(seed: int) -> str:
    """How to get other strings than those of the default seed."""
    return f"; seed {seed}: another --seed gives other strings"


@program
def main() -> int:
    """Make the link, then serve until Ctrl-C, or so many recordings; exit 1 when nobody acknowledges the last one."""
    parser = Parser(prog=called.command("rig"), description=__doc__)
    parser.add_argument("setup", metavar="SETUP", help=f"a YAML file, or one of {', '.join(names())}")
    parser.add_argument("--link", type=Path, required=True, help="name of the serial port that is made")
    parser.add_argument("--seed", type=int, help="what is drawn: the same one gives the same strings again")
    parser.add_argument("--pace", type=float, default=PACE, help=f"times real time, inf for no waiting ({PACE:g})")
    parser.add_argument("--recordings", type=int, default=0, help="so many, then end (default: until Ctrl-C)")
    strokes = f"strokes of each recording, 1 to {MOST_STROKES:,}; default: as the set-up says (paper: 9)"
    parser.add_argument("--strokes", type=int, metavar="N", help=strokes)
    parser.add_argument("--standing", action="store_true", help="one string for all recordings; it takes programs")
    anew = "with --standing: the displacement sensor is set to zero at each start, not at the first alone"
    parser.add_argument("--zeroed", action="store_true", help=anew)
    parser.add_argument("--fixed-load", action="store_true", help="with --standing: no program can change the load")
    parser.add_argument(
        "--stalls-at", type=float, metavar="TURNS", help="with --standing: a twist that programs stall at"
    )
    arguments = parser.parse_args()
    if arguments.strokes is not None and not 1 <= arguments.strokes <= MOST_STROKES:
        parser.error(f"--strokes must be 1 to {MOST_STROKES}")
    if (arguments.seed or 0) < 0 or not arguments.pace > 0 or arguments.recordings < 0:
        parser.error("--seed and --recordings must be 0 or more, --pace above 0")
    setup = read_setup(arguments.setup)
    if arguments.strokes is not None:
        setup = setup.model_copy(update={"motion": setup.motion.of_strokes(arguments.strokes)})
    if arguments.zeroed and not arguments.standing:
        parser.error("--zeroed is for --standing: without it every recording is of another string")
    seed = seed_of(arguments.link) if arguments.seed is None else arguments.seed
    load, zeroed = not arguments.fixed_load, arguments.zeroed and setup.sensors["displacement_mm"].zeroed
    standing = Standing(setup, seed, load, zeroed) if arguments.standing else None

    def device_of(number: int) -> Device:
        if standing is not None:
            return Commanded(standing, arguments.stalls_at)
        return Device(simulate(setup, seed + number - 1))

    device, number = device_of(1), 1
    for asks_to_end in (signal.SIGINT, signal.SIGTERM):  # to the first of them a shell's background job is deaf
        signal.signal(asks_to_end, _end)  # the link goes with it
    with line(arguments.link) as end:
        pace = paced(arguments.pace, setup.rate_hz)
        ends = f"Ctrl-C ends it, in the background kill {os.getpid()}"
        print(f"rig: {arguments.setup} is at {arguments.link}, {pace}; {ends}")
        base = base_of(arguments.link)
        material = material_of(arguments.setup)
        waits = waiting(RAW, base, 1, material)
        first = name = waits or free_name(RAW, base)
        describe = f"rig: before recording 1 describe its string by: {command(setup, first, arguments.setup)}"
        print(f"rig: recording 1 {record_into(RAW, first, arguments.link)}" if waits else describe)
        print((STAYS if standing else ANEW) + others(seed) * (arguments.seed is None))
        if standing:
            print(ZEROED if zeroed else KEPT)
        print(f"rig: {strokes_of(len(setup.motion.each()))}", flush=True)
        while True:
            served = serve(end, device, arguments.pace)
            ending = "is recorded" if served else "ended, and the host did not acknowledge it"
            print(f"rig: recording {number} {ending}", flush=True)
            if number == arguments.recordings:
                return 0 if served else 1
            number += 1
            string_id = string_of(RAW, first) if standing else ""
            if waits := waiting(RAW, base, number_of(name) + 1, material, string_id):
                name = waits
                print(f"rig: recording {number} {record_into(RAW, name, arguments.link)}", flush=True)
            elif standing is None:
                name = free_name(RAW, base, number_of(name) + 1)
                described = command(setup, name, arguments.setup)
                print(f"rig: before recording {number} describe its string, another one, by: {described}", flush=True)
            else:
                print(f"rig: before recording {number} describe it by: {again(RAW, first, zeroed)}", flush=True)
            device = device_of(number)


if __name__ == "__main__":
    main()
