"""Effects of one explanation whose loops are far wider than the loop that the recording shows: they partly cancel."""

from ...document.content import Part, Verdict
from ..language.quantity import listing, size
from ..language.vocabulary import Vocabulary

FAR = 2.0  # times the recorded loop: effects that open wider ones must take most of each other back


def lines(content: Verdict, entries: list[Part], words: Vocabulary) -> list[str]:
    """That the loops of some effects partly cancel; nothing where fewer than two are far wider than what is seen."""
    seen = ((content["evidence"].get("expected") or {}).get("recorded") or {}).get(f"loop_{words.ending}") or 0.0
    opened = content["evidence"].get("loops") or {}
    by_id = {entry["id"]: opened[entry["id"]][f"width_{words.ending}"] for entry in entries if entry["id"] in opened}
    wide = {id_: width for id_, width in by_id.items() if width > FAR * seen > 0.0}
    if len(wide) < 2:
        return []
    (first, its), *others = ((id_, size(width, words.unit)) for id_, width in wide.items())
    loops = listing([f"{first} would open a loop of {its}", *(f"{id_} one of {width}" for id_, width in others)])
    return [f"Alone {loops}; they partly cancel, so that the recorded loop is {size(seen, words.unit)}."]
