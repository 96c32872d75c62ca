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
    if whole == 1:
        (entry,) = entries
        alone = f"the single sample at {_at(entry)} stands far from its neighbours"
        return [f"A spike of {_channel(entry, words, several)} does not count: {alone}."]
    each = listing([f"{_many(entry, whole)}of {_of(entry, words, several)}" for entry in entries])
    far = "single samples that stand far from their neighbours"
    return [f"{number(whole, 9)} spikes do not count, {far}, {each}."]


def _of(entry: Part, words: Vocabulary, several: bool) -> str:
    """The spikes of one channel with the time stamp of the first."""
    first = "the first " if entry["count"] > 1 else ""
    return f"{_channel(entry, words, several)} ({first}at {_at(entry)})"


def _channel(entry: Part, words: Vocabulary, several: bool) -> str:
    """The channel of some spikes; `several`: the runs are more than one, and are named."""
    called = {words.driver: words.motion, words.load: "load"}.get(entry["column"], words.reading)
    inside = f" in {entry['run']}" if several else ""
    return f"the {called}{inside}"


def _at(entry: Part) -> str:
    """The time stamp of the first spike of an entry, to a hundredth of a second."""
    return f"{number(round(entry['first_s'], 2), 12).replace(',', '')} s"


def _many(entry: Part, whole: int) -> str:
    """How many of the spikes are of this channel."""
    return "all " if entry["count"] == whole else f"{number(entry['count'], 9)} "
