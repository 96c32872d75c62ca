"""The facts that the words of a verdict rest on: explanations, sizes, dimensions and what was covered."""

import numpy as np

from ..choice.outcome import Study, rms
from ..document.evidence import Evidence, Excursion
from ..document.made_keys import with_made
from ..recording.covered import covered
from ..recording.drivers import Drivers
from . import extents, mechanism_entries
from .explanations import explanations, left_out
from .look_alikes import look_alikes
from .recognised import recognised
from .told_floor import told_floor


def moved(study: Study) -> dict[str, float]:
    """By how many sigma calibration moved each dimension from what was measured."""
    problem = study.problem
    return {
        problem.parameters[i].name: float(
            (study.state.values[i] - problem.parameters[i].nominal) / problem.parameters[i].sigma
        )
        for i in problem.movable
    }


def tolerances(study: Study) -> dict[str, float]:
    """The sigma of each dimension that calibration may move, in its own unit."""
    problem = study.problem
    return {problem.parameters[i].name: problem.parameters[i].sigma for i in problem.movable}


def misfits(study: Study, ending: str) -> dict[str, float]:
    """The rms residual of the recording, with the dimensions of `run.yaml` and with calibrated ones."""
    problem = study.problem
    return {
        f"{name}_{ending}": rms((problem.measured - problem.simulate(state))[: problem.rows])
        for name, state in (("nominal", study.nominal), ("calibrated", study.base))
    }


def gone_off(study: Study, ending: str) -> Evidence:
    """`excursions`: when, how long and how far, in s and in the reading's unit `ending`; nothing if there are none.

    Beside it `between_…`: what calibration leaves of the time between them, rms.
    """
    times: list[tuple[Excursion, float]] = [
        ({"at_s": each.at_s, "lasts_s": each.lasts_s}, each.size) for each in study.gone_off
    ]
    entries = [with_made(when, {f"size_{ending}": size}) for when, size in times]
    if not entries:
        return {}
    problem = study.problem
    time_s, off = problem.record.time_s[: problem.rows], np.zeros(problem.rows, bool)
    for each in study.gone_off:
        off |= (time_s >= each.at_s) & (time_s <= each.at_s + each.lasts_s)
    residual = (problem.measured - problem.simulate(study.base))[: problem.rows]
    return with_made(Evidence(excursions=entries), {f"between_{ending}": rms(residual[~off])})


def other_load(drivers: Drivers) -> Evidence:
    """`other_load`: which few strokes had another load than the rest; nothing where none had, or the load varies."""
    load, strokes = drivers.load * drivers.units.load_size, drivers.under_another_load
    usual = [float(np.median(load[drivers.stroke == stroke])) for stroke in strokes]
    if not usual:
        return {}
    return {"other_load": {"usual": float(np.median(load)), "load": [min(usual), max(usual)], "strokes": strokes}}


def evidence(study: Study) -> Evidence:
    """All the facts, as `diagnosis.json` holds them; `floor` is that of the compared values, `step_s` apart."""
    system, drivers = study.problem.system, study.problem.drivers
    ending = system.channel.rpartition("_")[2]
    effects, alone = mechanism_entries.named_effects(study), misfits(study, ending)
    sizes = {
        f"spans_{ending}": extents.spans(effects),
        f"trends_{ending}": extents.trends(effects),
        f"tops_{ending}": extents.tops(effects, study.problem.record),
    }
    weighed: Evidence = {
        "explanations": explanations(study, ending, alone[f"calibrated_{ending}"]),
        "probability_of_none": study.judged.none if study.judged.likely and drivers.levered else None,
        "left_out": left_out(study),
        **recognised(study),
        **gone_off(study, ending),
        **look_alikes(study, ending),
        "loops": mechanism_entries.opened(study.problem, effects, f"width_{ending}", system.driver),
        "moved_sigma": moved(study),
        "tolerance": tolerances(study),
        "step_s": drivers.step_s,
        "strokes": [int(max(drivers.stroke.min(), 1)), int(drivers.stroke.max())],
        "loaded": drivers.loaded,
        **other_load(drivers),
        "covered": covered(study.problem.record),
    }
    if nearly := extents.sums(effects, study.problem.record):
        sizes[f"sums_{ending}"] = nearly
    whole = with_made(weighed, {f"floor_{ending}": told_floor(study), **alone}, "explanations")
    motion = {system.driver: [float(drivers.motion.min()), float(drivers.motion.max())]}
    return with_made(with_made(whole, sizes, "loops"), motion, "strokes")
