"""Held-out strokes that decide between explanations that were likely without them, and so contradict none of them."""

from ...document.content import Verdict
from ..language.quantity import listing
from . import holdout


def decided(content: Verdict) -> list[str]:
    """That the last strokes decided, and between which explanations; nothing where they did not."""
    others = [" + ".join(sorted(ids)) for ids in content["evidence"].get("likely_without_them", [])]
    if not others:
        return []
    many = f"{listing(others)} {'was' if len(others) == 1 else 'were'} likely too"
    return [
        f"Without the {holdout.split(content)} {many}. These strokes had a load or a motion that no stroke before them "
        f"had, and decide. Their error is that of {holdout.named(content)}, fitted without them: they chose it among "
        f"{len(others) + 1}, and nothing in it was fitted to them."
    ]
