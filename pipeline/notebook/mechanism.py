"""What a diagnosis names, as objects: an effect, and a number with its interval."""

from collections.abc import Mapping
from dataclasses import dataclass

from ..diagnosis.document.made_keys import amount, amount_or_none


@dataclass(frozen=True)
class Interval:
    """A number with its 90 % interval.

    `value`: the number. `low`, `high`: the ends of the interval; None where none is told. `unit`: the unit of all
    three, "" for a share or a count.
    """

    value: float
    low: float | None = None
    high: float | None = None
    unit: str = ""


@dataclass(frozen=True)
class Mechanism:
    """One effect that the diagnosis names.

    `id`: its name in the library. `confidence`: the probability that it is there, from 0 to 1. `size`: the rms of what
    it adds to the prediction, in the unit of the predicted channel. `parameters`: its coefficients by name, each in its
    own `unit`. `sentence`: what it does, in words.
    """

    id: str
    confidence: float
    size: Interval
    parameters: dict[str, Interval]
    sentence: str


def interval(entry: Mapping[str, object], unit: str = "") -> Interval:
    """An interval as a diagnosis writes it, in its own unit or else in `unit`."""
    low, high = amount_or_none(entry, "low"), amount_or_none(entry, "high")
    return Interval(amount(entry, "value"), low, high, str(entry.get("unit", unit)))
