"""Each run that could be made next, with what each explanation that ties, or nearly does, foretells of it."""

from typing import cast

import numpy as np

from ...ground.kinematics import Array
from ...run.description import Run
from ..choice.outcome import Study
from ..choice.search import Explanation
from ..document.expected import NextRun
from ..document.rounded import tidy
from ..mechanisms.interface import physics
from .design import decides, raises
from .next_runs import Proposal, appended, lengthened, options

POINTS = 400  # of a curve
SURE = 0.9  # probability from which one explanation needs no other run: of five firm wrong names none had more


def foretold(study: Study, run: Run, fixed_load: bool) -> list[NextRun]:
    """Entries as `next_run` of diagnosis.json has them, best first; none without rivals.

    Each has `decides`, `raises` and `curves`. A curve begins at 0 with its run: `calibrated` is the simulator without
    mechanisms, `rivals` the explanations.
    """
    sets, entries = rivals(study), []
    for proposal in options(study.problem, run, study.noise, study.search, sets) if sets else []:
        entry = proposal.entry(run, fixed_load)
        gaps = entry["gap_now"], entry["gap_then"]
        tells = {"decides": decides(*gaps), "raises": raises(*gaps)}
        drawn = curves(study, run, proposal, sets)
        entries.append(cast(NextRun, {**tidy(entry), **tells, "curves": drawn}))
    return entries


def rivals(study: Study) -> list[Explanation]:
    """The explanations that tie; of one that is not sure, it and the likeliest other; else none."""
    if study.verdict == "ambiguous":
        return study.sets
    likely = {ids: share for ids, share in study.judged.likely.items() if physics(ids)}
    if study.verdict != "explained" or likely.get(study.sets[0].ids, 1.0) >= SURE or len(likely) < 2:
        return []
    others = [ids for ids in likely if ids != study.sets[0].ids]
    return [study.sets[0], study.explanation(max(others, key=lambda ids: likely[ids]))]


def curves(
    study: Study, run: Run, proposal: Proposal, sets: list[Explanation]
) -> dict[str, list[float] | dict[str, list[float]]]:
    """Time in s, motion and load of a proposed run, and each reading, as lists of at most POINTS numbers."""
    problem, before = study.problem, len(study.problem.record)
    record = appended(problem.record, proposal.legs)
    longer = lengthened(problem, run, record)
    which = np.unique(np.linspace(before, len(record) - 1, POINTS).astype(int))

    def thin(values: Array) -> list[float]:
        return [float(f"{value:.6g}") for value in values[which]]

    def since(values: Array) -> list[float]:
        return thin(values - values[before])

    foretelling = {
        " + ".join(explanation.ids): since(
            longer.simulate(study.search.linear.state_of(explanation.fit, explanation.keys))
        )
        for explanation in sets
    }
    return {
        "time_s": thin(record.time_s - record.time_s[before]),
        problem.system.driver: thin(record.motion),
        "load": thin(record.load),
        "calibrated": since(longer.simulate(study.base)),
        "rivals": foretelling,
    }
