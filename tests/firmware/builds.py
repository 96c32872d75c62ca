"""The firmware compiled for the Arduino and for this computer, and run behind a pseudo-terminal."""

import os
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FIRMWARE = ROOT / "firmware"
BENCH = Path(__file__).parent
STRICT = ("-std=gnu11", "-Wall", "-Wextra", "-Werror")
AVR = ("avr-gcc", *STRICT, "-Os", "-mmcu=atmega328p", "-DF_CPU=16000000UL", "-ffunction-sections", "-Wl,--gc-sections")
SMALL = ("-DSTROKES=2", "-DTOP_TURNS=5L", "-DSTEPS_PER_S=6400L", "-DREST_MS=400L", "-DHOLD_MS=400L")


def need(*programs: str) -> None:
    """Skip the test where a program is not installed."""
    for program in programs:
        if shutil.which(program) is None:
            pytest.skip(f"{program} is not installed")


def compiled(*command: object) -> None:
    """Run a compiler; it has nothing to say of good code."""
    done = subprocess.run([*map(str, command)], capture_output=True, text=True)
    assert done.returncode == 0 and not done.stderr, done.stderr


def for_the_uno(out: Path, *options: str) -> Path:
    """The firmware as an ELF file for the ATmega328P."""
    need("avr-gcc", "avr-size")
    compiled(*AVR, *options, *sorted(FIRMWARE.glob("*.c")), "-o", out)
    return out


def for_this_computer(out: Path) -> Path:
    """The firmware's protocol and motion, on a board of this computer's own."""
    need("gcc")
    ours = [path for path in sorted(FIRMWARE.glob("*.c")) if not path.name.startswith("board_")]
    sources = [*ours, BENCH / "board_pc.c"]
    compiled("gcc", *STRICT, "-O1", *SMALL, "-I", FIRMWARE, *sources, "-lutil", "-lm", "-o", out)
    return out


def simulator(out: Path) -> Path:
    """An Arduino Uno in simavr."""
    need("gcc")
    looked = subprocess.run(["gcc", "-E", "-include", "simavr/sim_avr.h", "-xc", "/dev/null"], capture_output=True)
    if looked.returncode != 0:
        pytest.skip("simavr's headers (libsimavr-dev) are not installed")
    compiled("gcc", *STRICT, "-O2", *SMALL, "-I", FIRMWARE, BENCH / "uno.c", "-lsimavr", "-lutil", "-lm", "-o", out)
    return out


@contextmanager
def running(*command: Path, **settings: object) -> Iterator[str]:
    """The port behind which a board runs; `settings` are environment variables of the bench."""
    environment = {**os.environ, **{name: str(value) for name, value in settings.items()}}
    with subprocess.Popen([*map(str, command)], stdout=subprocess.PIPE, text=True, env=environment) as process:
        try:
            assert process.stdout is not None
            yield next(line.strip() for line in process.stdout if line.startswith("/dev/"))
        finally:
            process.kill()
