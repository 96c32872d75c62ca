"""The options that a new run lacks, all named at once, and the load that is assumed where none is given."""

import argparse

from .description import STRING_ACTUATORS, Run
from .table.columns_read import has_no_load

NEEDED = ("material", "radius-mm", "length-mm")  # where no other run tells them
OF_SEPARATOR = ("torsion-zone-mm", "separator-mm")


def lacking(arguments: argparse.Namespace) -> str:
    """The options that a run still needs, as neither it nor another run gives them, in words; else empty."""
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
    """The remark on the assumed load of a run without a recording; empty where its description gives the load."""
    if not has_no_load(run):
        return ""
    return (
        "No load is given: where the recording has no channel load_n, it is taken as 0 N. If one hangs, give --load-n, "
        "or write rig.load_n into run.yaml."
    )
