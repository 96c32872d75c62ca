"""The words for the person when a recording of printed lines is committed."""

from pathlib import Path

from ...ground.command import recover_command
from ...ground.words.counts import counted
from ...run.capture_json import CaptureJson, Lost
from .fields import TIME, is_known
from .naming import Naming, naming_in

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
        words = f"{often}about {counted(size, 'sample')} missing"
        parts.append(f"{words}, {first}after the device's time {times[0]:g}")
    if smaller:
        parts.append(f"and {counted(sum(len(sizes[size]) for size in smaller), 'smaller hole')}, see capture.json")
    return "; ".join(parts)


def clock_of(info: CaptureJson) -> str:
    """Name of the column that is read as the device's time, from the content of capture.json."""
    return next((name for name in info["columns"] if TIME.fullmatch(name)), "time")


def _names(info: CaptureJson, naming: Naming) -> str:
    """The option that names the columns: with their present names, or, if these are no names, with suggested ones."""
    columns = tuple(info["columns"])
    all_known = all(is_known((name,)) for name in columns)
    return f"--columns {','.join(columns)}" if all_known else naming.option(len(columns))


def tell_lines(info: CaptureJson, folder: Path, usable: bool = True) -> None:
    """Say what was recorded, which lines were no numbers, and where samples seem to be missing.

    Where the columns are not `usable` as they are called, no command calls them so: the one that mends it follows.
    """
    lines = info["lines"]
    text = f", {counted(lines['text'], 'line')} of text passed over" if lines["text"] else ""
    samples, bad = counted(info["samples"]["received"], "sample"), counted(lines["bad"], "bad line")
    print(f"{folder}: {info['exit_status']}, {samples}, {bad}{text}")
    if lines["unnamed"]:
        again = f"{recover_command(folder)} --columns {','.join(info['columns'])} reads them too"
        came = f"{counted(lines['unnamed'], 'line')} of numbers came before anything named their columns"
        print(f"{folder}: {came}; {again if usable else 'the command below reads them too'}")
    again = f"{recover_command(folder)} {_names(info, naming_in(folder))}"
    rename = f"if not, put their names in the order in which they are printed: {again}"
    print(f"{folder}: the columns are {', '.join(info['columns'])}{f'; {rename}' if usable else ''}")
    if lines["swapped_headers"]:
        again = f"named the columns in another order {counted(lines['swapped_headers'], 'time')}"
        print(f"{folder}: the rig {again}; the fields are put back into the first one's")
    if lines["other_headers"]:
        others = f"named other columns {counted(lines['other_headers'], 'time')}"
        print(f"{folder}: the rig {others}; lines after that are bad ones")
    if not lines["device_time"]:
        print(f"{folder}: the rig prints no time, so lost lines cannot be seen; print millis() first in every line")
    if info["holes"]:
        print(f"{folder}: {missing(info['holes'])}")


def clock_question(info: CaptureJson) -> str:
    """The question about a time that stands or falls back in a run that cannot be used."""
    often = counted(info["lines"]["time_backward"], "time")
    column = f"is the time another column than {clock_of(info)}"
    return f"the device's time stands or falls back {often}: was it reset, or {column}?"
