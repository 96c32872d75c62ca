"""What the person reads when a recording of printed lines is committed."""

from pathlib import Path

from ..run.capture_json import CaptureJson, Lost
from .commit import recover_command
from .fields import TIME

SIZES_TOLD = 5  # of holes


def missing(holes: list[Lost]) -> str:
    """Where samples seem to be missing: holes of the same size are told together, by the first of them."""
    sizes: dict[int, list[float]] = {}
    for hole in holes:
        sizes.setdefault(hole["samples_about"], []).append(hole["after_time"])
    parts, smaller = [], sorted(sizes, reverse=True)[SIZES_TOLD:]
    for size in sorted(sizes, reverse=True)[:SIZES_TOLD]:
        times = sizes[size]
        often, first = (f"{len(times)} times ", "first ") if len(times) > 1 else ("", "")
        words = f"{often}about {size} sample{'s' * (size != 1)} missing"
        parts.append(f"{words}, {first}after the device's time {times[0]:g}")
    if smaller:
        parts.append(f"and {sum(len(sizes[size]) for size in smaller)} smaller holes, see capture.json")
    return "; ".join(parts)


def clock_of(info: CaptureJson) -> str:
    """Name of the column that is read as the device's time, of what capture.json says."""
    return next((name for name in info["columns"] if TIME.fullmatch(name)), "time")


def tell_lines(info: CaptureJson, folder: Path) -> None:
    """Say what was recorded, what was no line of numbers and where samples seem to be missing."""
    lines = info["lines"]
    text = f", {lines['text']} lines of text passed over" if lines["text"] else ""
    print(f"{folder}: {info['exit_status']}, {info['samples']['received']} samples, {lines['bad']} bad lines{text}")
    if lines["unnamed"]:
        again = f"{recover_command(folder)} --columns {','.join(info['columns'])} reads them too"
        print(f"{folder}: {lines['unnamed']} lines of numbers came before anything named their columns; {again}")
    print(f"{folder}: the columns are {', '.join(info['columns'])}; if not, --recover {folder} --columns names them")
    if lines["swapped_headers"]:
        again = f"named the columns in another order {lines['swapped_headers']} times"
        print(f"{folder}: the rig {again}; the fields are put back into the first one's")
    if lines["other_headers"]:
        print(f"{folder}: the rig named other columns {lines['other_headers']} times; lines after that are bad ones")
    if not lines["device_time"]:
        print(f"{folder}: the rig prints no time, so lost lines cannot be seen; print millis() first in every line")
    if info["holes"]:
        print(f"{folder}: {missing(info['holes'])}")
    if lines["time_backward"]:
        sentence = f"the device's time stands or falls back {lines['time_backward']} times"
        print(f"{folder}: {sentence}: was it reset, or is the time another column than {clock_of(info)}?")
