"""Notes on `tare` in the runs of one string where no jump of the zero is seen.

A jump that is smaller than what the string does by itself from stroke to stroke is not called one. Where another run of
the string says `tare: run`, its sensor is likely set to zero at each start, and so may be this one's.
"""

from itertools import pairwise

from ..ground.words.jump_notes import MODEL_VALUE, SET_ANEW
from ..run.mend_command import tare_command
from .history import in_order
from .jump import TAKEN_OFF, taken_off
from .recovered import recovered
from .rests import Rests
from .zero import Zero, change_mm, changes_among, zeros

FEW = 3  # runs of a string that are named


def set_anew(runs: list[Rests]) -> list[str]:
    """A sentence on the runs of one string whose run.yaml says `tare: run`: by how much each zero was moved."""
    moved, doubts = [], set[str]()
    ordered = in_order(runs)
    for after, zero in zip(ordered[1:], zeros(ordered)[1:], strict=True):
        if after.run.tare == "run":
            by = "set to the model's value" if zero.moved_mm is None else f"{zero.moved_mm:+.2g} mm"
            moved.append(f"{after.run.run} ({by}{f', by {zero.told_by}' if zero.told_by else ''})")
            doubts.add(zero.doubt)
    if not moved:
        return []
    more = f" and {len(moved) - FEW} more" if len(moved) > FEW else ""
    how_known = " ".join(sorted(doubts, reverse=True))
    return [f"{SET_ANEW} {', '.join(moved[:FEW])}{more}, as run.yaml says by `tare: run`. {how_known}"]


def tare_notes(runs: list[Rests]) -> list[tuple[str, str]]:
    """The runs of one string that `tare` matters to, each with a sentence."""
    ordered = in_order(runs)
    changes = {jump.run: jump for jump in changes_among(ordered)}
    own_zero = [rests.run.run for rests in ordered[1:] if rests.run.tare == "run"]
    notes = []
    for (before, after), zero in zip(pairwise(ordered), zeros(ordered)[1:], strict=True):
        name, change = after.run.run, change_mm(before, after)
        if name in changes and changes[name].is_own and changes[name].is_unconfirmed:
            notes += [(name, note) for note in [changes[name].own_note] if note]
            continue
        is_jump = name in changes and not changes[name].is_own
        if is_jump or not own_zero or after.run.tare == "checked":
            continue
        reads = "its first rest is at another twist or load than the last one before"
        if change is not None:
            more = "more" if change > 0 else "less"
            reads = f"at rest it reads {abs(change):.2g} mm {more} than {before.run.run} at its end"
        if name in own_zero:
            off = _set_otherwise(zero) if change is None else taken_off(change, recovered(before, after))
            notes.append((name, f"run.yaml of {name} says `tare: run`: {reads}. {off}"))
        else:
            others = f"{own_zero[0]}, of the same string, says `tare: run`, and {name} does not"
            by, by_checked = tare_command(after.folder, "run"), tare_command(after.folder, "checked")
            mend = f"If its sensor was set to zero again, write `tare: run` in run.yaml of {name} too ({by})"
            checked = f"if it was checked and did not move, `tare: checked` ({by_checked})"
            notes.append((name, f"{others}: {reads}. {mend}; {checked}."))
    return notes


def _set_otherwise(zero: Zero) -> str:
    """How a zero is set that the last rest before cannot tell, and what is unknown of it."""
    if zero.moved_mm is None:
        return f"So it is set to the model's value. {MODEL_VALUE}"
    moved = f"so the zero was moved by {zero.moved_mm:+.2g} mm, and that is {TAKEN_OFF}"
    return f"It is compared with {zero.told_by}: {moved} {zero.doubt}"
