"""The mark on the page of a run: that of the synthetic rig that recorded it, not that of all reports.

A diagnosis is made with no setting of a configuration: the page of a run has a mark only where the synthetic rig that
a configuration sets up recorded it.
"""

import argparse
from collections.abc import Callable, Collection

from ..layout.made_by import MadeBy
from ..web.marks import mark_from

Marks = Callable[[str], MadeBy | None]  # a run's name → its mark


def add_rig_mark(parser: argparse.ArgumentParser) -> None:
    """Add the option for the mark of the synthetic rig to a command line."""
    parser.add_argument("--rig-mark", metavar="JSON", help="mark of the pages of the rig's runs; default: as above")


def marks_of_runs(text: str | None, whole: MadeBy, rigs: Collection[str]) -> Marks:
    """The mark of each run: that of `rigs` alone if given, else the `whole` one; raises BadInput for none."""
    mark = whole if text is None else mark_from(text, "--rig-mark")
    worn = mark if text is None or mark.rig else None
    return lambda run: worn if text is None or run in rigs else None
