"""The words for the person when a recording of printed lines is committed."""

from pathlib import Path

from ...ground.command import recover_command
from ...ground.units import unit_of
from ...ground.words.counts import counted
from ...run.capture_json import CaptureJson, Lost
from ...run.table.named_units import time_unit
from .clock_words import clock_in
from .fields import clock_at, is_known
from .naming import Naming, naming_in
from .read_channels import ReadChannels

SIZES_TOLD = 5  # of holes


def missing(holes: list[Lost], unit: str) -> str:
    """Where samples seem to be missing, in a time of `unit`: holes of one size together, by their first."""
    sizes: dict[int, list[float]] = {}
    for hole in holes:
        sizes.setdefault(hole["samples_about"], []).append(hole["after_time"])
    parts, smaller = [], sorted(sizes, reverse=True)[SIZES_TOLD:]
    for size in sorted(sizes, reverse=True)[:SIZES_TOLD]:
        times = sizes[size]
        often, first = (f"{len(times)} times ", "first ") if len(times) > 1 else ("", "")
        words = f"{often}about {counted(size, 'sample')} missing"
        parts.append(f"{words}, {first}after the device's time {f'{times[0]:g} {unit}'.rstrip()}")
    if smaller:
        parts.append(f"and {counted(sum(len(sizes[size]) for size in smaller), 'smaller hole')}, see capture.json")
    return "; ".join(parts)


def clock_of(info: CaptureJson, folder: Path) -> str:
    """Name of the column that is read as the device's time, of what capture.json and run.yaml say."""
    at = clock_at(info["columns"], clock_in(folder))
    return info["columns"][at] if at >= 0 else "time"


def _unit_of_clock(info: CaptureJson, folder: Path) -> str:
    """The unit of that column, by run.yaml, else by its name; empty where neither says it."""
    column = clock_of(info, folder)
    place = ReadChannels(folder, info["columns"]).places.get(column)
    by_name = time_unit(column) or ("s" if unit_of(column) == "s" else "")
    return place.unit if place and place.channel == "time_s" else by_name


def _names(info: CaptureJson, naming: Naming) -> str:
    """The option that names the columns: with their present names, or, if these are no names, with suggested ones."""
    columns = tuple(info["columns"])
    all_known = all(is_known((name,)) for name in columns)
    return f"--columns {','.join(columns)}" if all_known else naming.option(len(columns))


def tell_lines(info: CaptureJson, folder: Path, usable: bool = True, all_named: bool = False) -> None:
    """Say what was recorded, which lines were no numbers, and where samples seem to be missing.

    Where the columns are not `usable` as they are called, no command calls them so: the one that mends it follows, or
    stands above, where `all_named`. Of columns that all are channels of run.yaml nothing is said: they were shown while
    they came.
    """
    lines = info["lines"]
    text = f", {counted(lines['text'], 'line')} of text passed over" if lines["text"] else ""
    samples, bad = counted(info["samples"]["received"], "sample"), counted(lines["bad"], "bad line")
    print(f"{folder}: {info['exit_status']}, {samples}, {bad}{text}")
    if lines["unnamed"]:
        again = f"{recover_command(folder)} --columns {','.join(info['columns'])}"
        reads = again if usable and not all_named else f"the command {'above' if all_named else 'below'}"
        came = f"{counted(lines['unnamed'], 'line')} of numbers came before anything named their columns"
        print(f"{folder}: {came}; {reads} reads them too")
    again = f"{recover_command(folder)} {_names(info, naming_in(folder))}"
    rename = f"if not, put their names in the order in which they are printed: {again}"
    if not (all_named or (usable and ReadChannels(folder, info["columns"]).all_fit)):
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
        print(f"{folder}: {missing(info['holes'], _unit_of_clock(info, folder))}")


def clock_question(info: CaptureJson, folder: Path) -> str:
    """The question about a time that stands or falls back in a run that cannot be used."""
    often = counted(info["lines"]["time_backward"], "time")
    column = f"is the time another column than {clock_of(info, folder)}"
    return f"the device's time stands or falls back {often}: was it reset, or {column}?"
