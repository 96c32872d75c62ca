"""The remarks on a predicted motion that nobody recorded: by how much the simulator may err there, and why."""

import numpy as np

from ....ground.command import command
from ....ground.kinematics import Array
from ....ground.numbers import spans
from ....ground.words.counts import are
from ....run.planned_motion.motion_course import Mask
from ...choice.outcome import rms
from ...document.content import Verdict
from ...document.evidence import Evidence
from ...document.made_keys import amount
from ...prediction.prediction_band import Foretold
from ..held_out import holdout
from ..language.quantity import listing, number, percent, plus_minus, quantity, size, times
from ..language.vocabulary import Vocabulary

OUTSIDE, AFTER_RECORDING = "outside", "--after-recording"  # a column of the answer; the option
STRETCHES = 3  # of time, that are said; the others are counted
REPORTED = 0.2  # of a plan's rows: where fewer are inside, one error is none of the plan
MOSTLY = 0.8  # of the rms: a mean so far from 0 tells the way
COVERS = (
    "{low} and {high}: nine of ten {readings} lie between them, if the explanation is right. They cover how well "
    "its numbers are known, and {missed}. They cover no other explanation, no other {string}, and no motion beyond "
    "what was recorded"
)


def of_band(foretold: Foretold, inside: Mask, low: str, high: str, words: Vocabulary) -> list[str]:
    """Which rows have no error, what the columns `low` and `high` hold, and the error to compare an rms one with.

    `inside` are the rows within what was recorded, of shape (samples,): of others nothing is
    expected.
    """
    out, unit = int((~inside).sum()), words.unit
    beyond = (
        f"{out} of {len(inside)} rows {are(out)} outside (column {OUTSIDE}): nothing says how well the simulator does "
        f"there, and {low} and {high} are empty there"
    )
    if out == len(inside):
        return [f"no expected error: {beyond}"]
    sigma = rms(foretold.sigma[inside])
    missed = "what strokes that no fit had seen were missed by" if foretold.held_out else "the noise of the readings"
    whose = holdout.whose_if_known(foretold.content) if foretold.held_out and foretold.content else ""
    missed += whose
    parts = f"{size(foretold.missed, unit)} is {missed}, {size(sigma, unit)} what the numbers of the fit leave open"
    first = [beyond] if out else []
    if (inside & np.logical_or.accumulate(~inside)).any():
        first.append(f"rows after one that is {OUTSIDE} are inside again, though what is slow may still remember it")
    expected = f"{size(foretold.expected(inside), unit)} rms. Of it {parts}"
    rms_error = f"expected error, only to compare with another rms error: {expected}"
    covers = COVERS.format(readings=_readings(foretold), low=low, high=high, missed=missed, string=words.string)
    return [*first, covers, rms_error]


def _readings(foretold: Foretold) -> str:
    """What the band holds: single readings, or averages where a rig is compared only in averages."""
    evidence: Evidence = (foretold.content.get("evidence") if foretold.content else None) or {}
    averaged = evidence.get("scored_step_s") and not any(name.startswith("single_floor_") for name in evidence)
    return f"readings, averaged over {number(evidence['scored_step_s'])} s," if averaged else "single readings"


def in_one_number(foretold: Foretold, inside: Mask, gaps: list[Array], tied: int, channel: str, unit: str) -> list[str]:
    """The one error of a whole plan that can be reported; nothing where the whole plan is outside.

    `gaps` say by how much the curve of each explanation that ties is more, `tied` how many tie: an older file lacks
    their curves. `inside` and each gap have the shape (samples,); gaps are in the reading's unit, which is `unit`.
    """
    if not inside.any():
        return []
    if inside.mean() < REPORTED:
        return [f"nothing to report: the plan is outside what was recorded but for {percent(inside.mean())} of it"]
    share = "the whole plan" if inside.all() else f"the {percent(inside.mean())} of the plan within what was recorded"
    condition = f"whichever of the {1 + tied} likely explanations is right" if tied else "if the explanation is right"
    if len(gaps) < tied:
        condition = "if the best explanation is right, for the file does not say what the others foretell"
    near = size(foretold.within(inside, gaps), unit)
    return [f"to report: nine of ten readings are expected within {near} of {channel} over {share}, {condition}"]


def stretches(rows: Mask, time_s: Array) -> str:
    """The times of some rows, as `from 14.4 to 27.4 s`; of many stretches the first. Shape (samples,), time in s."""
    ends_s = [(f"{time_s[first]:.4g}", f"{time_s[last - 1]:.4g}") for first, last in spans.of_mask(rows)]
    times_s = [f"at {first} s" if first == last else f"{first} to {last} s" for first, last in ends_s]
    not_listed = len(times_s) - STRETCHES
    more = [f"{not_listed} stretch{'es' * (not_listed > 1)} more"] if not_listed > 0 else []
    text = listing([*times_s[:STRETCHES], *more])
    return f"from {text}" if text and not text.startswith("at ") else text


def of_state(gap: Array, expected: float | None, words: Vocabulary, again: str) -> str:
    """How the reading would differ after the recorded motion, which the plan's answer leaves out.

    `gap`: by how much it would be more, of shape (samples,); with the error that is `expected`, in the reading's unit.
    `again`: the command that asks for it.
    """
    unit, string = words.unit, words.string
    middle, most = float(np.mean(gap)), size(float(np.abs(gap).max()), unit)
    way = f"{size(abs(middle), unit)} {'more' if middle > 0.0 else 'less'} on average, " if one_sided(gap) else ""
    ratio = f", {times(rms(gap) / expected)} times the expected error" if expected else ""
    return (
        f"beware: this is the {string} as it was before its first stroke. After the recorded motion it would read {way}"
        f"up to {most} otherwise ({size(rms(gap), unit)} rms{ratio}). For the {string} as the recording left it: "
        f"{again}"
    )


def one_sided(gap: Array) -> bool:
    """Whether a difference is mostly of one sign. Of shape (samples,), in any unit."""
    return bool(abs(float(np.mean(gap))) > MOSTLY * rms(gap))


def of_half_speed(content: Verdict, too_slow_below: float, ending: str, motion_unit: str, unit: str) -> list[str]:
    """The verdict's forecast at half the speed, where such a slow plan is outside: table and remark must agree.

    `too_slow_below`: the speed below which a plan's rows are outside, in `motion_unit` per second, 0 without such. The
    reading's channel has the `ending`; `unit` is the reading's.
    """
    expected = content.get("evidence", {}).get("expected") or {}
    shown = expected.get("explanations", [])
    half = 0.5 * expected.get("speed_per_s", 0.0)
    key = f"loop_half_speed_{ending}"
    if not shown or key not in shown[0] or not 0.0 < half < too_slow_below:
        return []
    first = shown[0]
    spread = first.get("plus_minus", {}).get(key)
    recorded = expected.get("recorded", {}).get(f"loop_{ending}", abs(amount(first, key)))
    if spread is not None and spread > recorded:
        return []  # a loop of 0 ± 4 mm says nothing
    loop = size(amount(first, key), unit) if spread is None else plus_minus(amount(first, key), spread, unit)
    return [
        f"the verdict foretells a loop of {loop} at {quantity(half, f'{motion_unit}/s')}, half the usual speed, if the "
        "explanation is right. Nothing that was recorded says whether it is right at that speed: hence no band there"
    ]


def no_band(source: str, run_dir: str, of_run_yaml: bool) -> str:
    """Why there is no band, and the mend."""
    if of_run_yaml:
        return (
            "no band: run.yaml does not say how well its numbers are known, and the diagnosis.json that was adopted is "
            f"not where it was, or is another. Mend: diagnose again, {command('diagnose')} {run_dir} --out DIR, "
            "or give the diagnosis.json by --simulation"
        )
    return (
        f"no band: {source} does not say how well its numbers are known, as an earlier program wrote it. Mend: "
        f"diagnose again: {command('diagnose')} {run_dir} --out DIR"
    )


def of_rivals(predicted: Array, curves: dict[str, Array], inside: Mask, channel: str, unit: str) -> list[str]:
    """The largest difference of each tied explanation's curve from the best one's, a line each.

    Curves by their explanation, each of shape (samples,), in the channel's unit; `inside` the rows within what was
    recorded.
    """

    def most(curve: Array) -> str:
        gap = abs(curve - predicted)
        if not inside.any() or inside.all():
            return f"{size(float(gap.max()), unit)} from {channel}"
        near, far = (size(float(gap[rows].max()), unit) for rows in (inside, ~inside))
        return f"{near} from {channel} within what was recorded and {far} outside"

    also = ". Note 1, which is of nine of ten readings, includes it" * bool(inside.mean() >= REPORTED)
    which = "the other explanation" if len(curves) == 1 else "another explanation"
    return [
        f"{column_of(ids, channel)}: the reading if {which} is right ({ids}). It differs by at most {most(curve)}{also}"
        for ids, curve in curves.items()
    ]


def of_ties(acting: str, tied: int, columns: list[str]) -> list[str]:
    """The warning that tied explanations are likely too, if some have no column; `tied` is their number."""
    if tied <= sum(name.startswith("if_") for name in columns):
        return []
    single = f"{acting} is one" if " " not in acting else f"the explanation by {acting} is one"
    return [f"beware: {single} of {1 + tied} likely explanations, and another may say otherwise here"]


def column_of(ids: str, channel: str) -> str:
    """The column of an explanation that ties, such as `if_thermal_and_creep_mm`."""
    return f"if_{ids.replace(' + ', '_and_')}_{channel.rpartition('_')[2]}"
