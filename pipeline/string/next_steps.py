"""The next steps after a recording: what the simulator leaves out, and the string's next run or its life."""

import shlex
from collections.abc import Sequence
from pathlib import Path

from ..ground.command import command
from ..ground.words.counts import counted
from ..run.copied_run import of_another_string
from ..run.folder import read_run
from ..run.next_command import following
from .jumps_beside import Beside
from .same_string import next_name, others_recorded

DIAGNOSIS = 6  # strokes that a diagnosis needs at least, as docs/record.md says; a test holds it to that page
LIFE = 12  # strokes from which a forecast of a string's life is made; a test holds it to that program's own number


def next_steps(
    folder: Path,
    strokes: int | None,
    anew: bool = False,
    beside: Beside | None = None,
) -> list[str]:
    """Lines, each with a command to paste, for a run that was recorded with so many strokes, None if nobody counted.

    Fewer than a diagnosis needs are said in place of its command. What was read of the string's other runs, `beside`,
    counts their strokes too, and no run is named that could not be read. `anew`: the rig's next recording is of another
    string, as those of the synthetic rig are that keeps none. Raises BadInput.
    """
    run = read_run(folder)
    others = others_recorded(folder, run)
    in_all = _in_all(strokes, others, beside)
    others = [other for other in others if not beside or other.resolve() not in beside.unreadable]
    lines = following(folder, recorded=True, others=others)
    if run.string is None:
        return lines
    if in_all is not None and in_all < DIAGNOSIS:
        needs = f"a diagnosis needs at least {DIAGNOSIS} to 8, with holds (docs/record.md)"
        more = "let a recording go on for longer" if anew else "record more of this rig"
        lines = [f"Next: {more}: {counted(in_all, 'stroke')} so far, and {needs}"]
    if (others and in_all is None) or (in_all or 0) >= LIFE:
        runs = " ".join(shlex.quote(str(each)) for each in (*others, folder))
        lines.append(f"Next: ask how long the string lasts by: {command('lifespan')} {runs} --out reports/mine")
    elif anew:
        other = f"{of_another_string(folder, next_name(folder))}, then record into it"
        lines.append(f"Next: this rig's next recording is of another string (rig --standing keeps one string): {other}")
    else:
        again = f"{command('new_run')} {next_name(folder)} --like {shlex.quote(str(folder))}"
        lines.append(f"Next: for another recording of this string: {again}, then record into it")
    return lines


def _in_all(strokes: int | None, others: Sequence[Path], beside: Beside | None) -> int | None:
    """The strokes of a run and those of the string's other runs; None where nobody has counted one of them.

    As soon as they are enough for each of the steps no further run is read. One that cannot be read has none to use.
    """
    if strokes is None or (others and beside is None):
        return None
    for other in others:
        if strokes >= LIFE or beside is None:
            break
        rests = beside.at(other)
        strokes += rests.strokes if rests else 0
    return strokes
