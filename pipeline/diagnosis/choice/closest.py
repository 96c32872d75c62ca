"""A simulator for an unknown mismatch: an explanation that foretells far better than dimensions, and is no name."""

from dataclasses import replace

from ..mechanisms.interface import physics
from ..mechanisms.library import mechanisms
from .cross_validation import left_out_errors
from .outcome import Study, cancels

HALF_TAKEN = 0.75  # of the mismatch's energy, half of its rms: what takes less of it is simulated by nobody
FORETOLD = 0.7  # of the error of dimensions alone on left-out stretches: who errs by more foretells no better


def with_closest(study: Study) -> Study:
    """The study; if its verdict is unknown and its best explanation foretells clearly, that one is its `closest`."""
    return replace(study, closest=study.best) if study.verdict == "unknown" and foretells(study) else study


def foretells(study: Study) -> bool:
    """Whether the best explanation, which is no name, takes half of the mismatch or more, also on left-out stretches.

    It must be physics of the library alone, and its effects must not cancel each other. On stretches that its
    coefficients were not fitted to, it must err by much less than dimensions alone.
    """
    if not study.sets or study.share < HALF_TAKEN or cancels(study.problem, study.best):
        return False
    ids = study.sets[0].ids
    if not physics(ids) or any(mechanisms()[id_].helper for id_ in ids):
        return False
    search = study.search
    without, with_it = left_out_errors(search.linear, [search.nothing, search.explain(ids)])
    return with_it < FORETOLD * without
