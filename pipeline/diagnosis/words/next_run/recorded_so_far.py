"""What a recording holds of loads, speeds, holds and rests, and whether its tests have what they ask for."""

from ...document.content import Verdict
from ..language.quantity import duration, number, quantity, times
from ..language.vocabulary import Vocabulary
from ..named.missing_signs import ALIKE
from . import second_load


def lines(content: Verdict, words: Vocabulary, tests: list[str]) -> list[str]:
    """What this recording holds of loads, speeds, holds and rests, and whether that is what `tests` ask for.

    Nothing where an older file does not say it.
    """
    known = content["evidence"].get("covered")
    if known is None:
        return []
    (least, most), (slow, fast) = known["load"], known["speed_per_s"]
    loads = (
        f"loads of {number(least)} to {quantity(most, words.load_unit)}"
        if content["evidence"]["loaded"]
        else "one load"
    )
    speeds = f"speeds of {number(slow)} to {quantity(fast, f'{words.motion_unit}/s')}"
    if fast < ALIKE * slow:
        speeds = f"one speed, {quantity(fast, f'{words.motion_unit}/s')}"
    stands = f"{_stands('holds', known['longest_hold_s'])} and {_stands('rests', known['longest_rest_s'])}"
    more = " or more" if content["evidence"]["loaded"] else ""
    under = f" under {quantity(least, words.load_unit)}{more}" if words.load is not None and least > 0.0 else ""
    wanted, counts = " ".join(tests), []
    if "speed" in wanted and fast > 0.0:
        other = f"{number(fast / 2.0)} or {quantity(2.0 * fast, f'{words.motion_unit}/s')}"
        two = f"It has two speeds: the fastest is {times(fast / slow)} times the slowest" if slow > 0.0 else ""
        counts.append(
            f"{two}." if two and fast >= ALIKE * slow else f"It has no second speed: {other}, half or twice, would do."
        )
    if "load" in wanted and words.load is not None and most > 0.0:
        counts.append(
            "It has more than one load." if content["evidence"]["loaded"] else second_load.sentence(content, words)
        )
    return [" ".join([f"Recorded so far: {loads}, {speeds}, {stands}{under}.", *counts])]


def _stands(called: str, longest_s: float) -> str:
    """How long the motor stood at most, in holds or in rests."""
    longest = duration(longest_s)
    return f"no {called}" if longest == duration(0.0) else f"{called} of up to {longest}"
