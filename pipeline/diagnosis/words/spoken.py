"""The content of a diagnosis, all numbers → the same with the sentences that the contract wants in it."""

from typing import Any

from ...systems import System
from ..library import mechanisms
from ..naming import Units
from . import effects, experiment
from .quantity import listing
from .vocabulary import Vocabulary


def spoken(content: dict[str, Any], system: System) -> dict[str, Any]:
    """The content with `sentence` of each mechanism, `next_experiment`, and the driver of the mismatch in words."""
    words, units, evidence = Vocabulary.of(system), Units.of(system), content["evidence"]
    spans = evidence[f"spans_{words.ending}"]
    for entry in [*content["mechanisms"], *content.get("of_your_own", {"mechanisms": []})["mechanisms"]]:
        mechanism = mechanisms()[entry["id"]]
        entry["sentence"] = effects.sentence(mechanism, entry, spans.get(entry["id"]), words, units)
    if content["mismatch"]:
        said = followed(content["mismatch"]["driver"], words, evidence["loaded"])
        if any(effects.calculated(mechanisms()[entry["id"]], entry) for entry in content["mechanisms"]):
            said = said.replace("the temperature", effects.CALCULATED)
        content["mismatch"]["driver"] = said
    if content["next_run"]:
        content["next_experiment"] = experiment.in_one_line(content, words, whole(evidence, words))
    return content


def followed(drivers: list[str], words: Vocabulary, loaded: bool) -> str:
    """Several drivers as a list."""
    said = list(dict.fromkeys(words.follows(driver, loaded) for driver in drivers))
    return "; ".join(said) if any(" and " in one for one in said) and len(said) > 1 else listing(said)


def whole(evidence: dict[str, Any], words: Vocabulary) -> float:
    """Range of the motion."""
    low, high = evidence[words.driver]
    return float(high - low)
