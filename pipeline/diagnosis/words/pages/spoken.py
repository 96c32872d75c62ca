"""The content of a diagnosis, numbers only → the same with the sentences of `diagnosis/document/content.py`."""

from typing import cast

from ....systems import System
from ...document.content import Verdict
from ...document.evidence import Evidence
from ...document.made_keys import amount, by_name, extent
from ...mechanisms.library import mechanisms
from ...recording.system_units import Units
from ..language.quantity import listing
from ..language.vocabulary import Vocabulary
from ..named import effect_sentence
from ..next_run import experiment


def spoken(content: Verdict, system: System) -> Verdict:
    """The content with `sentence` of each mechanism, `next_experiment`, and the driver of the mismatch in words."""
    words, units, evidence = Vocabulary.of(system), Units.of(system), content["evidence"]
    spans, opened = by_name(evidence, f"spans_{words.ending}"), evidence.get("loops", {})
    trends = by_name(evidence, f"trends_{words.ending}")
    for entry in [*content["mechanisms"], *content.get("of_your_own", {"mechanisms": []})["mechanisms"]]:
        mechanism = mechanisms()[entry["id"]]
        entry["sentence"] = effect_sentence.sentence(
            mechanism,
            entry,
            spans.get(entry["id"]),
            words,
            units,
            opened.get(entry["id"]),
            trends.get(entry["id"]),
            whole(evidence, words),
            content["parameters"].get("mass_kg", {}).get("value"),
        )
    for beside in content.get("beside", []):
        span = amount(beside, f"span_{words.ending}")
        beside["sentence"] = effect_sentence.sentence(mechanisms()[beside["id"]], beside, span, words, units)
    if content["mismatch"]:
        listed = cast(list[str], content["mismatch"]["driver"])  # as it was found: the words are made here
        driver = followed(listed, words, evidence["loaded"])
        if any(effect_sentence.calculated(mechanisms()[entry["id"]], entry) for entry in content["mechanisms"]):
            driver = driver.replace("the temperature", effect_sentence.CALCULATED)
        content["mismatch"]["driver"] = driver
    if content["next_run"]:
        content["next_experiment"] = experiment.in_one_line(content, words, whole(evidence, words))
    return content


def followed(drivers: list[str], words: Vocabulary, loaded: bool) -> str:
    """Several drivers as a list."""
    phrases = list(dict.fromkeys(words.follows(driver, loaded) for driver in drivers))
    return "; ".join(phrases) if any(" and " in phrase for phrase in phrases) and len(phrases) > 1 else listing(phrases)


def whole(evidence: Evidence, words: Vocabulary) -> float:
    """Range of the motion."""
    low, high = extent(evidence, words.driver)
    return float(high - low)
