"""The remarks on a black box's part in a prediction: what it is, what it was worth, and where it says nothing."""

from ...prediction.residual import Residual
from ..language.quantity import listing, size

RESIDUAL = "--residual"  # the option
HELPS = 0.95  # of the error without it: more is no help


def columns_of(channel: str) -> tuple[str, str, str]:
    """The columns of a black box beside a reading's, such as `residual_mm`; the last two are its interval."""
    ending = channel.rpartition("_")[2]
    return f"residual_{ending}", f"residual_low_{ending}", f"residual_high_{ending}"


def of_residual(answer: Residual, channel: str, unit: str) -> list[str]:
    """What a black box adds, its data, its worth on unseen strokes, and where it adds 0."""
    added, low, high = columns_of(channel)
    with_it, without = size(answer.error_with, unit), size(answer.error_without, unit)
    helps = answer.error_with < HELPS * answer.error_without
    sentences = [
        f"{added}: no physics, but what boosted trees, a black box, make of what the simulator leaves of the strokes "
        f"of {listing(list(answer.runs))}. {channel} is without it",
        f"on the last strokes, which neither simulator nor black box had seen, the error was {without} rms without it "
        f"and {with_it} with it: "
        + (f"it helps. Add it to {channel} to predict, not to explain" if helps else "it does not help: leave it out"),
        f"{low} and {high}: nine of ten readings of those strokes lay between {channel} + {low} and {channel} + {high}",
    ]
    if out := int((~answer.inside).sum()):
        beyond = f"{'lies' if out == 1 else 'lie'} beyond the drivers that it was fitted to"
        sentences.append(
            f"{out} of {len(answer.inside)} rows {beyond}: {added} is 0 there, and {low} and {high} are empty"
        )
    return sentences
