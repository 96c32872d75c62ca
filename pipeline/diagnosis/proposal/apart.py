"""By how much the readings that two explanations foretell for a proposed run part: what a person will see there."""

import numpy as np

from ...run.description import Run
from ..choice.outcome import Study
from ..study.rivals import refitted
from .next_runs import Proposal, appended, lengthened


def apart(study: Study, run: Run, proposal: Proposal) -> dict[str, float]:
    """The largest difference in the run between the two explanations that it parts, and the motion where it is.

    `by_…`, and the two readings there, `first_…` and `second_…`, in the unit of the reading, whose channel has that
    ending; the motion by the name of its channel; `after_s`, how long after the first leg that is, which leads to where
    the run begins. Empty where the run parts none.
    """
    if proposal.then is None:
        return {}
    best, by_ids = study.sets[0].ids, {explanation.ids: explanation for explanation in study.sets}
    states = [study.best if ids == best else refitted(study, by_ids[ids]) for ids in proposal.then[1:]]
    record = appended(study.problem.record, proposal.legs)
    longer, new = lengthened(study.problem, run, record), len(study.problem.record)
    first, second = (longer.simulate(state)[new:] for state in states)
    row = int(np.argmax(np.abs(first - second)))
    system = study.problem.system
    ending = system.channel.rpartition("_")[2]
    place = {f"by_{ending}": float(abs(first - second)[row]), system.driver: float(record.motion[new + row])}
    place |= {"after_s": float(record.time_s[new + row] - record.time_s[new - 1] - proposal.legs[0][0])}
    return place | {f"first_{ending}": float(first[row]), f"second_{ending}": float(second[row])}
