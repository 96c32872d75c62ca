"""The table of errors that a verdict's sentences refer to: for each simulator, on which strokes."""

import math

from ....ground.command import program_name
from ...document.content import Verdict
from ...document.made_keys import amount, amount_or_none
from ..explanations import rivals
from ..held_out import holdout, unseen
from ..held_out.decided import decided
from ..held_out.without_name import kept_times
from ..language.quantity import listing, size
from ..language.text_table import UNKNOWN, aligned
from ..language.vocabulary import Vocabulary
from ..measured import below_noise, moved_words
from ..measured.dimensions import far_moved, has_table

HEADING = "How far the simulator is off, rms"
HALVED = 2.0  # times less: from there on dimensions took most of the error away
WHOLE = "whole recording (seen by the fit)"
OTHER = (
    "Other effects: {other}, which the procedure names without these strokes. {best} was not fitted without them, "
    "because the procedure fits only what it names."
)
NONE_NAMED = "Without these strokes the procedure names no effect: the right column has the error of {which}."
SAME = "the same effects, fitted without them, which come closest there"
CLOSEST = "what comes closest, no name"
OTHER_EFFECTS, NARROW = "other effects, see below", 33  # letters of a row's name: the table is no wider than a page
TOO_FEW = "Too few strokes to hold any out: nothing says how well the simulator foretells."
SINGLE = "The noise of single samples, which {1} and {2} count, is {0}."
WHOSE = {
    holdout.UNSEEN: "For the right column all was fitted anew without those strokes.",
    holdout.SEEN: "Seen before: the adopted effects were fitted to these strokes too, so it is no test.",
    holdout.PARTLY: "The adopted effects were fitted to those of {seen} too. Those of {unseen} no fit had seen.",
    holdout.PERHAPS: "Perhaps seen before: the adopted effects may have been fitted to these strokes, too.",
}


def lines(content: Verdict, words: Vocabulary) -> list[str]:
    """The table, a line each row, and the remarks for reading it."""
    seen, unseen_errors = _seen(content, words), unseen.errors(content, words)
    zero = any(name.startswith("zero") for name in content["parameters"])
    old, new = (listing(holdout.held_out_runs(content, is_seen)) for is_seen in (True, False))
    remarks = [*_of_other(content), WHOSE[holdout.status(content)].format(seen=old, unseen=new)]
    remarks = remarks if unseen_errors else [TOO_FEW]
    remarks = [*remarks[:-1], f"{remarks[-1]} {_moved_most(content, words)}".strip()]
    below = below_noise.REMARK if below_noise.is_below(_columns(content, words)) else ""
    remarks += [_single(seen[2], content, words), below, unseen.ZERO if zero else ""]
    rows = [row for row in _rows(content, words) if row[0] != "nominal" or not kept_times(content, words)]
    return [*aligned(rows), *(line for line in remarks if line)]


def _rows(content: Verdict, words: Vocabulary) -> list[list[str]]:
    """The table's cells, the heads first."""
    unseen_errors, columns = unseen.errors(content, words), _columns(content, words)
    rows = [["simulator", WHOLE, *([holdout.split_seen(content)] if unseen_errors else [])]]
    for place, name in enumerate(("nominal", "calibrated", "as diagnosed")):
        rows.append([name, *(_cell(errors[place], noise, words) for errors, noise in columns)])
    if not content["mechanisms"]:  # nothing is named
        closest = holdout.closest(content) if unseen_errors else ""
        name = f"closest, no name: {closest}"
        if closest:
            of_whole = _cell(_left_with(closest, content, words), columns[0][1], words)
            rows[-1] = [name if len(name) <= NARROW else CLOSEST, of_whole, rows[-1][-1]]
        elif rows[-1][1:] == rows[-2][1:]:
            rows.pop()
    adopted = amount_or_none(content["evidence"], f"adopted_{words.ending}")
    if adopted is not None:
        rows.insert(2, ["as adopted", _cell(adopted, columns[0][1], words), *(UNKNOWN for _ in columns[1:])])
    if unseen_errors and content["mechanisms"] and any(whose := holdout.others(content)):
        of_other, rows[-1][-1] = rows[-1][-1], UNKNOWN
        other = whose[1] or whose[0]
        rows += [] if other == holdout.NO_EFFECT else [[_row_of(other), UNKNOWN, of_other]]
    rows.append(
        [
            "noise",
            *(
                size(noise, words.unit) + kind
                for (_, noise), kind in zip(columns, _kinds(content, words), strict=False)
            ),
        ]
    )
    return rows


def _columns(content: Verdict, words: Vocabulary) -> list[tuple[list[float | None], float]]:
    """The nominal, calibrated and diagnosed errors of each column of the table, and the column's noise."""
    columns = [(_seen(content, words), amount(content["evidence"], f"floor_{words.ending}"))]
    if unseen_errors := unseen.errors(content, words):
        columns.append((list(unseen_errors), amount(content["fit"], f"noise_floor_{words.ending}")))
    return columns


def _left_with(closest: str, content: Verdict, words: Vocabulary) -> float | None:
    """The rms that the closest explanation leaves of the whole recording; None if it was not weighed there."""
    shown = content["evidence"]["explanations"]
    weighed = [each for each in shown if set(each["ids"]) == set(closest.split(" + "))]
    return amount(weighed[0], f"left_{words.ending}") if weighed else None


def _row_of(other: str) -> str:
    """The name of the row for other effects than those that the verdict names."""
    name = f"{other}, see below"
    return name if len(name) <= NARROW else OTHER_EFFECTS


def short(content: Verdict, words: Vocabulary) -> list[str]:
    """The table with its rows said in words, and no remarks; the details have those."""
    rows, unseen_errors = _rows(content, words), unseen.errors(content, words)
    if kept_times(content, words):  # nobody simulates with adopted effects and the dimensions of run.yaml
        rows = [row for row in rows if row[0] != "nominal"]
    named = "as diagnosed: effects added" if content["mechanisms"] else "as diagnosed"
    what = moved_words.what(content)
    first = f"adopted effects, {what} of run.yaml" if holdout.included(content) else f"nominal: {what} of run.yaml"
    moved = f"calibrated{' anew' * bool(holdout.included(content))}: {what} moved"
    in_words = {"nominal": first, "calibrated": moved}
    in_words |= {
        "as adopted": "as adopted: effects and dimensions",
        "as diagnosed": named,
        "noise": below_noise.ESTIMATED if below_noise.is_below(_columns(content, words)) else below_noise.LEAST,
    }
    cells = aligned([[in_words.get(first, first), *rest] for first, *rest in rows])
    single = amount_or_none(content["evidence"], f"single_floor_{words.ending}")
    counts = (
        [SINGLE.format(size(single, words.unit), program_name("simulate"), program_name("adopt"))] if single else []
    )
    return [*cells, *(_of_other(content) if unseen_errors else [TOO_FEW]), *counts, *moved_words.lines(content)]


def _of_other(content: Verdict) -> list[str]:
    """The effects whose error on unseen strokes the table has, if they are not the named ones."""
    other = holdout.other_name(content)
    if not other or not content["mechanisms"]:
        return decided(content)
    if other == holdout.NO_EFFECT:
        closest = holdout.closest(content)
        which = f"{closest}, which comes closest" if closest else "calibration alone"
        return [NONE_NAMED.format(which=SAME if holdout.closest_is_named(content) else which)]
    return [OTHER.format(best=holdout.named(content), other=other)]


def _moved_most(content: Verdict, words: Vocabulary) -> str:
    """The remark that moved dimensions took away most of the error, if none of them moved far."""
    nominal, calibrated, _ = _seen(content, words)
    if kept_times(content, words):  # nobody simulates with adopted effects and the dimensions of run.yaml
        return ""
    if nominal is None or calibrated is None or nominal < HALVED * calibrated or far_moved(content):
        return ""
    where = " (how far each moved: Dimensions)" * has_table(content)
    return f"Moving dimensions alone takes most of the nominal error away{where}."


def _single(error: float | None, content: Verdict, words: Vocabulary) -> str:
    """The remark that the last error of the whole recording is for single samples, if averages were compared.

    Averages take noise away and leave what is systematic, so the noise of single samples comes in its place.
    """
    floor, scored = amount(content["evidence"], f"floor_{words.ending}"), content["evidence"].get("scored_step_s")
    single_floor = amount_or_none(content["evidence"], f"single_floor_{words.ending}")
    noise = single_floor if scored else amount(content["fit"], f"noise_floor_{words.ending}")
    if error is None or noise is None or not any(unseen.kinds(content, words)):
        return ""
    single = math.sqrt(max(error**2 - floor**2, 0.0) + noise**2)
    least, about = size(error, words.unit), size(single, words.unit)
    counts = [f"the noise is {size(noise, words.unit)}"] * bool(scored)
    counts += [f"{least} would be about {about}"] * (least != about)
    who = f"as {program_name('simulate')} and {program_name('adopt')} count"
    averages = f"{'Both columns are' if scored else 'The left column is'} of averages"
    return (
        f"{averages}: their noise is `the noise` elsewhere on this page."
        + f" Of single samples, {who}, {', and '.join(counts)}." * bool(counts)
    )


def _seen(content: Verdict, words: Vocabulary) -> list[float | None]:
    """Errors over the whole recording: nominal, calibrated, as diagnosed; None where an older file has none."""
    evidence, named = content["evidence"], rivals.entries(content, "named")
    nominal, calibrated = (amount_or_none(evidence, f"{name}_{words.ending}") for name in ("nominal", "calibrated"))
    return [nominal, calibrated, amount(named[0], f"left_{words.ending}") if named else calibrated]


def _cell(error: float | None, noise: float, words: Vocabulary) -> str:
    return UNKNOWN if error is None else f"{size(error, words.unit)} ({unseen.exact(error / noise)} times the noise)"


def _kinds(content: Verdict, words: Vocabulary) -> tuple[str, str]:
    """The kind of each noise, where the two differ."""
    whole, unseen_kind = (f", of {kind}" if kind else "" for kind in unseen.kinds(content, words))
    return whole, unseen_kind
