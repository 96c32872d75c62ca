"""What at the rig tells the open effects apart, where no run is sure to: each one's own sign."""

from typing import Any

from ..library import mechanisms
from . import certainty, worth
from .vocabulary import Vocabulary

HEADING = "What tells the open effects apart at the rig"


def lines(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """A line for each open effect with its sign, then the test for slow effects; nothing where all is settled."""
    if content["verdict"] not in ("explained", "ambiguous"):
        return []
    return [*_open(content), *certainty.asks(content, words)]


def _open(content: dict[str, Any]) -> list[str]:
    run = content["next_run"]
    if content["verdict"] != "ambiguous":
        return []
    sets = [{entry["id"] for entry in content["mechanisms"]}, *map(set, content["alternatives"])]
    every = dict.fromkeys(id_ for ids in sets for id_ in sorted(ids))
    found = [f"{id_}: {mechanisms()[id_].told_apart_by}." for id_ in every if not all(id_ in ids for ids in sets)]
    tried = "These hold in general. Other loads and speeds were tried in simulation: on this rig they need not tell."
    decided = bool(run) and (worth.decides(run) if "parts" in run else True)
    return [*([] if decided else [tried]), *found] if found else []
