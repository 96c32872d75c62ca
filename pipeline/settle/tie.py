"""The tie before its deciding run, for a person: the explanations, how probable they are, and where to read more."""

from collections.abc import Sequence

from ..ground.errors import BadInput
from .proposed import ProposedRun, StepVerdict
from .step import Place, Step

SETTLED_RIGHTLY = "in tests 30 of 50 ties were settled rightly by such runs (docs/settle.md)"


def name_of(ids: Sequence[str]) -> str:
    """An explanation by the names of its mechanisms."""
    return " + ".join(ids) or "no mechanism"


def probable(ids: Sequence[str], verdict: StepVerdict) -> str:
    """An explanation by the names of its mechanisms, with its probability where the verdict holds one."""
    explanations = verdict.get("evidence", {}).get("explanations", [])
    by_ids = {frozenset(each["ids"]): each.get("probability") for each in explanations}
    probability = by_ids.get(frozenset(ids))
    return name_of(ids) + ("" if probability is None else f" ({100.0 * probability:.0f} %)")


def closest(run: ProposedRun) -> str:
    """The two explanations that stay closest with a run, in words; empty where no file tells them."""
    pairs = [pair for pair in run.get("pairs", []) if len(pair["ids"]) == 2]
    parts = run.get("parts", [])
    ids = min(pairs, key=lambda pair: pair["gap_then"])["ids"] if pairs else parts if len(parts) == 2 else []
    return " and ".join(map(name_of, ids))


def tie(step: Step, place: Place) -> list[str]:
    """The explanations that a step's run decides between, with their probability by the verdict before, and its file.

    Nothing of a first recording, before which there is no verdict.
    """
    path = so_far(step, place)
    if not path:
        return []
    try:
        verdict = place.diagnosis(step.number - 1)
    except (BadInput, OSError):
        return []
    words = [probable(ids, verdict) for ids in step.proposal.get("parts", [])]
    decides = [f"It is to tell apart what ties: {', '.join(words)}."] if words else []
    return [*decides, path]


def so_far(step: Step, place: Place) -> str:
    """The place of the verdict before a step's run; empty before the first one."""
    path = place.folder(step.number - 1) / "verdict.txt"
    return f"the verdict so far: {path}" if step.number and path.is_file() else ""
