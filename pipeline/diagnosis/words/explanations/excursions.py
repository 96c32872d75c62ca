"""Where the reading goes off for a while and comes back, in words."""

from ...document.content import Verdict
from ...document.evidence import Excursion
from ...document.made_keys import amount, amount_or_none
from ..language.quantity import duration, listing, number, size
from ..language.vocabulary import Vocabulary

MOST = 4  # that are named by when they begin


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """One line on all excursions; nothing where there are none."""
    entries = _entries(content)
    if not entries:
        return []
    ends = [min(entry["lasts_s"] for entry in entries), max(entry["lasts_s"] for entry in entries)]
    largest = size(max(amount(entry, f"size_{words.ending}") for entry in entries), words.unit)
    long = " to ".join(dict.fromkeys(map(duration, ends)))
    between = amount_or_none(content["evidence"], f"between_{words.ending}")
    apart = f": outside of {'them' if len(entries) > 1 else 'it'} calibration leaves {{}} rms, noise and all"
    return [
        f"The {words.reading} goes off {_often(entries)} for {long}, by up to {largest}, and comes back "
        f"({_when(entries)}). The noise holds some of it, so it is told too large"
        f"{'' if between is None else apart.format(size(between, words.unit))}."
    ]


def in_short(content: Verdict, words: Vocabulary) -> str:
    """Says that the reading goes off, as a sentence without a full stop; nothing where it does not."""
    entries = _entries(content)
    return f"the {words.reading} goes off {_often(entries)} and comes back" if entries else ""


def step(content: Verdict, words: Vocabulary) -> list[list[str]]:
    """The step to take because of excursions; nothing where there are none."""
    entries = _entries(content)
    if not entries:
        return []
    look = f"Look at the rig and at the sensor {_when(entries)} of the recording, where the {words.reading} goes off"
    return [[f"{look}. Record again without that, and diagnose again: it bends dimensions, too."]]


def _entries(content: Verdict) -> list[Excursion]:
    entries: list[Excursion] = content["evidence"].get("excursions", [])
    return entries


def _often(entries: list[Excursion]) -> str:
    return f"{number(len(entries), 9)} times" if len(entries) > 1 else "once"


def _when(entries: list[Excursion]) -> str:
    begin = [number(round(entry["at_s"]), 9).replace(",", "") for entry in entries[:MOST]]
    return f"at {listing(begin)} s{' and later' * (len(entries) > MOST)}"
