"""The error on strokes that no fit has seen, in words, and what must be said of it first."""

import math

from ....ground.command import program_name
from ...document.content import Verdict
from ...document.made_keys import amount, amount_or_none
from ..language.quantity import duration, size, times
from ..language.vocabulary import Vocabulary
from . import holdout

NOTHING_NEW = 1.15  # times what the fit leaves of strokes that it has seen: no more is missing on others
STILL_MISSING = 1.3  # noise floors on unseen strokes, from which something systematic is still missing
AVERAGED = 0.05  # of the noise: what averaging must take off it to be worth a word
ZERO = (
    f"{program_name('simulate')} of another run takes the zero of the reading from its first second. A verdict fits "
    "that zero to the whole recording, so simulate can err by more."
)
NEAR = 1.5  # times the limit: a ratio below it is said to a hundredth


def errors(content: Verdict, words: Vocabulary) -> tuple[float, float, float] | None:
    """Nominal, calibrated and explained error, or None where no stroke could be held out."""
    heldout = content["fit"]["heldout"]
    if not heldout:
        return None
    nominal, calibrated, explained = (
        amount(heldout, f"{name}_{words.ending}") for name in ("nominal", "calibrated", "explained")
    )
    return nominal, calibrated, explained


def worse(content: Verdict, words: Vocabulary) -> str:
    """The end of the first line: the learnt simulator is worse than the nominal one; else nothing."""
    unseen_errors = errors(content, words)
    who = content["fit"].get("worse_than_nominal", [])
    if unseen_errors is None or not who:
        return ""
    nominal, error = unseen_errors[0], unseen_errors[2] if "explained" in who else unseen_errors[1]
    if size(error, words.unit) == size(nominal, words.unit):
        return ""
    sizes = f"{size(error, words.unit)} against {size(nominal, words.unit)}"
    with_what = holdout.simulator(content) if "explained" in who else "calibrated"
    if "explained" not in who and content["verdict"] in ("explained", "ambiguous"):
        named = "with what is named" if not holdout.other_name(content) else holdout.simulator(content)
        with_it = f"the simulator {named} errs by {size(unseen_errors[2], words.unit)}"
        return (
            f" On the {holdout.strokes(content)} {with_it}. The simulator of run.yaml as it stands (nominal) errs "
            f"by {size(nominal, words.unit)}, and calibrated alone by more: {size(error, words.unit)}."
        )
    return f" But on the {holdout.strokes(content)} the simulator {with_what} is worse than the nominal one ({sizes})."


def fails_first(content: Verdict, words: Vocabulary) -> bool:
    """Whether the first line says that the tried simulator is worse than the nominal one on those strokes."""
    return "explained" in content["fit"].get("worse_than_nominal", []) and bool(worse(content, words))


def other_fails(content: Verdict, words: Vocabulary) -> bool:
    """Whether the first line says so of other effects than those of the one explanation."""
    return content["verdict"] == "explained" and bool(holdout.of_other(content)) and fails_first(content, words)


def partly(content: Verdict, words: Vocabulary) -> bool:
    """Whether the error on unseen strokes is larger than the noise, and no new load or motion in them is the cause."""
    unseen_errors, noise = errors(content, words), amount(content["fit"], f"noise_floor_{words.ending}")
    decided = "likely_without_them" in content["evidence"] and not inexact(content, words)
    return unseen_errors is not None and not decided and unseen_errors[2] > STILL_MISSING * noise


def still_missing(content: Verdict, words: Vocabulary, unseen: float, named: bool) -> str:
    """The remark that the error on unseen strokes exceeds the noise, with the error on strokes that were fitted.

    `unseen` is the error on unseen strokes in noise floors.
    """
    fitted = fitted_times(content, words, named)
    if named and fitted is not None and of_calibration(content):
        return _missed_alone(content, unseen, fitted)
    missed = (
        f"the {holdout.strokes(content)} are missed by {exact(unseen)} times the noise ({STILL_MISSING:g} is the limit)"
    )
    if fitted is None or holdout.status(content) in (holdout.SEEN, holdout.PARTLY):
        return f"Something systematic is still missing: {missed}."
    both = f"{missed}; fitted to all strokes, as in the figure, {exact(fitted)} times is left"
    other = holdout.of_other(content)
    if other and named:
        both = f"{other}, fitted without the unseen strokes, misses them by {exact(unseen)} times the noise"
        both += (
            f" ({STILL_MISSING:g} is the limit); {holdout.named(content)}, fitted to all, leaves {exact(fitted)} times"
        )
        changes = f"something changes from stroke to stroke that {other} does not foresee"
        return f"Something systematic is still missing: {both}. So too few strokes were seen, or {changes}."
    if unseen <= NOTHING_NEW * fitted:
        return f"Something systematic is still missing: {both}. So it is in what the fit has seen as well."
    if named:
        changes = "So something changes from stroke to stroke that the explanation does not foresee"
        return f"Something systematic is still missing: {both}. {changes}, or too few strokes were seen."
    return f"Something changes from stroke to stroke that the fit does not foresee: {both}."


def of_calibration(content: Verdict) -> bool:
    """Whether the error on unseen strokes belongs to calibration alone: without them nothing was named."""
    return holdout.other_name(content) == holdout.NO_EFFECT and not holdout.closest(content)


def _missed_alone(content: Verdict, unseen: float, fitted: float) -> str:
    """The same where only calibration was tried, which says nothing of the named effects; in noise floors."""
    strokes, best = holdout.strokes(content), holdout.named(content)
    if fitted <= STILL_MISSING:
        return (
            f"Calibration alone misses the {strokes} by {exact(unseen)} times the noise: that says nothing of {best}."
        )
    limit = f"({STILL_MISSING:g} is the limit)"
    return (
        f"Something systematic is still missing: {best} leaves {exact(fitted)} times the noise of the whole recording "
        f"{limit}. The {exact(unseen)} times by which the {strokes} are missed are of calibration alone."
    )


def exact(ratio: float) -> str:
    """A ratio in words; with two decimals where one would hide that it exceeds the limit: 1.28 is 1.3, 1.34."""
    return f"{ratio:.2f}" if ratio > STILL_MISSING and times(ratio) == times(STILL_MISSING) else times(ratio)


def nothing_new(content: Verdict, words: Vocabulary) -> bool:
    """Whether the error on unseen strokes is about the same as on strokes that the fit has seen."""
    unseen_errors, fitted = errors(content, words), fitted_times(content, words, named=True)
    if unseen_errors is None or fitted is None:
        return False
    return unseen_errors[2] / amount(content["fit"], f"noise_floor_{words.ending}") <= NOTHING_NEW * fitted


def fitted_times(content: Verdict, words: Vocabulary, named: bool) -> float | None:
    """The residual of the verdict's simulator on the whole recording, which it was fitted to, in noise floors."""
    evidence = content["evidence"]
    left_rms = amount_or_none(evidence, f"calibrated_{words.ending}")
    if named:
        best = [shown for shown in evidence["explanations"] if shown["standing"] == "named"]
        left_rms = amount(best[0], f"left_{words.ending}") if best else None
    return float(left_rms) / amount(evidence, f"floor_{words.ending}") if left_rms is not None else None


def inexact(content: Verdict, words: Vocabulary) -> bool:
    """Whether the residual of the verdict's simulator on the whole recording exceeds the noise."""
    fitted = fitted_times(content, words, content["verdict"] in ("explained", "ambiguous"))
    return fitted is not None and fitted > STILL_MISSING


def left_over(content: Verdict, words: Vocabulary) -> float:
    """The rms beyond the noise that an unnamed simulator leaves of all or of unseen strokes; 0 near the noise."""
    noise, unseen_errors = amount(content["fit"], f"noise_floor_{words.ending}"), errors(content, words)
    beyond = [left_of_whole(content, words)]
    if unseen_errors is not None and unseen_errors[2] > STILL_MISSING * noise:
        beyond.append(math.sqrt(unseen_errors[2] ** 2 - noise**2))
    return max(beyond)


def left_of_whole(content: Verdict, words: Vocabulary) -> float:
    """The rms beyond the noise that an unnamed simulator leaves of the whole recording; 0 near the noise."""
    fitted = fitted_times(content, words, named=False)
    if fitted is None or fitted <= STILL_MISSING:
        return 0.0
    return amount(content["evidence"], f"floor_{words.ending}") * math.sqrt(fitted**2 - 1.0)


def noises(content: Verdict, words: Vocabulary) -> tuple[str, str]:
    """The noise of the whole recording and of unseen strokes, as compared: each by name with its size."""
    noise, floor = (
        amount(content["fit"], f"noise_floor_{words.ending}"),
        amount(content["evidence"], f"floor_{words.ending}"),
    )
    whole, unseen_kind = (f" of {kind}" if kind else "" for kind in kinds(content, words))
    return f"noise{whole}: {size(floor, words.unit)}", f"noise{unseen_kind}: {size(noise, words.unit)}"


def kinds(content: Verdict, words: Vocabulary) -> tuple[str, str]:
    """The kind of values that were compared, over the whole recording and on held-out strokes: averages or samples.

    Nothing where both are the single samples.
    """
    over, scored = content["evidence"].get("step_s"), content["evidence"].get("scored_step_s")
    if not averaged(content, words) and not scored:
        return "", ""
    unseen_kind = f"averages of {duration(scored)}" if scored else "single samples"
    return f"averages{f' of {duration(over)}' if over else ''}", unseen_kind


def averaged(content: Verdict, words: Vocabulary) -> bool:
    """Whether the whole recording was compared in averages, which have less noise than its single samples."""
    noise, floor = (
        amount(content["fit"], f"noise_floor_{words.ending}"),
        amount(content["evidence"], f"floor_{words.ending}"),
    )
    return bool(abs(floor - noise) > AVERAGED * noise)
