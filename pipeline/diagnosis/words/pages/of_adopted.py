"""The results of adopted effects in run.yaml that can be reported, and those that cannot."""

from ...document.content import Verdict
from ..held_out import holdout
from ..language.quantity import listing

ADOPTED = "of {}: what the verdict lets report that was adopted (its details.txt, To report it)"
HELD = (
    "Do not report that this recording shows no effect: {} {} in the simulator. Nor report a size under What was "
    "adopted as measured here: the adopted numbers were held."
)


def reportable(content: Verdict) -> list[str]:
    """Where to find the results of adopted effects that can be reported."""
    ids = holdout.included(content)
    return [ADOPTED.format(listing(ids))] if ids else []


def not_reportable(content: Verdict) -> list[str]:
    """The numbers that are no results where effects are adopted: their sizes here, and those without them."""
    ids = holdout.included(content)
    return [HELD.format(listing(ids), "are" if len(ids) > 1 else "is")] if ids else []
