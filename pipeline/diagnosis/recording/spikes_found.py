"""Which samples of a recording do not count: spikes of its motion, of its reading and of its load."""

from collections.abc import Sequence

from ...ground.stored.rows import rows_of
from ...run.spikes import spikes
from ..document.evidence import Spike
from .recorded_run import RecordedRun


def spikes_found(recorded: Sequence[RecordedRun]) -> list[Spike]:
    """How many spikes each channel of each run has, `count`, and the time stamp of the first, `first_s`.

    A channel without any has no entry.
    """
    entries: list[Spike] = []
    for each in recorded:
        system, rows = each.run.system, rows_of(each.samples)
        for column in (system.driver, system.channel, system.load):
            if column is None or column not in rows.columns:
                continue
            places = spikes(rows, column)
            if len(places):
                first_s = float(rows.at("time_s", places[:1])[0])
                entries.append({"run": each.run.run, "column": column, "count": len(places), "first_s": first_s})
    return entries
