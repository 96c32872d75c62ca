"""Spikes of a recording that do not count, in words: how many, of which channel, and where the first one is."""

from ...document.content import Part, Verdict
from ..language.quantity import listing, number
from ..language.vocabulary import Vocabulary


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """One sentence with the count and the first time of each channel; nothing where there is no spike."""
    entries: list[Part] = content["evidence"].get("spikes", [])
    if not entries:
        return []
    several = len({entry["run"] for entry in entries}) > 1 or not isinstance(content["run"], str)
    whole = sum(entry["count"] for entry in entries)
    each = listing([f"{_many(entry, whole)}of {_of(entry, words, several)}" for entry in entries])
    head = (
        "A spike was found, a single sample" if whole == 1 else f"{number(whole, 9)} spikes were found, single samples"
    )
    far = "stands far from its neighbours" if whole == 1 else "stand far from their neighbours"
    return [f"{head} that {far}: {each}. {'It does' if whole == 1 else 'They do'} not count."]


def _of(entry: Part, words: Vocabulary, several: bool) -> str:
    """The spikes of one channel of one run; `several`: the runs are more than one, and are named."""
    called = {words.driver: words.motion, words.load: "load"}.get(entry["column"], words.reading)
    inside = f" in {entry['run']}" if several else ""
    stamp = number(entry["first_s"], 7).replace(",", "")
    first = "the first " if entry["count"] > 1 else ""
    return f"the {called}{inside} ({first}at time_s = {stamp})"


def _many(entry: Part, whole: int) -> str:
    """How many of the spikes are of this channel; nothing of a lonely one."""
    return "" if whole == 1 else "all " if entry["count"] == whole else f"{number(entry['count'], 9)} "
