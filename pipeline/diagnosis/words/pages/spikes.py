"""Spikes of a recording, which do not count, in words: how many, in which channel, and when the first one is."""

from ...document.content import Verdict
from ...document.evidence import Spike
from ..language.quantity import listing, number
from ..language.vocabulary import Vocabulary


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """One sentence with the count and the first time of each channel; nothing where there is no spike."""
    entries: list[Spike] = content["evidence"].get("spikes", [])
    if not entries:
        return []
    several = len({entry["run"] for entry in entries}) > 1 or not isinstance(content["run"], str)
    whole = sum(entry["count"] for entry in entries)
    if whole == 1:
        (entry,) = entries
        return [f"1 single sample of {_channel(entry, words, several)} (a spike, at {_at(entry)}) was left out."]
    if len(entries) == 1:
        (entry,) = entries
        of_channel = f"of {_channel(entry, words, several)} (spikes, the first at {_at(entry)})"
        return [f"{number(whole, 9)} single samples {of_channel} were left out."]
    each = listing([f"{number(entry['count'], 9)} of {_of(entry, words, several)}" for entry in entries])
    return [f"{number(whole, 9)} single samples (spikes) were left out: {each}."]


def _of(entry: Spike, words: Vocabulary, several: bool) -> str:
    """The spikes of one channel with the time stamp of the first."""
    first = "the first " if entry["count"] > 1 else ""
    return f"{_channel(entry, words, several)} ({first}at {_at(entry)})"


def _channel(entry: Spike, words: Vocabulary, several: bool) -> str:
    """The channel of some spikes; `several`: the runs are more than one, and are named."""
    called = {words.driver: words.motion, words.load: "load"}.get(entry["column"], words.reading)
    inside = f" in {entry['run']}" if several else ""
    return f"the {called}{inside}"


def _at(entry: Spike) -> str:
    """The time stamp of the first spike of an entry, to a hundredth of a second."""
    return f"{number(round(entry['first_s'], 2), 12).replace(',', '')} s"
