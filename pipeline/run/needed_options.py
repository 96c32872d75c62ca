"""Which options a new run lacks, all named at once, and what is taken for a load that nobody gives."""

import argparse

from .description import STRING_ACTUATORS, Run
from .table.columns_read import has_no_load

NEEDED = ("material", "radius-mm", "length-mm")  # where no other run tells them
OF_SEPARATOR = ("torsion-zone-mm", "separator-mm")


def lacking(arguments: argparse.Namespace) -> str:
    """The options that a run needs where no other run tells them, and that were not given, in words; else empty."""
    if arguments.like:
        return ""
    has_separator = (arguments.actuator or STRING_ACTUATORS[0]) == STRING_ACTUATORS[0]
    needed = (*NEEDED, *(OF_SEPARATOR if has_separator else ()))
    names = [f"--{name}" for name in needed if getattr(arguments, name.replace("-", "_")) is None]
    if not names:
        return ""
    pair = "; a rig without a separator: --actuator twisted_pair" if "--torsion-zone-mm" in names else ""
    return f"the following arguments are required without --like: {', '.join(names)}{pair}"


def load_taken(run: Run) -> str:
    """What is taken for the load of a run into which nothing is recorded yet; empty where its description tells it."""
    if not has_no_load(run):
        return ""
    return (
        "No load is given: where the recording has no channel load_n, it is taken as 0 N. If one hangs, give --load-n, "
        "or write rig.load_n into run.yaml."
    )
