"""The second load to hang for the next recording: the one that parts the loops of two explanations more."""

from ...document.content import Verdict
from ..foretold.foretold_numbers import apart, compared, of_explanation, tells
from ..language.quantity import number, quantity
from ..language.vocabulary import Vocabulary
from ..measured import other_load

HALF, TWICE = 0.5, 2.0
ROWS = {HALF: "loop_half_load", TWICE: "loop_twice_load"}
SHARES = {HALF: "half", TWICE: "twice"}


def base(content: Verdict) -> float:
    """The recorded load; loops are foretold for half and twice of it."""
    foretold = (content["evidence"].get("expected") or {}).get("load")
    return float(foretold or other_load.usual(content) or content["evidence"]["covered"]["load"][1])


def begun(content: Verdict) -> float:
    """The share to hang where none parts two explanations: twice where a few strokes had more, else half."""
    other = content["evidence"].get("other_load")
    return TWICE if other and max(other["load"]) > other["usual"] else HALF


def best(content: Verdict, words: Vocabulary) -> tuple[float, float] | None:
    """The share of the recorded load that parts the best explanation and its rival more, and how far, as `tells`.

    None where no loop is foretold under another load.
    """
    columns = compared(content)[:2]
    parted = {
        share: tells([of_explanation(each, row, content, words) for each in columns]) for share, row in ROWS.items()
    }
    ratios = {share: ratio for share, ratio in parted.items() if ratio is not None}
    return max(((share, ratio) for share, ratio in ratios.items()), key=lambda pair: pair[1]) if ratios else None


def sentence(content: Verdict, words: Vocabulary) -> str:
    """Which second load to hang beside the recorded one, and whether it tells; or which few strokes had one."""
    if few := other_load.only_in(content):
        hung = other_load.size(content, words)
        return f"It has a second load, {hung}, only in {few}: more strokes under it would do."
    load, chosen = base(content), best(content, words)
    if chosen is None:
        other = f"{number(HALF * load)} or {quantity(TWICE * load, words.load_unit)}"
        return f"It has no second load: {other}, half or twice, would do if the rig bears it."
    share, ratio = chosen
    named, rival = apart(*compared(content)[:2])
    hung, rest = quantity(share * load, words.load_unit), HALF + TWICE - share
    other = quantity(rest * load, words.load_unit)
    if ratio < 1.0:
        return (
            f"It has no second load, and neither {hung} nor {other} tells {named} from {rival} here by more than the "
            "plus-minus of their loops."
        )
    bears = " if the rig bears it" if share > 1.0 else f"; where that is too little, {other}"
    return f"It has no second load: {hung}, {SHARES[share]}, tells {named} from {rival} best{bears}."
