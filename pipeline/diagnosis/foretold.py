"""Each run that could be made next, with what each explanation that ties foretells of it."""

from typing import Any

import numpy as np

from ..ground.kinematics import Array
from ..run.description import Run
from .nextrun import Proposal, appended, lengthened, options
from .outcome import Study
from .verdict import tidy
from .words.worth import decides

POINTS = 400  # of a curve


def foretold(found: Study, run: Run, fixed_load: bool) -> list[dict[str, Any]]:
    """Entries as `next_run` of diagnosis.json has them, best first, with `decides` and `curves`; none without a tie.

    A curve begins at 0 with its run: `calibrated` is the simulator without mechanisms, `rivals` those that tie.
    """
    if found.verdict != "ambiguous":
        return []
    entries = []
    for proposal in options(found.problem, run, found.noise, found.search, found.sets):
        entry = proposal.entry(run, fixed_load)
        entries.append({**tidy(entry), "decides": decides(entry), "curves": curves(found, run, proposal)})
    return entries


def curves(found: Study, run: Run, proposal: Proposal) -> dict[str, Any]:
    """Time in s, motion and load of a proposed run, and each reading, as lists of at most POINTS numbers."""
    problem, before = found.problem, len(found.problem.record)
    record = appended(problem.record, proposal.legs)
    longer = lengthened(problem, run, record)
    which = np.unique(np.linspace(before, len(record) - 1, POINTS).astype(int))

    def thin(values: Array) -> list[float]:
        return [float(f"{value:.6g}") for value in values[which]]

    def since(values: Array) -> list[float]:
        return thin(values - values[before])

    rivals = {
        " + ".join(one.ids): since(longer.simulate(found.search.linear.state_of(one.fit, one.keys)))
        for one in found.sets
    }
    return {
        "time_s": thin(record.time_s - record.time_s[before]),
        problem.system.driver: thin(record.motion),
        "load": thin(record.load),
        "calibrated": since(longer.simulate(found.base)),
        "rivals": rivals,
    }
