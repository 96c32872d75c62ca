"""The content of `capture.json`: the account of a recording that the capture program made."""

from collections.abc import Sequence
from typing import TypedDict

from ..wire.hello import HelloJson


class Lost(TypedDict, total=False):
    """A loss in one place: `frames` of a rig that speaks the protocol, or about that many printed samples.

    `after_samples` of the recording come before it, the last at `after_s` (None: it lies before the first sample), or
    at `after_time`, the device's own. `strokes` are those that it may touch.
    """

    after_samples: int
    frames: int
    after_s: float | None
    strokes: Sequence[int]
    samples_about: int
    after_time: float


class Samples(TypedDict, total=False):
    """The number of samples sent (None: the rig does not say) and received, and the faults of their time stamps."""

    sent: int | None
    received: int
    out_of_order: int
    backward_time_stamps: int
    repeated_time_stamps: int


class Lines(TypedDict):
    """The kinds of printed lines: counts, the numbers of the first bad lines, and the first lines of text."""

    bad: int
    bad_at: list[int]
    unnamed: int  # lines of numbers before anything named their columns
    text: int
    text_first: list[str]
    tail_bytes: int
    device_time: bool  # whether the rig prints a time
    time_backward: int
    holes: int
    decimal_commas: int
    swapped_headers: int
    other_headers: int


class CaptureJson(TypedDict, total=False):
    """All of it; nothing where the capture program did not record.

    Any recording: `schema`; `exit_status` (complete, aborted, ended, fault or recovered), `fault` and `ended_by` in
    words; times in UTC by ISO 8601; which bytes it is; `samples`. Frames: their counts, sent = received + lost; `gaps`;
    the device's HELLO. Printed lines: the rest.
    """

    schema: int
    exit_status: str
    fault: str | None
    ended_by: str | None
    started_utc: str
    ended_utc: str
    bytes: int
    sha256: str
    recovered: bool
    samples: Samples
    frames: dict[str, int]
    gaps: list[Lost]
    hello: HelloJson | None
    csv_sha256: str
    columns: list[str]
    columns_given: bool
    lines: Lines
    holes: list[Lost]
