"""Further facts on a model, in its file under `ABOUT`: programs read them, so that they need not name models."""

from dataclasses import dataclass


@dataclass(frozen=True)
class About:
    """What a model can be asked and shown; the defaults fit most models.

    `needs_motion`: its answer depends on the whole motion before, so that single questions cannot be asked.
    `each_string_apart`: it has numbers of its own for every string and none for all: nothing goes over to a new string.
    Its `moves` hold them (`interface.StringsApart`).
    `least_strokes_alone`: how many strokes of one string suffice to fit it on them alone, 0 where it answers unfitted;
    None where one string is never enough.
    `by_equations`: it answers by the paper's equations alone, which hold between and beyond the recorded loads too.
    `needs_torch`: its module imports torch, which takes seconds, and which an installed package may lack.
    """

    needs_motion: bool = False
    each_string_apart: bool = False
    least_strokes_alone: int | None = None
    by_equations: bool = False
    needs_torch: bool = False
