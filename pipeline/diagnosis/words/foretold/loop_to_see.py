"""The stroke that confirms a name on a rig without a string, and the loop to see in it, in words."""

from ...document.content import Verdict
from ..explanations.rivals import called
from ..language.quantity import plus_minus, quantity
from ..language.vocabulary import Vocabulary
from .foretold_numbers import compared, of_explanation

SLOW = "loop_half_speed"
DETAILS = "details.txt"


def step(content: Verdict, words: Vocabulary, numbers: list[str], short: bool) -> list[list[str]]:
    """The stroke to record, and the loop to see in it; nothing where none is foretold. `numbers`: the table of loops.

    `short`: only the loop of the best explanation, in place of the table.
    """
    if not numbers:
        return []
    record = f"To make sure of the name, {_stroke(content, words)}"
    if not short:
        return [[f"{record} with this table:", *numbers]]
    loop = _loop(content, words)
    return [[f"{record} with {loop} (more: {DETAILS})." if loop else f"{record} with the table in {DETAILS}."]]


def _stroke(content: Verdict, words: Vocabulary) -> str:
    """The stroke to record, and what to compare in it."""
    expected = content["evidence"]["expected"]
    slow = quantity(0.5 * expected["speed_per_s"], f"{words.motion_unit}/s")
    hung = words.load is not None and expected.get("load")
    under = f", under {quantity(expected['load'], words.load_unit)}" if hung else ""
    slower = f"loop_half_speed_{words.ending}" in expected["explanations"][0]
    half = f"record one stroke at {slow}, half the usual speed{under}, and compare its loop"
    return half if slower else "record it again and compare"


def _loop(content: Verdict, words: Vocabulary) -> str:
    """The loop that the best explanation foretells for that stroke, and that of a clearly different one."""
    best = compared(content)[0]
    cell = of_explanation(best, SLOW, content, words)
    if cell is None or not cell.known:
        return ""
    count = len(best["ids"])
    together = ", both effects together" if count == 2 else ", all effects together" if count > 2 else ""
    loop = f"the {plus_minus(abs(cell.value), cell.half_width, words.unit)} of {called(best['ids'])}{together}"
    others = [(other, of_explanation(other, SLOW, content, words)) for other in compared(content)[1:]]
    apart = [
        f"; {called(other['ids'])} would open {plus_minus(abs(its.value), its.half_width, words.unit)}"
        for other, its in others
        if its is not None and its.known
        and abs(abs(its.value) - abs(cell.value)) > its.half_width + cell.half_width
    ]  # fmt: skip
    return f"{loop}{''.join(apart[:1])}"
