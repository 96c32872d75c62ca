"""Where the reading goes off for a while and comes back, in words."""

from ...document.content import Part, Verdict
from ..language.quantity import duration, listing, number, size
from ..language.vocabulary import Vocabulary

MOST = 4  # that are named by when they begin


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """One line on all of them; nothing where there is none."""
    entries: list[Part] = content["evidence"].get("excursions", [])
    if not entries:
        return []
    ends = [min(entry["lasts_s"] for entry in entries), max(entry["lasts_s"] for entry in entries)]
    largest = size(max(entry[f"size_{words.ending}"] for entry in entries), words.unit)
    begin = [number(round(entry["at_s"]), 9).replace(",", "") for entry in entries[:MOST]]
    when = f"at {listing(begin)} s{' and later' * (len(entries) > MOST)}"
    often = f"{number(len(entries), 9)} times" if len(entries) > 1 else "once"
    long = " to ".join(dict.fromkeys(map(duration, ends)))
    return [
        f"The {words.reading} goes off {often} for {long}, by up to {largest}, and comes back ({when}): look at the "
        "rig and the sensor there. The noise holds some of it, so it is told too large."
    ]
