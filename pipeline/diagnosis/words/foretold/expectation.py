"""What each explanation foretells of strokes not made yet, as a table: a person at the rig sees which one is right."""

import re

from ....ground.words.wrapped_lines import WIDE
from ...document.content import Verdict
from ...document.expected import Expected, ExpectedExplanation
from ...document.made_keys import amount, extent
from ..language.quantity import at, duration, listing, plus_minus, quantity, size
from ..language.text_table import UNKNOWN, aligned
from ..language.vocabulary import Vocabulary
from . import columns_of, recorded_evidence, slow_sign
from .foretold_numbers import Number, compared, error, of_explanation, tells

SEEN = 2.0  # noise floors, from which a person sees a change in one stroke
NOT = "hardly"  # what nobody would see
AT_ONCE = (
    "Changes hold for a run that follows this recording at once. After a long rest a slow effect can begin anew, and "
    "they can be otherwise."
)
STAND = ("change in a hold", "change in a rest")  # rows
NO_NUMBER = (
    "No number of one stroke, hold or rest tells the explanations apart: each foretells the same within its plus-minus."
)
INDENT = 5  # of the table on the page


def lines(content: Verdict, words: Vocabulary, shown: set[str] | None = None) -> list[str]:
    """The table, a line each row, and how to read it; nothing where no difference would be visible.

    `shown`: the keys of the numbers that the recording to make will show; None: of all that are foretold.

    The rivals come in the order of their probability: all that are kept, else without those that the recorded loop
    excludes. The row that tells most comes first. A row in which the explanations differ by less than their intervals
    is left out, unless all do: then the best explanation stands alone. What a hold and a rest show is said in words
    where no row has it.
    """
    expected = content["evidence"].get("expected")
    if not expected:
        return []
    weighed, out = compared(content), recorded_evidence.excluded(content, words)
    kept = columns_of.kept(content)
    first, *others = [each for each in weighed if each not in out or set(each["ids"]) in kept]
    tables = []
    widths = [([first, *others], bare) for bare in (False, True) if not bare or content["verdict"] == "ambiguous"]
    for columns, bare in (*widths, *(([first, other], False) for other in others), ([first], False)):
        table, remarks, parted = _table(content, expected, columns, words, shown, bare)
        if max(map(len, table), default=0) <= WIDE - INDENT:  # what does not fit on the page cannot tell either
            tables.append(([*table, *remarks], parted))
            if parted:
                break
    best = next((table for table, parted in tables if parted), tables[0][0] if tables else [])
    if others and content["verdict"] == "ambiguous" and best[-1:] == [NO_NUMBER]:
        seen = recorded_evidence.lines(content, words)
        whole = slow_sign.of_whole_run(content)
        return [*whole, *seen] if whole else [NO_NUMBER, *seen, *slow_sign.lines(content, words, weighed)]
    stands = any(parted for _, parted in tables) and any(line.startswith(STAND) for line in best)
    sign = [] if stands or not best else slow_sign.lines(content, words, weighed)
    return [*best, *(columns_of.not_in(content) if best else []), *recorded_evidence.lines(content, words), *sign]


def tells_nothing(numbers: list[str]) -> bool:
    """Whether lines of this table say that neither a number nor a hold and a rest tell the explanations apart."""
    return NO_NUMBER in numbers and any(map(slow_sign.is_untelling, numbers))


def _table(
    content: Verdict,
    expected: Expected,
    columns: list[ExpectedExplanation],
    words: Vocabulary,
    shown: set[str] | None,
    bare: bool = False,
) -> tuple[list[str], list[str], bool]:
    """The table of some explanations, how to read it, and whether a row tells them apart.

    Nothing where nobody would see a number of it. `bare`: the columns have numbers, which are said below it.
    """
    limit = SEEN * amount(content["evidence"], f"floor_{words.ending}")
    names = {key: row for key, row in _rows(content, expected, words).items() if shown is None or key in shown}
    cells = {key: [of_explanation(each, key, content, words) for each in columns] for key in names}
    seen = {key: any(cell is not None and abs(cell.value) >= limit for cell in row) for key, row in cells.items()}
    keys = [key for key, row in cells.items() if row[0] is not None and seen[key]]
    if not keys:
        return [], [], False
    telling = {key: ratio for key in keys if (ratio := tells(cells[key])) is not None}
    nothing = [key for key, ratio in telling.items() if ratio < 1.0]
    alone = bool(nothing) and len(nothing) == len(telling)
    if alone:
        columns, cells = columns[:1], {key: cells[key][:1] for key in keys}
    else:
        keys = sorted((key for key in keys if key not in nothing), key=lambda key: -telling.get(key, 0.0))
    known_spread = any(cell is not None and cell.known for key in keys for cell in cells[key])
    shared = set.intersection(*(set(explanation["ids"]) for explanation in columns))
    named = [columns_of.head(content, explanation["ids"], shared) for explanation in columns]
    heads = [f"({number})" for number in range(1, len(named) + 1)] if bare else named
    below = [f"{'; '.join(f'{number} {name}' for number, name in zip(heads, named, strict=True))}."] if bare else []
    only = "Only the first is kept: the others are less likely."
    less = len(columns) > 1 and content["verdict"] == "explained"
    rows = [[names[key], *(_cell(key, cell, limit, words) for cell in cells[key])] for key in keys]
    cut = [id_ for id_ in columns[0]["ids"] if id_ in shared and any(name.startswith("with ") for name in named)]
    both = "Both" if len(columns) == 2 else "All"
    reading = [
        *below,
        *([only] if less else []),
        *([f"{both} have {listing(cut)} as well."] if cut else []),
        *([_loop(words)] if any(map(_is_loop, keys)) else []),
        *([f"{UNKNOWN}: this explanation foretells no such number."] if any(UNKNOWN in row for row in rows) else []),
        *([_spread(keys)] if known_spread else []),
        *([AT_ONCE] if not all(map(_is_loop, keys)) else []),
    ]
    untelling = _untelling(
        alone, [names[key] for key in nothing], known_spread, size(error(content, words), words.unit)
    )
    remarks = [line for line in (" ".join(reading), *untelling) if line]
    against = _against(names, cells, keys, words) if len(columns) == 1 and content["verdict"] == "explained" else ""
    if against:
        remarks = [*(line for line in remarks if line != NO_NUMBER), against]
    return aligned([["What to expect of", *heads], *rows]), remarks, bool(telling) and not alone


def _against(names: dict[str, str], cells: dict[str, list[Number | None]], keys: list[str], words: Vocabulary) -> str:
    """Which loops would speak against the one explanation in the table; nothing where no loop has a plus-minus."""
    outside = []
    for key in keys:
        cell = cells[key][0]
        if cell is None or not cell.known or not _is_loop(key):
            continue
        value, _, rest = plus_minus(cell.value, cell.half_width, words.unit).replace(",", "").partition(" ± ")
        half, _, unit = rest.partition(" ")
        places = len(half.partition(".")[2])
        low, high = (f"{max(float(value) + way * float(half), 0.0):,.{places}f}" for way in (-1.0, 1.0))
        outside.append(f"{names[key]}, outside {low} to {high} {unit}")
    return f"Speaks against the name: {'; '.join(outside)}." if outside else ""


def _loop(words: Vocabulary) -> str:
    up, down = words.ways
    return f"The loop is by how much {up} and {down} differ at most at one {words.motion}."


def _spread(keys: list[str]) -> str:
    """What the plus-minus holds, and how often it did in tests."""
    loops, slow = any(map(_is_loop, keys)), not all(map(_is_loop, keys))
    shares = ["nine of ten loops"] * loops + ["eight of ten changes in holds, rests and more strokes"] * slow
    return f"±: in tests {listing(shares)} lay inside if the explanation was right."


def _untelling(alone: bool, left_out: list[str], known_spread: bool, error: str) -> list[str]:
    """What tells nothing apart: rows that were left out, all other explanations, or differences in an older file."""
    older = [] if known_spread else [f"Differences of less than {error} tell nothing: the simulator errs by as much."]
    if alone:
        return [*older, NO_NUMBER]
    rows = "; ".join(left_out)
    return [*older, *([f"Left out, since the explanations differ there by less than their ±: {rows}."] if rows else [])]


def _is_loop(key: str) -> bool:
    return key.startswith("loop")


def _rows(content: Verdict, expected: Expected, words: Vocabulary) -> dict[str, str]:
    """What each number means, by its key."""
    low, high = extent(content["evidence"], words.driver)
    top, bottom = (at(end, words.motion_unit, high - low) for end in (high, low))
    hung = words.load is not None and expected["load"]
    full, half, twice = (
        f" under {quantity(share * expected['load'], words.load_unit)}" * bool(hung) for share in (1.0, 0.5, 2.0)
    )
    unit = f"{words.motion_unit}/s"
    slow, usual = (quantity(share * expected["speed_per_s"], unit) for share in (0.5, 1.0))
    rows = {
        **({} if "recorded" in expected else {"loop_as_before": f"the loop of a stroke as before{full}"}),
        "loop_half_speed": f"the loop at {slow}, half the usual speed of {usual}",
        "loop_half_load": f"the loop{half}",
        "loop_twice_load": f"the loop{twice}",
    }
    if "strokes" in expected:
        rows["top"] = f"change at {top}, from the next stroke to the {expected['strokes']}th"
    if "stand_s" in expected:
        stand = duration(expected["stand_s"])
        rows["hold"] = f"change in a hold of {stand} at {top}{full}"
        rows["rest"] = f"change in a rest of {stand} at {bottom} after it"
    return rows


def _cell(key: str, cell: Number | None, limit: float, words: Vocabulary) -> str:
    if cell is None:
        return UNKNOWN
    sign = "" if _is_loop(key) else "+" if cell.value > 0.0 else "-"
    if cell.known:
        text = plus_minus(abs(cell.value), cell.half_width, words.unit)
        return f"{sign if re.match('[0.,]*[1-9]', text) else ''}{text}"
    return NOT if abs(cell.value) < limit else f"{sign}{size(abs(cell.value), words.unit)}"
