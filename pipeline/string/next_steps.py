"""The next steps after a recording: what the simulator leaves out, and the string's next run or its life."""

import shlex
from collections.abc import Container
from pathlib import Path

from ..ground.command import command
from ..ground.words.counts import counted
from ..run.copied_run import of_another_string
from ..run.folder import read_run
from ..run.next_command import following
from .same_string import next_name, others_recorded

DIAGNOSIS = 6  # strokes that a diagnosis needs at least, as docs/record.md says; a test holds it to that page
LIFE = 12  # strokes from which a forecast of a string's life is made; a test holds it to that program's own number


def next_steps(folder: Path, strokes: int | None, anew: bool = False, but: Container[Path] = ()) -> list[str]:
    """Lines, each with a command to paste, for a run that was recorded with so many strokes, None if nobody counted.

    Fewer than a diagnosis needs are said in place of its command. `anew`: the rig's next recording is of another
    string, as those of the synthetic rig are that keeps none. No run of `but`, whose paths are resolved, is named:
    those cannot be read. Raises BadInput.
    """
    run = read_run(folder)
    others = [other for other in others_recorded(folder, run) if other.resolve() not in but]
    lines = following(folder, recorded=True, others=others)
    if run.string is None:
        return lines
    if not others and strokes is not None and strokes < DIAGNOSIS:
        needs = f"a diagnosis needs at least {DIAGNOSIS} to 8, with holds (docs/record.md)"
        more = "let a recording go on for longer" if anew else "record more of this rig"
        lines = [f"Next: {more}: {counted(strokes, 'stroke')} so far, and {needs}"]
    if others or (strokes or 0) >= LIFE:
        runs = " ".join(shlex.quote(str(each)) for each in (*others, folder))
        lines.append(f"Next: ask how long the string lasts by: {command('lifespan')} {runs} --out reports/mine")
    elif anew:
        other = f"{of_another_string(folder, next_name(folder))}, then record into it"
        lines.append(f"Next: this rig's next recording is of another string (rig --standing keeps one string): {other}")
    else:
        again = f"{command('new_run')} {next_name(folder)} --like {shlex.quote(str(folder))}"
        lines.append(f"Next: for another recording of this string: {again}, then record into it")
    return lines
