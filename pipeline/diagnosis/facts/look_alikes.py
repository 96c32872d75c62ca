"""The part of each named effect that moved dimensions cannot imitate, and which dimensions move in its place."""

from ..choice.outcome import Study, rms
from ..choice.recalibration import beyond
from ..document.evidence import Evidence
from ..document.made_keys import with_made
from ..fit import discrepancy
from ..fit.linear import Linear
from ..numerics.noise import white


def look_alikes(study: Study, ending: str) -> Evidence:
    """The rms of each effect that dimensions cannot imitate, by id, and how far calibration alone moves each.

    Dimensions move in tolerances. `ending` is that of the keys. Nothing where nothing is named.
    """
    problem = study.problem
    ids = [act.id for act in study.state.acts if act not in problem.included and act.id not in study.random]
    if not ids:
        return {}
    dimensions = Linear(problem, study.base, white(1.0), {})
    beyond_rms = {
        id_: rms(beyond(discrepancy.effect(problem, study.state, id_)[: problem.rows], dimensions)) for id_ in ids
    }
    moved = {
        problem.parameters[i].name: float(
            (study.base.values[i] - problem.parameters[i].nominal) / problem.parameters[i].sigma
        )
        for i in problem.movable
    }
    alone: Evidence = {"moved_alone_sigma": moved}
    return with_made(alone, {f"beyond_dimensions_{ending}": beyond_rms}, "moved_alone_sigma")
