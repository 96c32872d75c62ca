"""The words that a verdict uses, each explained in a line, for a reader who has only `details.txt`."""

import re

from ....ground.words.glossary import MEANING
from ...document.content import Verdict
from ...document.effects_named import MechanismEntry
from ...mechanisms.library import mechanisms
from .quantity import quantity
from .vocabulary import ANGLES, Vocabulary

USUAL = ("nominal", "calibrated", "as diagnosed", "mismatch", "noise floor", "rms")
NAMED = re.compile(r"^\w+ {2,}named\b", re.M)  # how sure an effect is, in the table of them
GROWS, NO_STRING = " that grows with load or twist", "on rigs without string"
ANY_READING = "force or angle"  # to which an offset is added
TURN, DRIVEN = "once a turn", "once in every turn of what drives it (a screw, a motor)"


def lines(content: Verdict, text: str, words: Vocabulary) -> list[str]:
    """The verdict's word, those of errors, then each effect that the verdict's `text` so far names.

    Those that the verdict names are left out: its tables say what they do.
    """
    used = [word for word in USUAL if re.search(rf"\b{word}\b", text)]
    used += ["named"] if NAMED.search(text) else []
    in_tables = [entry["id"] for entry in [*content["mechanisms"], *content["evidence"].get("adopted_effects", [])]]
    in_tables += [id_ for ids in content["alternatives"] for id_ in ids]
    named = [id_ for id_ in mechanisms() if id_ not in in_tables and re.search(rf"\b{id_}\b", text)]
    return [f"{word}: {on_rig(meaning(word), words)}" for word in [content["verdict"], *used, *named]]


def meaning(word: str) -> str:
    """The meaning of a word; for a mechanism of a user's own, the driver that it follows."""
    return MEANING.get(word) or f"a mechanism of your own; it follows {mechanisms()[word].driver}."


def of_effect(entry: MechanismEntry, words: Vocabulary) -> str:
    """What a named mechanism does on the rig; for a ripple of a known pitch, also the distance of its waves."""
    pitch = next((constant for name, constant in entry["parameters"].items() if name.startswith("pitch_")), None)
    if pitch is None or not pitch["value"]:
        return on_rig(meaning(entry["id"]), words)
    return meaning(entry["id"]).replace(TURN, f"once in every {quantity(pitch['value'], pitch['unit'], digits=3)}")


def tells(id_: str, words: Vocabulary) -> str:
    """The test that tells an effect from others, in the words of a rig, without a full stop."""
    test = mechanisms()[id_].told_apart_by
    return on_rig(test if words.twisted else test.replace("two twists", f"two {words.motion}s"), words)


def on_rig(sentence: str, words: Vocabulary) -> str:
    """A meaning, which is written for a string, in the words of a rig."""
    sentence = sentence.replace(ANY_READING, words.reading)
    if words.twisted:
        return sentence
    sentence = sentence.replace(GROWS, "") if words.differentiates else sentence
    sentence = sentence.replace(NO_STRING, "on this rig")
    up, down = words.ways
    sentence = sentence.replace("winding and unwinding", f"{up} and {down}").replace(
        "first turns move", "first motion moves"
    )
    sentence = sentence if words.motion_unit in ANGLES else sentence.replace(TURN, DRIVEN)
    for of_string, own in (("string", words.string), ("twist", words.motion), ("displacement", words.reading)):
        sentence = re.sub(rf"\b{of_string}\b", own, sentence)
    return sentence
