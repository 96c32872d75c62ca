"""What can be reported of effects that run.yaml has adopted, and what cannot."""

from ...document.content import Verdict
from ..held_out import holdout
from ..language.quantity import listing

ADOPTED = "of {}: what the verdict lets report that was adopted (its details.txt, To report it)"
HELD = (
    "Do not report that this recording shows no effect: {} {} in the simulator. Nor report a size under What was "
    "adopted as measured here: the adopted numbers were held."
)


def reportable(content: Verdict) -> list[str]:
    """Where it stands what can be reported of adopted effects."""
    ids = holdout.included(content)
    return [ADOPTED.format(listing(ids))] if ids else []


def not_reportable(content: Verdict) -> list[str]:
    """What is no result where effects are adopted: their sizes here, and a rig without them."""
    ids = holdout.included(content)
    return [HELD.format(listing(ids), "are" if len(ids) > 1 else "is")] if ids else []
