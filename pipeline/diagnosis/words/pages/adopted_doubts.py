"""Doubts about adopted effects in run.yaml: advice of their verdict against them, and tied explanations."""

from ...document.content import Verdict
from ..explanations.rivals import called
from ..language.quantity import listing

NAMED = 2  # explanations that tied, by name; the others are counted


def against_advice(content: Verdict) -> list[str]:
    """The warning that effects were adopted against their verdict's advice, a sentence for each verdict."""
    lines = []
    for adoption in content.get("adopted", []):
        if advised := adoption.get("against_advice"):
            were, their = ("was", "its") if len(adoption["effects"]) == 1 else ("were", "their")
            against = f"{listing(adoption['effects'])} {were} adopted against the advice of {their} verdict"
            lines.append(f"{against}. It says: {advised[0]}")
    return list(dict.fromkeys(lines))  # each of several runs has adopted it


def doubtful(content: Verdict) -> list[str]:
    """The explanations that tied with adopted effects, a sentence for each adopted verdict that names some."""
    lines = []
    for adoption in content.get("adopted", []):
        effects, tied = listing(adoption["effects"]), adoption["tied"]
        if not tied and adoption.get("against_advice"):
            continue
        if not tied:
            lines.append(f"No other explanation was as likely as what was adopted ({effects}).")
            continue
        named = listing([called(ids) for ids in tied[:NAMED]], "or")
        rest = f", or one of {len(tied) - NAMED} more (`adopted` in run.yaml)" if len(tied) > NAMED else ""
        lines.append(
            f"Instead of what was adopted ({effects}) this may be right, for it was likely as well: {named}{rest}."
        )
    return list(dict.fromkeys(lines))
