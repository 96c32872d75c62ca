"""The loads, speeds, holds and rests of a recording, and whether tests and runs need more."""

import itertools

from ...document.content import Verdict, proposal
from ..language.quantity import duration, ends, listing, number, quantity, times
from ..language.vocabulary import Vocabulary
from ..measured import other_load
from ..named.missing_signs import ALIKE
from . import second_load

ANY = "at another speed, under another load and with pauses"  # where an older file does not say what was recorded
PAUSE_S = 1.0  # a shorter stand is none
NEW = 0.1  # of a speed or a load: what leaves the recorded ones by less is none


def lines(content: Verdict, words: Vocabulary, tests: list[str]) -> list[str]:
    """The loads, speeds, holds and rests of this recording, and whether the `tests` need more.

    Nothing where an older file does not say it.
    """
    covered = content["evidence"].get("covered")
    if covered is None:
        return []
    (least, most), (slow, fast) = covered["load"], covered["speed_per_s"]
    few = other_load.only_in(content)
    loads = (
        f"loads of {number(least)} to {quantity(most, words.load_unit)}"
        if content["evidence"]["loaded"]
        else "one load" + f" but for {few} ({other_load.size(content, words)})" * bool(few)
    )
    speeds = f"speeds of {number(slow)} to {quantity(fast, f'{words.motion_unit}/s')}"
    if fast < ALIKE * slow:
        speeds = f"one speed, {quantity(fast, f'{words.motion_unit}/s')}"
    stands = f"{_stands('holds', covered['longest_hold_s'])} and {_stands('rests', covered['longest_rest_s'])}"
    least = min([least, *content["evidence"].get("other_load", {"load": []})["load"]])
    more = " or more" if content["evidence"]["loaded"] or few else ""
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


def asks_speed(content: Verdict, words: Vocabulary) -> bool:
    """Whether the run moves at a speed that was not recorded; by its title where an older file does not say."""
    run, covered = proposal(content), content["evidence"].get("covered")
    if covered is None or "speed" not in run["title"]:
        return "speed" in run["title"]
    slow, fast = covered["speed_per_s"]
    places = [leg[words.driver] for leg in run["legs"]]
    ways = zip(itertools.pairwise(places), run["legs"][1:], strict=True)
    speeds = [abs(to - at) / leg["seconds"] for (at, to), leg in ways if to != at]
    return not all((1.0 - NEW) * slow <= speed <= (1.0 + NEW) * fast for speed in speeds)


def asks_load(content: Verdict, words: Vocabulary) -> bool:
    """Whether the run hangs more than was recorded; True where an older file does not say."""
    run, covered = proposal(content), content["evidence"].get("covered")
    loads = [leg.get(words.load) for leg in run["legs"]] if words.load else []
    hung = [float(load) for load in loads if load is not None]
    return covered is None or not hung or max(hung) > (1.0 + NEW) * covered["load"][1]


def _stands(called: str, longest_s: float) -> str:
    """How long the motor stood at most, in holds or in rests."""
    longest = duration(longest_s)
    return f"no {called}" if longest == duration(0.0) else f"{called} of up to {longest}"


def not_yet(content: Verdict, words: Vocabulary) -> str:
    """What the recording lacks: a second speed, a second load, pauses; if nothing, values beyond the recorded ones."""
    covered = content["evidence"].get("covered")
    if covered is None:
        return ANY if words.load is not None else "at another speed and with pauses"
    slow, fast = covered["speed_per_s"]
    pause_s = max(covered["longest_hold_s"], covered["longest_rest_s"])
    lacking = ["at another speed"] * (fast < ALIKE * slow)
    other = f"with more strokes under {other_load.size(content, words)}"
    other = other if other_load.only_in(content) else "under another load"
    lacking += [other] * (words.load is not None and not content["evidence"]["loaded"])
    lacking += ["with pauses"] * (pause_s < PAUSE_S)
    if lacking:
        return listing(lacking)
    has = [f"speeds of {ends(slow, fast, f'{words.motion_unit}/s', 2)}"]
    least, most = covered["load"]
    has += [f"loads of {ends(least, most, words.load_unit, 2)}"] * (words.load is not None)
    has += [f"pauses of up to {duration(pause_s)}"]
    return f"beyond what it has, as far as it bears that ({listing(has)})"
