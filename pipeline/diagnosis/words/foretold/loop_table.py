"""The answer of a planned motion halfway through each stroke, where a loop shows, and at the start of each stroke."""

from dataclasses import dataclass

import numpy as np
import pandas as pd

from ....ground.kinematics import Array
from ....run.planned_motion.motion_course import Mask
from ....run.turning import turning_points
from ..language.quantity import listing, number, percent, said_unit, to_the_band
from ..language.text_table import aligned
from ..language.vocabulary import Vocabulary
from .prediction import AFTER_RECORDING, OUTSIDE

SHARES = (0.25, 0.5, 0.75)  # of the way of a stroke
REVERSAL = 0.1  # of the plan's range: a smaller way back is no stroke
FINEST = 3  # decimals of readings that a difference beside them may ask for
ALIKE, AT = 1e-4, 0.01  # of the reading's range: strokes that differ by less are the same; of the motion's: one place
DIGITS, FAR_DIGITS = 6, 4  # of a reading: within what was recorded its hundredths count, outside it is a guess
OF_EFFECTS = "loop without the acceleration"  # of a rig whose reading follows it, which differs on both ways
MOST = 3  # strokes that differ; the others are counted
MOSTLY = 0.5  # of a difference between two readings: what the effects must do of it, to be its reason


@dataclass(frozen=True)
class _Stroke:
    """A way up and the way down after it, of a plan's rows `first` to `last`; each array of shape (shares,)."""

    first: int
    last: int
    motion: Array  # in the driver's unit
    up: Array  # the reading on each way, in its unit
    down: Array
    out: str  # how much of it is outside what was recorded, in words; empty for nothing
    half: float  # of the band, the least of its rows, in the reading's unit; 0 without one
    bare: Array  # by how much the way up is more than the way down without any effect, in the reading's unit

    def like(self, other: "_Stroke", least: float) -> bool:
        """Whether both strokes agree at the same places; `least` is the least difference, in the reading's unit."""
        same = np.allclose(self.motion, other.motion, rtol=AT, atol=0.0) and self.out == other.out
        gaps = np.abs(np.concatenate([self.up - other.up, self.down - other.down]))
        return bool(same and (gaps < least).all())


def _strokes(table: pd.DataFrame, words: Vocabulary, channel: str) -> list[_Stroke]:
    """The whole strokes of a plan, in order."""
    way, reading = table[words.driver].to_numpy(float), table[channel].to_numpy(float)
    out = table[OUTSIDE].to_numpy() == 1.0 if OUTSIDE in table else np.zeros(len(table), bool)
    ending = channel.rpartition("_")[2]
    bare = table.get(f"without_effects_{ending}", table[channel]).to_numpy(float)
    low, high = (table.get(f"{end}_{ending}", table[channel]).to_numpy(float) for end in ("low", "high"))
    half = np.nan_to_num(0.5 * (high - low))
    points, strokes = turning_points(way, REVERSAL * max(float(np.ptp(way)), 1e-12)), []
    for start, top, end in zip(points[:-2], points[1:-1], points[2:], strict=True):
        low, high = max(way[start], way[end]), way[top]
        if high <= low:
            continue
        motion = low + np.array(SHARES) * (high - low)
        up, down = _both_ways(motion, way, reading, start, top, end)
        rising, falling = _both_ways(motion, way, bare, start, top, end)
        far, half_widths = _outside(out[start : end + 1]), half[start : end + 1][half[start : end + 1] > 0.0]
        least = 0.0 if far else float(half_widths.min(initial=np.inf))
        known_half = least if np.isfinite(least) else 0.0
        strokes.append(_Stroke(int(start), int(end), motion, up, down, far, known_half, rising - falling))
    return strokes


def _both_ways(motion: Array, way: Array, reading: Array, start: int, top: int, end: int) -> tuple[Array, Array]:
    """A reading at some places of the motion on the way up, from row `start` to `top`, and on the way down to `end`.

    The places and both answers have the shape (places,), the others (samples,); motions in one unit, readings in one.
    """
    back, of_back = way[top : end + 1][::-1], reading[top : end + 1][::-1]
    up = np.interp(motion, np.maximum.accumulate(way[start : top + 1]), reading[start : top + 1])
    return up, np.interp(motion, np.maximum.accumulate(back), of_back)


def printed(table: pd.DataFrame, words: Vocabulary, channel: str, acting: str | None) -> list[str]:
    """The printed words on a plan's strokes: both ways, then why the first one begins differently.

    `acting` names the effects where the string is taken as it was before its first stroke, though one was recorded.
    """
    begins = [] if acting is None else of_starts(table, words, channel, acting)
    return [*lines(table, words, channel), *begins]


def lines(table: pd.DataFrame, words: Vocabulary, channel: str) -> list[str]:
    """Both ways of each stroke that differs from those before, and their difference; nothing without strokes.

    `channel` is the column of the reading.
    """
    least, kinds = ALIKE * float(np.ptp(table[channel])), list[tuple[_Stroke, list[str]]]()
    for count, stroke in enumerate(_strokes(table, words, channel), start=1):
        alike = [numbers for kind, numbers in kinds if stroke.like(kind, least)]
        if alike:
            alike[0].append(str(count))
        else:
            kinds.append((stroke, [str(count)]))
    if not kinds:
        return []
    (up, down), places = words.ways, _decimals([stroke for stroke, _ in kinds[:MOST]], words.unit)
    of_effects = [OF_EFFECTS] * (words.differentiates and f"without_effects_{words.ending}" in table)
    rows = [["stroke", words.driver, f"{channel}, {up}", down, "difference", *of_effects]]
    for stroke, numbers in kinds[:MOST]:
        columns = (SHARES, stroke.motion, stroke.up, stroke.down, stroke.bare)
        for share, motion, rising, falling, bare in zip(*columns, strict=True):
            name = f"{_called(numbers)}{f' ({stroke.out})' if stroke.out else ''}" if share == SHARES[0] else ""
            ends = [f"{value:.{places}f}" for value in (rising, falling)]
            gaps = [rising - falling, *([rising - falling - bare] if of_effects else [])]
            rows.append([name, f"{motion:.4g}", *ends, *(_gap(gap, stroke.half, words.unit) for gap in gaps)])
    more = len(kinds) - MOST
    kinds_left = "1 more stroke that differs" if more == 1 else f"{more} more strokes that differ"
    not_shown = [f"{kinds_left} from these {'is' if more == 1 else 'are'} in the file"] if more > 0 else []
    without = "; the last column leaves out what the acceleration takes" if of_effects else ""
    head = f"on the way, where a loop shows (like strokes stand together; difference: {up} less {down}{without}):"
    return [head, *aligned(rows), *not_shown]


def _outside(out: Mask) -> str:
    """How much of a stroke's rows is outside what was recorded, in words; `out` is of shape (samples,)."""
    if not out.any():
        return ""
    return OUTSIDE if out.all() else f"{percent(float(out.mean()))} {OUTSIDE}"


def _decimals(strokes: list[_Stroke], unit: str) -> int:
    """The decimals of all readings in a table: as few as a band, or the digits of a reading, allow.

    As many as the differences beside them have, though no more than `FINEST`, or nobody could check these.
    """
    gaps = [_gap(float(gap), stroke.half, unit).split()[0] for stroke in strokes for gap in stroke.up - stroke.down]
    texts = [
        to_the_band(float(value), stroke.half, FAR_DIGITS if stroke.out else DIGITS)
        for stroke in strokes
        for value in (np.abs([stroke.up, stroke.down]).max(),)
    ]
    of_gaps = max(len(text.partition(".")[2]) for text in gaps)
    return max(min(len(text.partition(".")[2]) for text in texts), min(of_gaps, FINEST))


def _gap(gap: float, half: float, unit: str) -> str:
    """A difference in the unit of the readings beside it, to the band where there is one."""
    width = to_the_band(abs(gap), half) if half > 0.0 else number(abs(gap), whole=True)
    sign = "" if not width.strip("0.") else "-" if gap < 0.0 else "+"
    return f"{sign}{width} {said_unit(unit)}"


def _called(numbers: list[str]) -> str:
    """The strokes of one kind, by their numbers; of many strokes the first, and how many more."""
    return listing(numbers) if len(numbers) < 4 else f"{numbers[0]} and {len(numbers) - 1} more"


def of_starts(table: pd.DataFrame, words: Vocabulary, channel: str, acting: str) -> list[str]:
    """Why a plan's first stroke begins at another reading than the second, though at the same motion.

    `acting` names the effects; the string is taken as it was before its first stroke. `channel` is the reading's.
    """
    strokes = _strokes(table, words, channel)
    if len(strokes) < 2:
        return []
    (way, reading), places = (table[name].to_numpy(float) for name in (words.driver, channel)), [0, strokes[0].last]
    near = abs(np.subtract(*way[places])) <= AT * np.ptp(way)
    if not near or abs(np.subtract(*reading[places])) < ALIKE * np.ptp(reading):
        return []
    bare = table.get(f"without_effects_{channel.rpartition('_')[2]}", pd.Series(np.zeros(len(table)))).to_numpy(float)
    if abs(np.subtract(*(reading - bare)[places])) < MOSTLY * abs(np.subtract(*reading[places])):
        return []  # another acceleration, such as a plan has that begins in motion, is no trace of an effect
    first, second = (f"{value:.6g} {words.unit}" for value in reading[places])
    return [
        f"stroke 1 begins at {first} and stroke 2 at {second}: the {words.string} is taken as it was before its first "
        f"stroke, and stroke 1 leaves its trace in it ({acting}). With {AFTER_RECORDING} the plan begins with the "
        f"{words.string} as the recording left it"
    ]
