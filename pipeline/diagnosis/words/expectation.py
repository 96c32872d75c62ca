"""What each explanation foretells of strokes that nobody made, as a table: at the rig a person sees which is right."""

from ..content import Part, Verdict
from . import rivals, unseen
from .error_table import UNKNOWN, aligned
from .quantity import at, duration, number, percent, quantity, size
from .sections import WIDE
from .vocabulary import Vocabulary

SEEN = 2.0  # noise floors, from which a person sees a change in one stroke
NOT = "hardly"  # what nobody would see
LEAST = 0.01  # of a probability: of less the name alone is said
INDENT = 5  # of the table on the page


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """The table, a line each row, then how to read it; nothing where nobody would see a number of it.

    An explanation that lacks a part of the best one comes before those that add to it: columns may not fit.
    """
    known = content["evidence"].get("expected")
    if not known:
        return []
    first, *others = known["explanations"]
    compared = [first, *sorted(others, key=lambda explanation: set(first["ids"]) <= set(explanation["ids"]))]
    limit = SEEN * content["evidence"][f"floor_{words.ending}"]
    rows = []
    for key, name in _rows(content, known, words).items():
        values = [explanation.get(f"{key}_{words.ending}") for explanation in compared]
        if values[0] is not None and any(value is not None and abs(value) >= limit for value in values):
            rows.append([name, *(_cell(key, value, limit, words) for value in values)])
    if not rows:
        return []
    shared = set.intersection(*(set(explanation["ids"]) for explanation in compared))
    heads = [_head(content, explanation["ids"], shared) for explanation in compared]
    up, down = words.ways
    loop = f"The loop is by how much {up} and {down} part at most at one {words.motion}."
    error = size(_error(content, words), words.unit)
    return [
        *_fitting([["What to expect of", *heads], *rows]),
        *([loop] if any(row[0].startswith("the loop") for row in rows) else []),
        *([f"{UNKNOWN}: this explanation foretells no such number."] if any(UNKNOWN in row for row in rows) else []),
        f"Differences of less than {error} tell nothing: the simulator errs by as much.",
    ]


def _fitting(rows: list[list[str]]) -> list[str]:
    """The rows under each other, without the last columns where those do not fit on the page."""
    table = aligned(rows)
    while max(map(len, table)) > WIDE - INDENT and len(rows[0]) > 2:
        rows = [row[:-1] for row in rows]
        table = aligned(rows)
    return table


def _rows(content: Verdict, known: Part, words: Vocabulary) -> dict[str, str]:
    """What each number is of, by its key."""
    low, high = content["evidence"][words.driver]
    top, bottom = (at(end, words.motion_unit, high - low) for end in (high, low))
    hung = words.load is not None and known["load"]
    full, half = (f" under {quantity(share * known['load'], words.load_unit, 3)}" * bool(hung) for share in (1.0, 0.5))
    speed = f"{number(known['speed_per_s'] / 2.0, 3)} {words.motion_unit}/s"
    rows = {
        "loop_as_before": f"the loop of a stroke as before{full}",
        "loop_half_speed": f"the loop at half the speed, {speed}",
        "loop_half_load": f"the loop{half}",
    }
    if "strokes" in known:
        rows["top"] = f"change at {top}, from the next stroke to the {known['strokes']}th"
    if "stand_s" in known:
        stand = duration(known["stand_s"])
        rows["hold"] = f"change in a hold of {stand} at {top}{full}"
        rows["rest"] = f"change in a rest of {stand} at {bottom} after it"
    return rows


def _cell(key: str, value: float | None, limit: float, words: Vocabulary) -> str:
    if value is None:
        return UNKNOWN
    if abs(value) < limit:
        return NOT
    return f"{'' if key.startswith('loop') else '+' if value > 0.0 else '-'}{size(abs(value), words.unit)}"


def _head(content: Verdict, ids: list[str], shared: set[str]) -> str:
    """An explanation with its probability; without what all explanations share, where something is left then."""
    held = [each for each in content["evidence"]["explanations"] if set(each["ids"]) == set(ids)]
    share = held[0].get("probability") if held else None
    own = rivals.called([id_ for id_ in ids if id_ not in shared] or ids)
    return f"{own} ({percent(share)})" if share is not None and share >= LEAST else own


def _error(content: Verdict, words: Vocabulary) -> float:
    """What the explained simulator errs by on strokes that no fit has seen, or the noise."""
    noise, held = content["fit"][f"noise_floor_{words.ending}"], unseen.errors(content, words)
    return float(max(held[2], noise) if held else noise)
