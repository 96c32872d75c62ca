"""Runs of one string between which the zero was not compared, and why: a jump there stays unseen."""

from collections.abc import Iterator

from ..ground.words.jump_notes import NOT_COMPARED
from ..run.mend_command import tare_command
from .history import in_order
from .recovered import alike
from .rests import Rests
from .tare_notes import tare_notes
from .zero import change_mm, zeros

FEW = 3  # sentences on one string


def not_compared(runs: list[Rests]) -> list[str]:
    """A sentence for each run whose first rest cannot be compared with the last one of its string before it.

    None for a run of which `tare_notes` tells that already.
    """
    return [sentence for of_one in _strings(runs) for _, sentence in uncompared(of_one)]


def uncompared(of_one: list[Rests]) -> list[tuple[str, str]]:
    """The same for the runs of one string, in order of recording, each with the name of the run that begins so."""
    noted = {name for name, _ in tare_notes(of_one)}
    pairs = [(so_far[-1].run.run, so_far) for so_far in _pairs(of_one)]
    return [(name, _sentence(so_far)) for name, so_far in pairs if name not in noted]


def to_confirm(runs: list[Rests]) -> list[str]:
    """The same for the pages: of all but those whose run.yaml says `tare: run`; of many of one string the first few."""
    sentences = []
    for of_one in _strings(runs):
        pairs = [so_far for so_far in _pairs(of_one) if so_far[-1].run.tare != "run"]
        sentences += [_sentence(so_far) for so_far in pairs[:FEW]]
        if len(pairs) > FEW:
            more = f"{len(pairs) - FEW} more pairs of runs of string {of_one[0].run.string_id}"
            sentences.append(f"{NOT_COMPARED} {more}: the log of the dataset names them.")
    return sentences


def _strings(runs: list[Rests]) -> Iterator[list[Rests]]:
    """The runs of each string, in order of recording."""
    for string in sorted({rests.run.string_id for rests in runs}):
        yield in_order([rests for rests in runs if rests.run.string_id == string])


def _pairs(of_one: list[Rests]) -> list[list[Rests]]:
    """Of the runs of one string, each up to one whose first rest does not compare with the last one, if unchecked."""
    every = [of_one[: number + 1] for number in range(1, len(of_one)) if of_one[number].run.tare != "checked"]
    return [so_far for so_far in every if change_mm(*so_far[-2:]) is None]


def _sentence(so_far: list[Rests]) -> str:
    """Which runs, the last two of these, why, and what to do about it."""
    before, after = so_far[-2:]
    twists, loads = (before.turns[-1], after.turns[0]), (before.load_n[-1], after.load_n[0])
    last, first = f"{loads[0]:.3g} N", f"{loads[1]:.3g} N"
    if alike([0.0], list(loads), 1.0):
        last, first = f"{twists[0]:.3g} turns", f"{twists[1]:.3g} turns"
    # a run without a rest after its strokes has none but the one that it begins with
    rests = f"rests last at {last}" if before.after[-1] else f"begins at {last} and rests no more"
    apart_mm = after.levels_mm[0] - before.levels_mm[-1]
    less = f"{abs(apart_mm):.2g} mm {'more' if apart_mm > 0 else 'less'}"
    why = f"{before.run.run} {rests}, {after.run.run} begins at {first}, {less} than simulated"
    by, by_checked = tare_command(after.folder, "run"), tare_command(after.folder, "checked")
    zero = zeros(so_far, frozenset({after.run.run}))[-1]
    set_so = f"compared with {zero.told_by}" if zero.told_by else "set to the model's value"
    mend = f"write `tare: run` in run.yaml of {after.run.run} ({by}): its first rest is then {set_so}"
    between = f"{NOT_COMPARED} {before.run.run} and {after.run.run}"
    checked = f"If neither moved, write `tare: checked` ({by_checked})"
    return f"{between}: {why}. If the sensor or a clamp was moved since, {mend}. {checked}."
