"""The capture program's recordings, checked against its account in capture.json."""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pandas as pd

from ... import wire
from ...ground.command import recover_command
from ...ground.errors import BadInput
from ...ground.stored.files import sha256
from ..folder import capture_info


def frame_pieces(path: Path) -> tuple[dict[str, str], Callable[[], Iterator[pd.DataFrame]]]:
    """Each channel's unit, and samples of the capture program's recording in pieces, as the device scaled them.

    A few time stamps that cannot be are mended, which is said. Raises BadInput when the bytes are not those that were
    captured, no hello says what they mean, or the device's clock stands or runs backwards throughout.
    """
    if sha256(path) != capture_info(path.parent).get("sha256"):
        mend = "restore it from a copy; a recording is never edited"
        raise BadInput(path, "sha256", "its bytes are not those that capture.json was written for", mend)
    recorded = wire.read_pieces(lambda: _chunks(path))
    if recorded.hello is None:
        raise BadInput(path, "hello", "no frame says what the channels are", "record again; see docs/protocol.md")
    account = recorded.account
    if account.no_clock:
        bad, steps = account.backward_stamps + account.repeated_stamps, account.samples - 1
        problem = f"stands or runs backwards at {bad} of {steps} steps from sample to sample"
        raise BadInput(path, "t_us", problem, "correct the clock in the firmware and record again")
    say_mended(path, recorded.mended)
    names = {channel.name: channel.name for channel in recorded.hello.channels}
    if "time_s" in names:
        names["time_s"] = "device_time_s"  # t_us is the clock
    units = {names[channel.name]: channel.unit for channel in recorded.hello.channels}

    def pieces() -> Iterator[pd.DataFrame]:
        for time_s, channels, _ in recorded.samples():
            yield pd.DataFrame({"time_s": time_s, **{names[name]: values for name, values in channels.items()}})

    return units, pieces


def say_mended(path: Path, mended: dict[str, int]) -> None:
    """Say on standard error how often each rule that mends time stamps was needed, if any was."""
    if mended:
        rules = ", ".join(f"{times} {rule.replace('_', ' ')}" for rule, times in mended.items())
        print(f"{path}: mended {rules}", file=sys.stderr)


def _chunks(path: Path) -> Iterator[bytes]:
    """Bytes of a recording, piece by piece."""
    with open(path, "rb") as file:
        while piece := file.read(wire.PIECE):
            yield piece


def read_frames(path: Path) -> tuple[pd.DataFrame, dict[str, str]]:
    """Samples of the capture program's recording, and each channel's unit, as `frame_pieces` has them."""
    units, pieces = frame_pieces(path)
    return pd.concat(pieces(), ignore_index=True), units


def check_lines(path: Path) -> bool:
    """Whether the capture program made a table, from printed lines; raises BadInput if it was changed since."""
    info = capture_info(path.parent)
    if (path.parent / "recording.lines").is_file() or "csv_sha256" in info:
        if sha256(path) == info.get("csv_sha256"):
            return True
        again = f"run {recover_command(path.parent)}"
        problem = "its bytes are not those that capture.json was written for"
        raise BadInput(path, "csv_sha256", problem, f"{again}; recording.lines has what was printed")
    return False
