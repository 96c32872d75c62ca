"""What a verdict without a name is worth, in words: the size from which each effect would have been seen."""

from ...document.content import Verdict
from ...document.made_keys import by_name
from ...mechanisms.interface import physics
from ...mechanisms.library import mechanisms
from ..held_out import holdout, unseen
from ..held_out.without_name import UNNAMED
from ..language.quantity import listing, size
from ..language.text_table import aligned
from ..language.vocabulary import Vocabulary

ABREAST = 3  # effects in a row


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """The smallest size of each effect that would have been seen; none smaller than the unexplained rest."""
    detectable = by_name(content["fit"], f"detectable_{words.ending}")
    adopted_ids = [id_ for id_ in holdout.included(content) if id_ in detectable]
    if content["verdict"] not in UNNAMED or not detectable:
        return []
    listed = sizes(content, words, adopted_ids)
    if adopted_ids:
        listed.append(
            f"Not listed, for run.yaml has adopted {'it' if len(adopted_ids) == 1 else 'them'}: {listing(adopted_ids)}."
        )
    unseen_here = [
        id_
        for id_, mechanism in mechanisms().items()
        if physics((id_,)) and not mechanism.helper and id_ not in detectable
    ]
    if words.twisted and unseen_here:
        cannot = "this recording cannot show them, or calibration takes them up"
        listed.append(
            f"Not listed, for {cannot if len(unseen_here) > 1 else cannot.replace('them', 'it')}: "
            f"{listing(unseen_here)}."
        )
    return listed


def sizes(content: Verdict, words: Vocabulary, adopted_ids: list[str]) -> list[str]:
    """The smallest effect of each kind but `adopted_ids`, the smallest first."""
    detectable = by_name(content["fit"], f"detectable_{words.ending}")
    sizes = sorted(
        ((id_, least) for id_, least in detectable.items() if id_ not in adopted_ids), key=lambda item: item[1]
    )
    if not sizes:
        return []
    left_rms = unseen.left_over(content, words)
    larger = [(id_, size(least, words.unit)) for id_, least in sizes if least > left_rms]
    if not left_rms:
        if any(adoption["tied"] for adoption in content.get("adopted", [])):
            beside = "Beside what was adopted, one more effect would have been seen from this size on (rms). That does "
            return [f"{beside}not exclude it in place of an adopted one:", *in_columns(larger)]
        return ["An effect would have been seen from this size on (rms):", *in_columns(larger)]
    more = f"Of the errors in the table above, {size(left_rms, words.unit)} rms is more than noise"
    hides = f"{more}: effects of that size and less may hide in it."
    if not larger:
        return [hides, "A larger one would have been seen."]
    if len(larger) == len(sizes):
        return [hides, "A larger one would have been seen from this size on (rms):", *in_columns(larger)]
    only = "A larger one would have been seen, but these only from their own size on (rms):"
    return [hides, only, *in_columns(larger)]


def in_columns(sizes: list[tuple[str, str]]) -> list[str]:
    """Effects with their sizes, the smallest first, row by row."""
    cells = [cell for pair in sizes for cell in pair]
    cells += [""] * (-len(cells) % (2 * ABREAST))
    return aligned([cells[at : at + 2 * ABREAST] for at in range(0, len(cells), 2 * ABREAST)])
