"""A diagnosis without the mechanisms whose strength came out as 0: they explain nothing."""

from typing import cast

from ...ground.outside_library import is_outside
from ..document.content import Mismatch, Verdict
from ..document.explanations import ExplanationEntry
from ..document.made_keys import interval
from ..mechanisms.library import mechanisms


def without_zero_effects(content: Verdict, ending: str) -> Verdict:
    """The content without named mechanisms of size 0, whose ids `evidence.idle` lists.

    Where no physics would remain they stay named, but for `simulation`.

    The best explanation is then the smaller one, which may stand among the others too: there it goes. `ending` is that
    of the keys.
    """
    idle = [entry["id"] for entry in content["mechanisms"] if not interval(entry, f"rms_{ending}")["value"]]
    kept = [entry for entry in content["mechanisms"] if entry["id"] not in idle]
    content = content | {"simulation": [entry for entry in content["simulation"] if entry["id"] not in idle]}
    if not idle or all(is_outside(entry["id"]) for entry in kept):
        return content
    ids = {entry["id"] for entry in kept}
    others = [other for other in content["alternatives"] if set(other) != ids]
    shown: list[ExplanationEntry] = []
    twins = [explanation for explanation in content["evidence"]["explanations"] if set(explanation["ids"]) == ids]
    for explanation in content["evidence"]["explanations"]:
        if explanation["standing"] == "named":
            weighed = [each.get("probability") for each in (explanation, *twins)]
            shares = [share for share in weighed if share is not None]
            kept_ids = [id_ for id_ in explanation["ids"] if id_ not in idle]
            made_of: ExplanationEntry = {**explanation, "ids": kept_ids, "probability": sum(shares) if shares else None}
            shown.append(made_of)
        elif set(explanation["ids"]) != ids:
            shown.append(explanation)
    tidied = content | {"mechanisms": kept, "alternatives": others}
    if content["mismatch"]:
        driven = {**content["mismatch"], "driver": [mechanisms()[entry["id"]].driver for entry in kept]}
        tidied["mismatch"] = cast(Mismatch, driven)  # the drivers become words last
    tidied["evidence"] = content["evidence"] | {"explanations": shown, "idle": idle}
    if content["verdict"] == "ambiguous" and not others:
        tidied |= {"verdict": "explained", "next_run": None}
    return tidied
