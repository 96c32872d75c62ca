"""What at the rig tells the open effects apart, where no run is sure to: each one's own sign."""

from ..content import Verdict
from ..library import mechanisms
from . import certainty, expectation, worth
from .vocabulary import Vocabulary

HEADING = "What tells the open effects apart at the rig"


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """A line for each open effect with its sign, then the test for slow effects; nothing where all is settled."""
    if content["verdict"] not in ("explained", "ambiguous"):
        return []
    numbers = expectation.lines(content, words) if content["verdict"] == "ambiguous" else []
    return [*_open(content), *certainty.asks(content, words), *numbers]


def _open(content: Verdict) -> list[str]:
    run = content["next_run"]
    if content["verdict"] != "ambiguous":
        return []
    sets = [{entry["id"] for entry in content["mechanisms"]}, *map(set, content["alternatives"])]
    every = dict.fromkeys(id_ for ids in sets for id_ in sorted(ids))
    tests = [f"{id_}: {mechanisms()[id_].told_apart_by}." for id_ in every if not all(id_ in ids for ids in sets)]
    tried = "These hold in general. Other loads and speeds were tried in simulation: on this rig they need not tell."
    decided = run is not None and ("parts" not in run or worth.decides(run))
    return [*([] if decided else [tried]), *tests] if tests else []
