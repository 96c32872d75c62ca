"""What to do about an ageing string: when to calibrate the model again, and when to ask again."""

import math

import numpy as np

from ..forecast.life_questions import Answer
from ..forecast.strokes_left import LEAST_STROKES, Span
from .percent import tail
from .stroke_counts import strokes, strokes_at_least

SOONER = 0.5  # of the nearest lower bound: the new strokes then still count before it is reached
LEVEL = 0.9
SOON_PASSED = "a limit may be passed within 2 strokes"
SOON = 2.0  # times the lower bound: a median further away reads as if it went against the advice


def drift(answers: list[Answer]) -> Span:
    """The claim on the model's error."""
    return next(answer.left.span(LEVEL) for answer in answers if answer.question == "model_error")


def jumped(answers: list[Answer]) -> bool:
    """Whether most of the model's error is a jump: what jumped is to be found before the model is calibrated."""
    return any(answer.left.jumped for answer in answers if answer.question == "model_error")


def recalibrate_after(answers: list[Answer]) -> int | None:
    """Strokes from now until the model must be calibrated again: 0 at once, None without a claim."""
    span = drift(answers)
    return None if span.state == "no claim" else math.floor(span.low)


def ask_again_after(answers: list[Answer]) -> int:
    """Strokes until the next question: half of the nearest lower bound, at most as many as are seen now."""
    seen = max(max((len(answer.n) for answer in answers), default=0), LEAST_STROKES)
    return int(np.clip(math.floor(SOONER * min(lows(answers), default=seen)), 1, seen))


def lows(answers: list[Answer]) -> list[float]:
    """The lower bound of the strokes left for each limit that is predicted and not passed."""
    spans = [answer.left.span(LEVEL) for answer in answers]
    return [span.low for span in spans if span.state not in ("no claim", "passed")]


def advice(answers: list[Answer], done: int = 0, beside: bool = False, like: str = "") -> str:
    """When to calibrate the model again and when to ask again, each with the stroke at which that is.

    What was due at a stroke that the string has passed is due now, or with its next strokes `like` those compared: it
    has `done` so many in the given runs, under another load or over another range of twist. `beside`: other runs of it
    were not given, so that nobody counted how many it has done.
    """
    last = max((int(answer.n[-1]) for answer in answers if len(answer.n)), default=0)

    def after(count: int, about: str = "") -> str:
        if beside:
            return f"after {about}{strokes(count)}, counted from stroke {last}"
        if done <= last:
            return f"after {about}{strokes(count)}, at stroke {last + count}"
        ahead = last + count - done
        which = "the next one" if ahead == 1 else f"{strokes(ahead)} from now"
        return f"at {about}stroke {last + count}, {which}: the string has done {done}"

    asked_after, when = ask_again_after(answers), recalibrate_after(answers)
    too = " Strokes of runs that were not given count too." if beside else ""
    again = f"Ask again {after(asked_after)}.{too}"
    if done >= last + asked_after:
        anew = f"again once strokes{like} are recorded after stroke {done}"
        if when and due(answers) and done >= last + when:
            at = f"stroke {last + when}, at which the calibration was due, is among the {strokes(done)} done"
            return f"Advice: calibrate your model again now, on the strokes recorded; ask {anew}: {at}."
        again = f"Ask {anew}: stroke {last + asked_after}, at which that was due, is done."
    if jumped(answers):
        return f"Advice: find what jumped and mend it, then calibrate your model on strokes recorded after it. {again}"
    if when is None:
        return f"Advice: no reason to calibrate your model again is seen so far. {again}"
    if when == 0:
        return f"Advice: calibrate your model again now. {again}"
    if drift(answers).state == "censored":
        since = f" after stroke {last}" * (done > last)
        return f"Advice: your model need not be calibrated again within {strokes(when)}{since}. {again}"
    return f"Advice: calibrate your model again {after(when, 'about ')}. {again}"


def no_ageing(answers: list[Answer], strokes_seen: int, at_rest: str = "") -> str:
    """The remark that nothing ages, so that bounds come from a short record; else empty.

    `at_rest` is what is said of a string that is longer at rest.
    """
    bounds = lows(answers)
    if not bounds or at_rest or any(answer.left.drifts for answer in answers):
        return ""
    least = strokes_at_least(min(bounds))
    return (
        "No ageing is seen: every change is within the noise of the strokes. "
        f"The {strokes(strokes_seen)} compared can promise at least {least} more: "
        "this bound is caution, no sign of wear."
    )


def due(answers: list[Answer]) -> bool:
    """Whether a time to calibrate the model again is foretold, or was passed, and nothing is to be done before."""
    return not jumped(answers) and drift(answers).state in ("passed", "one-sided", "interval")


def rests_on(answers: list[Answer], since: str = "") -> list[str]:
    """The reasons of the advice: why to calibrate or not, and why to ask again.

    `since`: the stroke after which strokes are counted, where the string has done more.
    """
    error = next(answer for answer in answers if answer.question == "model_error")
    limit, model = f"{error.limit:g} {error.unit}", "that model"
    why = {
        "passed": f"{model} was off by {limit} at stroke {error.left.passed_at:.0f} already",
        "no claim": f"nothing is foretold of {model}",
        "censored": f"{model} is off by less than {limit} so long, in 9 of 10 futures",
    }.get(drift(answers).state, f"{model} may be off by {limit} by then, the lower bound above")
    seen = max(len(answer.n) for answer in answers)
    least = math.floor(min(lows(answers), default=0.0))
    half = (
        f"at least {least} strokes are left{since}, and half of those {least} strokes are then done"
        if least > 1
        else SOON_PASSED
    )
    again = half if ask_again_after(answers) < max(seen, LEAST_STROKES) else "the strokes compared have doubled then"
    if jumped(answers):
        first = "Why that first: a model calibrated on strokes before a jump and after it fits neither"
        return [f"{first}.", f"Why ask again: {again}."]
    calibrate = "Why calibrate" if due(answers) else "Why no calibration"
    return [f"{calibrate}: {why}.{_as_wear(error)}{_cautious(error)}", f"Why ask again: {again}."]


def _as_wear(error: Answer) -> str:
    """That the bound counts what came back in a break as wear; empty where nothing did, or breaks tell recovery."""
    if not error.recovery.breaks or error.recovery.is_known or not len(error.left.when):
        return ""
    return " That bound takes what came back in a break for wear."


def _cautious(error: Answer) -> str:
    """Why the advice comes long before half of the futures pass the limit; empty where it does not."""
    span = error.left.span(LEVEL)
    if span.state not in ("one-sided", "interval") or span.median < SOON * span.low:
        return ""
    sooner = tail(1.0 - LEVEL if span.state == "one-sided" else (1.0 - LEVEL) / 2.0)
    return (
        f" The advice is for the worst {sooner} of the futures, which pass {error.limit:g} {error.unit} by then; "
        "half of them stay below it far longer."
    )
