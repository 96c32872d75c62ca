"""A foreign clock: single wrong stamps are mended, and a clock that is wrong as a whole is refused."""

from pathlib import Path

import numpy as np

from ..ground.errors import BadInput
from ..ground.kinematics import Array
from ..run.table.file_lines import Where
from ..run.table.mended_time import far_moved

LEAP = 10.0  # usual steps: a single stamp at either end that stands apart by more was not sampled there


def mend_time(time_s: Array) -> tuple[Array, dict[str, int]]:
    """Time stamps that rise strictly, and how often each rule was needed.

    `backward_time_stamps`: where the clock falls back for good, all that follows is moved to one usual step after the
    sample before; a single stamp that falls back, or leaps ahead, is put between its neighbours.
    `repeated_time_stamps`: samples that share a stamp are spread evenly up to the next. `leaping_time_stamps`: the
    first or the last stamp, where it stands apart by ten usual steps and by more than any other gap, is moved to one
    usual step from its neighbour. No sample is dropped. In s, both of shape (samples,).
    """
    time_s = np.array(time_s)
    steps = np.diff(time_s)
    usual_s = float(np.median(steps[steps > 0])) if (steps > 0).any() else 1.0
    backward = repeated = 0
    for row in range(1, len(time_s)):
        if time_s[row] >= time_s[row - 1]:
            continue
        backward += 1
        if row + 1 < len(time_s) and time_s[row + 1] > time_s[row - 1]:
            time_s[row] = (time_s[row - 1] + time_s[row + 1]) / 2
        elif row > 1 and time_s[row] > time_s[row - 2]:
            time_s[row - 1] = (time_s[row - 2] + time_s[row]) / 2
        else:
            time_s[row:] += time_s[row - 1] + usual_s - time_s[row]
    _, first, count = np.unique(time_s, return_index=True, return_counts=True)
    for start, same in zip(first[count > 1], count[count > 1], strict=True):
        following = start + same
        gap_s = time_s[following] - time_s[start] if following < len(time_s) else same * usual_s
        gap_s = min(gap_s, same * usual_s) if gap_s > 2 * same * usual_s else gap_s  # a gap stays a gap
        time_s[start:following] += gap_s * np.arange(same) / same
        repeated += int(same) - 1
    steps, leaping = np.diff(time_s), 0
    for end, beside in ((0, 1), (-1, -2)) if len(steps) > 2 else ():
        if steps[end] > max(LEAP * usual_s, *np.delete(steps, end)):
            time_s[end] = time_s[beside] + np.sign(time_s[end] - time_s[beside]) * usual_s
            leaping += 1
    mended = {
        "backward_time_stamps": backward,
        "repeated_time_stamps": repeated,
        "leaping_time_stamps": leaping,
    }
    return time_s, {rule: times for rule, times in mended.items() if times}


def check_mended(before_s: Array, after_s: Array, file: Path, where: Where) -> None:
    """Raise BadInput where mending moved over 1 % of the stamps by ten usual steps: the clock itself was wrong.

    Both in s, of shape (samples,). `where` says where a row stands.
    """
    usual_s = float(np.median(np.abs(np.diff(before_s))))
    moved = np.abs(after_s - before_s) > LEAP * usual_s
    if far_moved(int(moved.sum()), len(moved)):
        row = int(np.argmax(moved))
        problem = f"falls back or leaps near {where(row)}, which only moving {int(moved.sum())} stamps would mend"
        mend = "correct the stamps there, or cut the recording where its clock begins anew"
        raise BadInput(file, "time_s", problem, mend)
