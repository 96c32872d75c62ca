"""What the capture program recorded, checked against what it wrote down in capture.json."""

import hashlib
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pandas as pd

from .. import wire
from ..ground.command import command
from ..ground.errors import BadInput
from ..ground.files import sha256
from .folder import capture_info


def read_frames(path: Path) -> tuple[pd.DataFrame, dict[str, str]]:
    """Samples of the capture program's recording as the device named and scaled them, and each channel's unit.

    A few time stamps that cannot be are mended, which is said. Raises BadInput when the bytes are not those that were
    captured, no hello says what they mean, or the device's clock stands or runs backwards throughout.
    """
    content, info = path.read_bytes(), capture_info(path.parent)
    if hashlib.sha256(content).hexdigest() != info.get("sha256"):
        mend = "restore it from a copy; a recording is never edited"
        raise BadInput(path, "sha256", "its bytes are not those that capture.json was written for", mend)
    recorded = wire.read_recording(content)
    if recorded.hello is None:
        raise BadInput(path, "hello", "no frame says what the channels are", "record again; see docs/protocol.md")
    account = recorded.account
    if account.no_clock:
        bad, steps = account.backward_stamps + account.repeated_stamps, account.samples - 1
        problem = f"stands or runs backwards at {bad} of {steps} steps from sample to sample"
        raise BadInput(path, "t_us", problem, "correct the clock in the firmware and record again")
    if recorded.mended:
        rules = ", ".join(f"{times} {rule.replace('_', ' ')}" for rule, times in recorded.mended.items())
        print(f"{path}: mended {rules}", file=sys.stderr)
    names = {name: "device_time_s" if name == "time_s" else name for name in recorded.channels}  # t_us is the clock
    units = {names[channel.name]: channel.unit for channel in recorded.hello.channels}
    channels = {names[name]: values for name, values in recorded.channels.items()}
    return pd.DataFrame({"time_s": recorded.time_s, **channels}), units


def frame_pieces(path: Path) -> tuple[dict[str, str], Callable[[], Iterator[pd.DataFrame]]]:
    """Each channel's unit, and what `read_frames` gives in pieces; raises BadInput as it does."""
    table, units = read_frames(path)
    return units, lambda: iter([table])


def check_lines(path: Path) -> None:
    """Raise BadInput when a table that the capture program made of printed lines is not as it was made."""
    info = capture_info(path.parent)
    if (path.parent / "recording.lines").is_file() or "csv_sha256" in info:
        if sha256(path) == info.get("csv_sha256"):
            return
        again = f"run {command('capture')} --recover {path.parent}"
        problem = "its bytes are not those that capture.json was written for"
        raise BadInput(path, "csv_sha256", problem, f"{again}; recording.lines has what was printed")
