"""The statements on a string's life: the strokes seen, the forecast, how far to trust it, and what to do."""

import shlex
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ...ground.command import command, program_name
from ...ground.names import SYNTHETIC as SYNTHETIC_MATERIAL
from ...ground.words.jump_notes import KNOWN_IN_PART, OTHERWISE
from ...string.jump import Jump
from ..forecast.life_questions import Answer
from ..forecast.strokes_left import ACCELERATES, FUTURES, HORIZON, LEAST_STROKES, sudden
from ..stroke_health.at_rest import longer_at_rest
from ..stroke_health.health import Health
from ..stroke_health.indicators import REFERENCE
from .calibrate_again import AFTERWARDS
from .calibration_advice import advice, due, no_ageing, rests_on
from .claims_held import measured
from .percent import of_100, percent, tail
from .recovery_said import recovery_line
from .so_far import not_yet, so_far
from .stroke_counts import at_least, strokes_at_least, strokes_at_most
from .strokes_compared import CALIBRATED, left_out, recorded

UNFORESEEN = (
    "A sudden end, such as a fibre that breaks, shows in no stroke before it. The forecast gives it a chance of "
    f"{of_100(sudden(1.0))} until the strokes compared have doubled, and of {of_100(sudden(HORIZON))} within "
    f"{HORIZON:g} times the strokes compared; wear that speeds up later has a chance of {of_100(ACCELERATES)}. Every "
    "string is given the same three chances, so this string's own may be larger."
)
SYNTHETIC = (
    f"Only if you record the synthetic rig ({command('rig')}): start it with `--strokes 24`. Without `--standing` each "
    "of its recordings is of a new string."
)
MADE = ("example", SYNTHETIC_MATERIAL)  # materials of the synthetic rig begin so
ZERO_OFF = f"{KNOWN_IN_PART} The model's error may be off by as much."
WAYS_ON = (
    f"A future is one of {FUTURES:,} ways in which this string may go on, by the laws of its strokes, for {{}} strokes."
)
SUDDEN = (
    f"A sudden end shows in no stroke before it; any string has a chance of {of_100(sudden(1.0))} until its strokes "
    "double."
)
STEADY = (  # an error that stays may be large; a change is none then
    " That has not grown since the first third of the strokes, but for their noise.",
    " This change is within the noise of the strokes.",
)
LIKE = " over the compared range of twist"


def few(count: int) -> bool:
    """Whether so many strokes are too few for a forecast."""
    return count < LEAST_STROKES


def heading(health: Health, beside: bool = False) -> list[str]:
    """The strokes recorded and compared; if these are too few, how many are needed and how to get them.

    `beside`: whether other runs of the string are there and were not given.
    """
    table, out = health.strokes, [f"  {line}" for line in left_out(health)]
    if not few(len(table)):
        return [f"{health.string}: {recorded(health)}. {CALIBRATED}", *out]
    more = LEAST_STROKES - len(table)
    like = f"its run {table['run'].iloc[-1]}" if health.loads.others else "its first run"
    one_load = " under one load" * bool(health.loads.others)
    needed = f"at least {LEAST_STROKES}{one_load} are needed, {more} more than there are"
    first = f"{health.string}: no forecast yet: {recorded(health)}; {needed}."
    if beside:
        return [f"{first} Name the runs beside as well.", *out]
    return [
        first,
        *out,
        f"  Record {more} or more further strokes of this very string{health.loads.under} as a new run "
        f"({program_name('new_run')} --like {like}), wound to {health.range_turns[1]:.3g} turns. Then name all runs of "
        "it in this command.",
        *([f"  {SYNTHETIC}"] if health.material.startswith(MADE) else []),
    ]


def sentence(answer: Answer, level: float, enough: bool = True, after: str = "") -> list[str]:
    """One question's answer in words, one fact a sentence; with `enough`, also the reason why there is none.

    `after`: the stroke after which strokes left are counted, where the string has done more.
    """
    forecast, span = answer.left, answer.left.span(level)
    model = "that model" if len(answer.n) else f"a model calibrated on the first {REFERENCE} strokes"
    limit = f"{model} is off by {answer.limit:g} {answer.unit}"
    limit = f"{percent(answer.limit)} of the stroke is lost" if answer.unit == "1" else limit
    if span.state == "no claim":
        return [f"Until {limit}: {f'no claim: {forecast.reason}' if enough else 'no forecast yet'}."]
    if span.state == "passed":
        return [f"Until {limit}: passed already at stroke {forecast.passed_at:.0f}."]
    most = f"{at_least(forecast.horizon)} strokes"
    if span.state == "censored":
        return [f"Until {limit}: more than {most} left{after} in {percent(level)} of the futures."]
    if not np.isfinite(span.median):
        half = f"At least half of the futures stay below the limit for all {most}."
    elif span.median < 1.0:
        half = "Half of the futures pass the limit within the next stroke."
    else:
        half = f"Half of the futures stay below the limit for longer than {strokes_at_least(span.median)}."
    if span.state == "interval":
        ends = tail((1.0 - level) / 2.0)
        between = f"{at_least(span.low)} to {strokes_at_most(span.high)} left{after} in {percent(level)} of the futures"
        return [f"Until {limit}: {between} ({ends} pass it sooner, {ends} later).", half]
    least = f"at least {strokes_at_least(span.low)} left{after} in {percent(level)} of the futures"
    sooner = f"({tail(1.0 - level)} pass it sooner)"
    if span.low < 1.0:
        least, sooner = "not one stroke is sure", f"({tail(1.0 - level)} of the futures pass it within the next one)"
    return [f"Until {limit}: {least} {sooner}.", half]


def answered(
    answer: Answer, level: float, enough: bool, at_rest: str = "", rest_min: float = 0.0, after: str = ""
) -> list[str]:
    """The lines of one question: how far the limit is, how long it stays unpassed, and how far to trust that.

    `rest_min` is the rest, in minutes, that would tell recovery; `after` as `sentence` takes it.
    """
    state = answer.left.span(level).state
    is_loss, now = answer.unit == "1", so_far(answer, at_rest)
    within = "" if answer.left.drifts or (is_loss and at_rest) else STEADY[is_loss]
    claim, *more = sentence(answer, level, enough, after)
    back = recovery_line(answer.recovery, len(answer.left.when) > 0, rest_min)
    lines = [f"  {line}" for line in (f"{now}{within}" if now else "", back, claim) if line]
    if state in ("no claim", "passed"):
        return lines
    trust = " ".join(line for line in (*more, measured(answer.question, state)) if line)
    return [*lines, f"    {trust}"]


def zero(jump: Jump) -> str:
    """The remark on a jump of the zero: a mend if one is possible, and how the jump is treated here."""
    if jump.taken_off:
        moved = f"the {abs(jump.moved_mm):.2f} mm by which its zero was moved are taken off"
        own = f" {jump.own.sentence} That stays in." if jump.own.mm else ""
        return f"{jump.run} has `tare: run`: {moved}.{own}"
    if jump.checked:
        return f"{jump.advice} It is left in."
    done = "Here the change is taken off: it is no wear"
    if jump.may_be_wear:
        done = "Here the change may be of those strokes, and counts as wear"
    return f"{jump.advice} {done}."


def not_given(string: str, folders: list[Path], others: list[Path], out: Path) -> str:
    """The remark on runs of a string beside the given ones, with the command for all of them."""
    count = f"{len(others)} more run{'s' * (len(others) > 1)} of the string {string} beside, not given"
    every = " ".join(shlex.quote(str(folder)) for folder in (*folders, *others))
    again = f"{command('lifespan')} {every} --out {shlex.quote(str(out))}"
    return f"Beware: {count}. Strokes are counted as if there were none of them. All of them:\n  {again}"


def young(run: str) -> str:
    """The remark on a run that begins as the string began."""
    return (
        f"{run} begins as this string began: its first strokes and their loops are those of the string's first "
        f"{REFERENCE} again. If {run} is of a new string, what follows is wrong: give it a string.id of its own in its "
        f"run.yaml (--string-id of {program_name('new_run')})."
    )


def sentences(
    health: Health, answers: list[Answer], level: float, beside: bool = False, calibrate_by: Sequence[str] = (),
    jumped: Sequence[str] = (),
) -> str:  # fmt: skip
    """All answers in words: the strokes, what to beware of, how far each limit is, and what to do.

    `beside` as `heading` takes it, `calibrate_by` how a model is calibrated, `jumped` what jumped within a run.
    """
    lines, enough, at_rest = heading(health, beside), not few(len(health.strokes)), longer_at_rest(health.strokes)
    lines += [f"  {line}" for line in (no_ageing(answers, len(health.strokes), at_rest),) if line]
    lines += [f"  {young(run)}" for run in health.anew]
    lines += [f"  {zero(jump)}" for jump in health.jumps]
    lines += [f"  {note}" for note in health.tares]
    lines += [f"  Beware: {note}" for note in health.uncompared]
    in_part = [note for note in health.tares if not note.endswith(OTHERWISE)]
    if in_part or any(not jump.may_be_wear for jump in health.jumps):
        lines.append(f"  {ZERO_OFF}")
    lines += [f"  {line}" for line in jumped]
    horizons = [answer.left.horizon for answer in answers if len(answer.left.when)]
    lines += [f"  {WAYS_ON.format(at_least(horizons[0]))}", f"  {SUDDEN}"] if horizons else []
    lines += [] if any(so_far(answer) for answer in answers) else [f"  {not_yet(len(health.strokes))}"]
    last, done = int(health.strokes["stroke"].iloc[-1]), health.done
    after, rest_min = f" after stroke {last}" if done > last else "", health.longest_min
    lines += [line for answer in answers for line in answered(answer, level, enough, at_rest, rest_min, after)]
    if enough:
        lines.append(f"  {advice(answers, done, beside, health.loads.under or LIKE * bool(health.left_out))}")
        then = [*calibrate_by, AFTERWARDS] if due(answers) else []
        lines += [f"    {line}" for line in (*rests_on(answers, after), *then) if line]
    return "\n".join(lines)
