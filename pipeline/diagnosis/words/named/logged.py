"""A logged quantity that no named effect follows: one sentence tells it, so that no reader wonders."""

from ...document.content import Verdict
from ...document.made_keys import by_name
from ...mechanisms.library import mechanisms
from ..language.quantity import number, size
from ..language.vocabulary import Vocabulary
from . import effect_sentence

FOLLOWED = "temperature"  # the driver of what follows it
SAYS = "The logged temperature ({low} to {high} °C) was not needed{seen}."
SEEN = "; an effect of it would be seen from {} rms on"


def temperature(content: Verdict, words: Vocabulary) -> list[str]:
    """That the logged temperature was not needed; nothing where none was logged, or where something may follow it."""
    ends = (content["evidence"].get("covered") or {}).get("temperature_c")
    mismatch = content["mismatch"] if content["verdict"] == "unknown" else None
    driver = mismatch.get("driver", "") if mismatch else ""
    following = {id_ for id_, mechanism in mechanisms().items() if mechanism.driver == FOLLOWED}
    named = {entry["id"]: entry for entry in content["mechanisms"]}
    best = {id_ for id_, entry in named.items() if not effect_sentence.calculated(mechanisms()[id_], entry)}
    maybe = {id_ for ids in content["alternatives"] for id_ in ids}
    adopted = {entry["id"] for entry in content.get("simulation", [])} - named.keys()
    if not ends or FOLLOWED in driver or following & (best | maybe | adopted):
        return []
    least = [by_name(content["fit"], f"detectable_{words.ending}").get(id_) for id_ in following]
    seen = "".join(SEEN.format(size(each, words.unit)) for each in least if each)
    return [SAYS.format(low=number(ends[0], 3), high=number(ends[1], 3), seen=seen)]
