"""The table of adopted effects: each effect's name, how it was adopted, and how large it is here."""

from ....ground.outside_library import is_outside
from ...document.content import Adoption, Verdict
from ...document.effects_named import AdoptedEffect
from ...document.made_keys import amount, amount_or_none
from ..language.explained_words import meaning, on_rig
from ..language.quantity import size
from ..language.text_table import aligned
from ..language.vocabulary import Vocabulary
from .effect_sentence import at_the_top

HEADING = "What was adopted, by the library's names"
HEAD = ["effect", "adopted from", "its size here, rms"]
HELD = "Sizes are what the adopted numbers do here. How sure each effect is stands in the verdict that was adopted."


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """A row for each adopted effect, with what it does below; nothing without such effects, or in an older file."""
    entries: list[AdoptedEffect] = content["evidence"].get("adopted_effects", [])
    if not entries:
        return []
    rows = [
        [entry["id"], _adopted_as(content, entry["id"]), size(amount(entry, f"rms_{words.ending}"), words.unit)]
        for entry in entries
    ]
    head, *table = aligned([HEAD, *rows])
    table_lines = [head]
    for entry, row in zip(entries, table, strict=True):
        does = entry["sentence"] or on_rig(meaning(entry["id"]), words)
        top = at_the_top(content, amount_or_none(entry, f"top_{words.ending}"), words)
        table_lines += [row, f"    {does}{top}"]
    return [*table_lines, HELD]


def _adopted_as(content: Verdict, id_: str) -> str:
    """Whether an effect was adopted from the one explanation, or from one that tied with others."""
    of: list[Adoption] = [adoption for adoption in content.get("adopted", []) if id_ in adoption["effects"]]
    if not of:
        return "a stand-in, no name" if is_outside(id_) else "nobody wrote it down"
    sets = [of[-1]["effects"], *of[-1]["tied"]]
    against = ", against its advice" * bool(of[-1].get("against_advice"))
    if len(sets) == 1:
        return f"explained{against}"
    count = sum(id_ in ids for ids in sets)
    every = "both" if len(sets) == 2 else f"all {len(sets)}"
    return f"in {every if count == len(sets) else f'{count} of {len(sets)}'} likely explanations{against}"
