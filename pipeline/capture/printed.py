"""A rig that prints lines of numbers: PORT → recording.lines as it came, then recording.csv and capture.json."""

import hashlib
import time
from collections.abc import Callable
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from pipeline.capture.commit import opening, seal
from pipeline.capture.lines import LISTED, MAX_LINE, names, read_lines
from pipeline.capture.log import LINES, Log, in_use
from pipeline.capture.port import Port, Unplugged
from pipeline.capture.stream import Outcome
from pipeline.errors import BadInput

HEADER_S = 5.0  # a board that was reset by opening its port needs some of them
SILENCE_S = 3.0


def await_header(port: Port, name: str, columns: tuple[str, ...]) -> bytes:
    """First bytes of the recording: with `columns` none, else up to the rig's header; raises BadInput without one."""
    heard, until_s = b"", time.monotonic() + HEADER_S
    while not columns and time.monotonic() < until_s:
        try:
            heard += port.read()
        except Unplugged as error:
            raise BadInput(name, "port", f"went away ({error})", "plug the rig in again") from None
        if any(names(line) for line in heard.split(b"\n")[:-1]):
            return heard
        if len(heard) > 64 * MAX_LINE:
            break
    if columns:
        return b""
    if not heard:
        mend = "check the cable, the power and that this is the rig's port"
        raise BadInput(name, "device", f"said nothing for {HEADER_S:g} s", mend)
    problem = f"sent {len(heard)} bytes and no line that names the columns"
    raise BadInput(name, "device", problem, "name them: --columns time_ms,motor_turns,displacement_mm; check --baud")


def follow(port: Port, log: Log, stops: Callable[[], int]) -> Outcome:
    """Record until the person ends it or nothing more comes; what came is on the disk afterwards."""
    heard_s = shown_s = time.monotonic()
    lines = 0
    outcome: Outcome | None = None
    while outcome is None:
        try:
            chunk = port.read()
        except Unplugged as error:
            outcome = Outcome("fault", f"the port went away ({error})")
            break
        log.append(chunk)
        lines += chunk.count(b"\n")
        now_s = time.monotonic()
        heard_s = now_s if chunk else heard_s
        if now_s - shown_s >= 1.0:
            shown_s = now_s
            with suppress(OSError):
                print(f"{lines} lines recorded", flush=True)
        if stops():
            outcome = Outcome("ended")
        elif now_s - heard_s > SILENCE_S:
            outcome = Outcome(
                "ended", f"the rig said nothing for {SILENCE_S:g} s; whether it was done, text cannot say"
            )
    log.sync()
    return outcome


def commit_lines(
    folder: Path, columns: tuple[str, ...], began: datetime, ended: datetime, outcome: Outcome
) -> dict[str, Any]:
    """Account for `recording.lines`, write the good ones as recording.csv, and commit; returns capture.json's content.

    Raises BadInput when no line names the columns, or the files cannot be written.
    """
    data = (folder / LINES).read_bytes()
    table = read_lines(data, columns)
    if not table.columns:
        mend = "name them: --columns time_ms,motor_turns,displacement_mm"
        raise BadInput(folder / LINES, "header", "no line names the columns", mend)
    csv, holes = table.csv, table.holes()
    info = {
        **opening(len(data), hashlib.sha256(data).hexdigest(), began, ended, outcome),
        "csv_sha256": hashlib.sha256(csv.encode()).hexdigest(),
        "columns": list(table.columns),
        "samples": {"sent": None, "received": len(table.rows)},
        "lines": {
            "bad": table.bad,
            "bad_at": table.bad_lines,
            "tail_bytes": table.tail_bytes,
            "device_time": bool(table.time_s),
            "time_backward": table.backward,
            "holes": len(holes),
        },
        "holes": holes[:LISTED],
    }
    return seal(folder, LINES, info, csv)


def recover_lines(folder: Path, columns: tuple[str, ...]) -> dict[str, Any]:
    """Commit a text recording whose capture program was killed, as `recovered`; raises BadInput.

    Nothing tells when it began: its end, the file's last change, stands for that too.
    """
    path = folder / LINES
    if (folder / "capture.json").exists():
        raise BadInput(folder, "capture.json", "is there, so the run is finished", "there is nothing to recover")
    if in_use(path):
        raise BadInput(path, LINES, "is still being captured", "wait for that program, or end it")
    ended = datetime.fromtimestamp(path.stat().st_mtime, UTC)
    return commit_lines(folder, columns, ended, ended, Outcome("recovered"))


def tell_lines(info: dict[str, Any], folder: Path) -> None:
    """Say what was recorded, what was no line of numbers and where samples seem to be missing."""
    lines = info["lines"]
    print(f"{folder}: {info['exit_status']}, {info['samples']['received']} samples, {lines['bad']} bad lines")
    if not lines["device_time"]:
        print(f"{folder}: the rig prints no time, so lost lines cannot be seen; print millis() first in every line")
    for hole in info["holes"][:5]:
        missing, after = hole["samples_about"], hole["after_time"]
        print(f"{folder}: about {missing} samples missing after the device's time {after:g}")
    if lines["time_backward"]:
        print(f"{folder}: the device's time stands or falls back {lines['time_backward']} times: was it reset?")
