"""Faults of a rig that prints lines: what it says besides numbers, and numbers that are not what they seem."""

import hashlib
import re
import signal
import time

from bench import Bench, Host, Row
from scripted_device import Rig

HEADER = b"time_ms,motor_turns,displacement_mm\r\n"
BOOT = b"boot\r\nTSA rig v2 ready\r\nHello, string world\r\n"
COLUMNS = "time_ms,motor_turns,displacement_mm"


def lines(first: int, last: int, form: str = "{t},{turns:.2f},{mm:.1f}") -> bytes:
    """Printed samples from one number to another."""
    printed = [form.format(t=20 * n, turns=0.25 * n, mm=0.1 * n) for n in range(first, last)]
    return "".join(line + "\r\n" for line in printed).encode()


def _begin(bench: Bench, rig: Rig, beginning: bytes) -> Host:
    """Start a capture of what a rig prints, which is reset until it is heard."""
    host, path = bench.capture(rig.name, bench.run(), "--text"), bench.run() / "recording.lines"
    until_s = time.monotonic() + 60
    while not path.exists():
        assert host.process.poll() is None and time.monotonic() < until_s, host.said
        rig.say(beginning)
        time.sleep(0.5)
    return host


def _end(bench: Bench, host: Host, printed: bytes) -> int:
    """Ctrl-C when all is recorded that was said; the exit status."""
    path, until_s = bench.run() / "recording.lines", time.monotonic() + 60
    while not path.read_bytes().endswith(printed):
        assert host.process.poll() is None and time.monotonic() < until_s, host.said
        time.sleep(0.02)
    host.process.send_signal(signal.SIGINT)
    return host.wait()


def _row(bench: Bench, *hosts: Host, arrived: str, lost: str = "nothing") -> Row:
    reported = re.sub(r"\d+ lines of text", "the lines of text", bench.plain(*hosts))
    if (bench.run() / "capture.json").exists():
        csv = (bench.run() / "recording.csv").read_bytes()
        assert hashlib.sha256(csv).hexdigest() == bench.info()["csv_sha256"]
        assert csv.count(b"\n") == bench.info()["samples"]["received"] + 1
    return Row(arrived, reported, lost)


def greeting(bench: Bench) -> Row:
    """A greeting before the header, messages between the numbers and a farewell."""
    rig = bench.rig()
    host = _begin(bench, rig, BOOT + HEADER)
    printed = lines(1, 31) + b"stroke 1 is done\r\n" + lines(31, 61) + b"bye, bye\r\n"
    rig.say(printed)
    assert _end(bench, host, printed) == 0
    assert (bench.info()["samples"]["received"], bench.info()["lines"]["bad"]) == (60, 0)
    return _row(bench, host, arrived="60 lines of numbers, a greeting and messages")


def decimal_commas(bench: Bench) -> Row:
    """Numbers with decimal commas between semicolons."""
    rig = bench.rig()
    host = _begin(bench, rig, HEADER.replace(b",", b";"))
    printed = lines(1, 61, "{t};{turns:.2f};{mm:.1f}").replace(b".", b",")
    rig.say(printed)
    assert _end(bench, host, printed) == 0
    assert bench.info()["lines"]["decimal_commas"] == 60
    assert (bench.run() / "recording.csv").read_text().splitlines()[-1] == "1200,15.00,6.0"
    return _row(bench, host, arrived="60 lines of numbers")


def commas_everywhere(bench: Bench) -> Row:
    """Decimal commas between commas: nobody can tell which is which."""
    rig = bench.rig()
    host = _begin(bench, rig, HEADER)
    printed = b"20,0,25,0,1\r\n" * 60
    rig.say(printed)
    until_s = time.monotonic() + 60
    while "warning: no line is read yet" not in host.said:  # while it records
        assert time.monotonic() < until_s, host.said
        rig.say(b"20,0,25,0,1\r\n")
        time.sleep(0.1)
    assert _end(bench, host, b"20,0,25,0,1\r\n") == 2
    assert not (bench.run() / "capture.json").exists() and not (bench.run() / "recording.csv").exists()
    return _row(bench, host, arrived="60 lines of five numbers under three names", lost="nothing that was printed")


def swapped_columns(bench: Bench) -> Row:
    """After a reset another sketch names the columns in another order."""
    rig = bench.rig()
    host = _begin(bench, rig, HEADER)
    printed = lines(1, 31) + b"displacement_mm,motor_turns,time_ms\r\n" + lines(31, 61, "{mm:.1f},{turns:.2f},{t}")
    rig.say(printed)
    assert _end(bench, host, printed) == 0
    assert (bench.run() / "recording.csv").read_bytes() == (HEADER + lines(1, 61)).replace(b"\r", b"")
    return _row(bench, host, arrived="60 lines of numbers under two headers")


def guessed_wrongly(bench: Bench) -> Row:
    """A banner of as many words as there are columns is taken for their names; --recover --columns names them anew."""
    rig = bench.rig()
    host = _begin(bench, rig, b"Real time rig\r\n")
    printed = lines(1, 61, "{t} {turns:.2f} {mm:.1f}")
    rig.say(printed)
    assert _end(bench, host, printed) == 0 and bench.info()["columns"] == ["Real", "time", "rig"]
    recovery = bench.capture("--recover", bench.run(), "--columns", COLUMNS)
    assert recovery.wait() == 0 and bench.info()["exit_status"] == "ended"
    assert (bench.run() / "recording.csv").read_bytes() == (HEADER + lines(1, 61)).replace(b"\r", b"")
    return _row(bench, host, recovery, arrived="60 lines of numbers and a banner")


FAULTS = {
    "text: a greeting, messages, a farewell": greeting,
    "text: decimal commas between semicolons": decimal_commas,
    "text: decimal commas between commas": commas_everywhere,
    "text: a second header with the columns swapped": swapped_columns,
    "text: a banner taken for the columns' names": guessed_wrongly,
}
