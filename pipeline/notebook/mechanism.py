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
    it adds to the prediction, in the unit of the predicted channel. `parameters`: all numbers of its formula by name,
    each in its own `unit`: those that were `fitted`, and the `constants`. `sentence`: what it does, in words.
    """

    id: str
    confidence: float
    size: Interval
    parameters: dict[str, Interval]
    sentence: str

    @property
    def fitted(self) -> dict[str, Interval]:
        """Those of the parameters that were fitted to the recording: each has an interval of some width."""
        return {name: each for name, each in self.parameters.items() if _has_width(each)}

    @property
    def constants(self) -> dict[str, Interval]:
        """Those of the parameters that stood still in the fit: `low` and `high` are the value.

        They are known beforehand, such as a usual speed, or chosen from a few values, such as a time constant.
        """
        return {name: each for name, each in self.parameters.items() if not _has_width(each)}


def interval(entry: Mapping[str, object], unit: str = "") -> Interval:
    """An interval as a diagnosis writes it, in its own unit or else in `unit`."""
    low, high = amount_or_none(entry, "low"), amount_or_none(entry, "high")
    return Interval(amount(entry, "value"), low, high, str(entry.get("unit", unit)))


def _has_width(number: Interval) -> bool:
    """Whether a number's interval is wider than the number."""
    return number.low is not None and number.high is not None and number.low < number.high
