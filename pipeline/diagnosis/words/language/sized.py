"""A size in words with the ends of its 90 % interval, with one more digit where two would make them look alike."""

from .quantity import NEAR_0, of_column, quantity
from .vocabulary import Vocabulary


def span(low: float, high: float, words: Vocabulary) -> str:
    """An interval of a size: `0 to 0.40 mm`."""
    return sized(low, low, high, words)[1]


def sized(value: float, low: float, high: float, words: Vocabulary) -> tuple[str, str]:
    """A size and its interval: `15 N` and `14 to 16 N`; with a digit more where an end would read as the value.

    Its two ends have one unit, and a lower end that is nearly 0 beside the upper one is 0.
    """
    low = 0.0 if 0.0 < low < NEAR_0 * high else low
    for digits in (2, 3):
        own, most = (quantity(each, words.unit, digits, whole=True) for each in (value, high))
        least = of_column(low, words.unit, high, digits)
        if not low < value < high or own not in (least, most):
            break
    return own, f"{least.removesuffix(most[most.find(' ') :])} to {most}"
