"""The next recording as a recipe: number of strokes, load, speed, holds and rests."""

from ...document.content import Verdict
from ...document.made_keys import extent
from ...mechanisms.library import mechanisms
from ..language.quantity import at, duration, ends, quantity, span
from ..language.vocabulary import Vocabulary
from ..named.missing_signs import missing
from . import second_load

SO = "So record: "
FEWEST = 4  # strokes: of fewer a diagnosis leaves none out


def load(content: Verdict, words: Vocabulary, ids: list[str]) -> float | None:
    """The load of the next recording, if it differs from the recorded one; else None."""
    covered = content["evidence"].get("covered")
    if covered is None or _lasting(content, ids) or "load" not in _lacking(content, words, ids):
        return None
    chosen = second_load.best(content, words)
    share = chosen[0] if chosen and chosen[1] >= 1.0 else second_load.begun(content)
    return float(f"{share * second_load.base(content):.2g}")


def shows(content: Verdict, words: Vocabulary, ids: list[str]) -> set[str] | None:
    """Which foretold numbers its recording will show, by their keys; None where it has no recording to make.

    Under another load the loop under that load alone: at another speed it was foretold under the recorded one.
    """
    if not sentence(content, words, ids):
        return None
    new_load = load(content, words, ids)
    if new_load is not None:
        more = new_load > second_load.base(content)
        return {second_load.ROWS[second_load.TWICE if more else second_load.HALF]}
    slower = {"loop_half_speed"} if "speed" in _lacking(content, words, ids) else set()
    strokes = {"hold", "rest"} if _lasting(content, ids) else {"top"}  # a hold of the first stroke moves later tops
    return {"loop_as_before"} | slower | strokes


def to_type(content: Verdict, words: Vocabulary, ids: list[str]) -> str:
    """The load for `--load-n`; empty where it stays, or where a column of the recording holds it."""
    new_load, covered = load(content, words, ids), content["evidence"].get("covered")
    if new_load is None or covered is None or not words.twisted or covered["load"][0] != covered["load"][1]:
        return ""
    return f"{new_load:g}"


def sentence(content: Verdict, words: Vocabulary, ids: list[str], loads: str = "") -> str:
    """The recording for the tests of the effects `ids`; nothing where these need no new load, speed, hold or rest.

    `loads`: those in words under one of which it is better made, if the rig bears it.
    """
    covered, lacking = content["evidence"].get("covered"), _lacking(content, words, ids)
    lasting = _lasting(content, ids)
    if covered is None or not words.twisted or not (lacking or lasting):
        return ""
    (first, last), (low, high) = content["evidence"]["strokes"], extent(content["evidence"], words.driver)
    runs = 1 if isinstance(content["run"], str) else len(content["run"])
    count, (slow, fast) = max((last - first + 1) // runs, FEWEST), covered["speed_per_s"]
    top, bottom = (at(end, words.motion_unit, high - low) for end in (high, low))
    new_load = load(content, words, ids)
    before = quantity(second_load.base(content), words.load_unit)
    under = f" under {before}" if words.load is not None and covered["load"][1] > 0.0 else ""
    if new_load is not None:  # strokes as before, but for this
        other = "all of them under" if content["evidence"]["loaded"] else "under"
        instead = "" if content["evidence"]["loaded"] else f" in place of {before}"
        under = f", but {other} {quantity(new_load, words.load_unit)}{instead}"
    elif loads and under:
        under = f", under {loads} in place of {before} if the rig bears it"
    speed = ends(slow, fast, f"{words.motion_unit}/s", 2)
    if "speed" in lacking:
        usual, half = (quantity(each, f"{words.motion_unit}/s") for each in (fast, fast / 2.0))
        speed = f"{usual}, then as many at {half}"
    if lasting:
        stand = duration(lasting)
        still = f", and in the first one hold {stand} at {top} and rest {stand} at {bottom} after it"
    else:
        stood = covered["longest_hold_s"] > 0.0 or covered["longest_rest_s"] > 0.0
        still = ", with the same holds and rests" * stood
    turned = span(low, high, words.motion_unit, high - low)
    as_before = f"{turned}{under}"
    if new_load is None and content["evidence"]["loaded"]:
        (least, most), unit = covered["load"], words.load_unit
        as_before = f"each with the twist and the load that it had (within {turned} and {ends(least, most, unit, 2)})"
    return f"{SO}{count} strokes as before, {as_before}, at {speed}{still}."


def _lasting(content: Verdict, ids: list[str]) -> float:
    """How long to hold and to rest for an effect that goes on at rest, in s; 0 if unknown or if none does."""
    stand_s = (content["evidence"].get("expected") or {}).get("stand_s")
    return float(stand_s or 0.0) if any(mechanisms()[id_].acts_at_rest for id_ in ids) else 0.0


def _lacking(content: Verdict, words: Vocabulary, ids: list[str]) -> set[str]:
    return {what for id_ in ids for what in missing(content, words, id_)}
