"""What a verdict without a name is worth, in words: the sizes from which effects would have been seen."""

from typing import Any

from pipeline.diagnosis.words import unseen
from pipeline.diagnosis.words.headline import UNNAMED
from pipeline.diagnosis.words.places import place
from pipeline.diagnosis.words.quantity import listing, size, times
from pipeline.diagnosis.words.vocabulary import Vocabulary


def pattern(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """How large a pattern is left without a name, where, and what it follows; nothing where none is left."""
    rms, evidence = content["mismatch"][f"rms_{words.ending}"], content["evidence"]
    if not rms:
        return []
    ratio = times(rms / evidence[f"floor_{words.ending}"])
    least = min(content["fit"][f"detectable_{words.ending}"].values(), default=0.0)
    if unseen.left_over(content, words):  # how much is said once, below
        said = "A pattern is left that no effect is named for."
    else:
        beyond = f"{size(rms, words.unit)} rms is more than noise ({ratio} times the noise)"
        said = f"Of the calibrated error in the table below, {beyond}, and no effect is named for it."
        if rms > least > 0.0:
            said += (
                " Some effects would have been seen at a smaller size (below): what is left looks like none of them."
            )
    found = evidence.get("pattern")
    if not found:
        return [said]
    where = place(found["location"], evidence, words)
    follows = listing([words.follows(driver, evidence["loaded"]) for driver in found["driver"]])
    share = f"{100.0 * found['location']['share']:.0f} % of the energy of what is systematic in it"
    return [said, f"{share} lies {where}. It follows {follows}."]


def lines(content: dict[str, Any], words: Vocabulary) -> list[str]:
    """The smallest effect of each kind that would have been seen; none smaller than what is left unexplained."""
    sizes = sorted(content["fit"][f"detectable_{words.ending}"].items(), key=lambda item: item[1])
    if content["verdict"] not in UNNAMED or not sizes:
        return []
    left = unseen.left_over(content, words)
    larger = [f"{id_} {size(least, words.unit)}" for id_, least in sizes if least > left]
    if not left:
        if any(one["tied"] for one in content.get("adopted", [])):
            beside = "Beside what was adopted, one more effect would have been seen from this size on (rms). That does "
            return [f"{beside}not exclude it in place of an adopted one:", f"{listing(larger)}."]
        return ["An effect would have been seen from this size on (rms):", f"{listing(larger)}."]
    more = f"Of the errors in the table above, {size(left, words.unit)} rms is more than noise"
    said = f"{more}: effects of that size and less may hide in it."
    if not larger:
        return [said, "A larger one would have been seen."]
    if len(larger) == len(sizes):
        return [said, "A larger one would have been seen from this size on (rms):", f"{listing(larger)}."]
    return [
        said,
        "A larger one would have been seen, but these only from their own size on (rms):",
        f"{listing(larger)}.",
    ]
