"""The error on a recording whose motion was simulated, in words: the number, and what to compare it with."""

from collections.abc import Sequence

import pandas as pd

from ....systems import System
from ...document.content import Verdict
from ...prediction.errors_to_compare import ToCompare
from ...prediction.motor_zero import HOME
from ..held_out import holdout
from ..language.quantity import listing, size, times
from ..language.text_table import aligned

SWITCHED_OFF = f"If the motor was switched off in between, its zero is another: add {HOME}."
A_PART = f"A part of it may hold: add {HOME}, which takes the part that does on the first stroke."
AS_EXPECTED = 1.5  # times what was expected: no more is worth a mend


def computed_of(system: System, samples: pd.DataFrame, zero: bool, carried: bool) -> str:
    """From which columns the reading is computed, and for what the recorded reading is used.

    `zero`: it sets the zero of the reading. `carried`: it chooses the part of a diagnosis that holds, and the motor's
    zero.
    """
    load = [system.load] if system.load and system.load in samples and samples[system.load].any() else []
    chosen = "the motor's zero" if system.homed else "the choice on the first stroke"
    first = [chosen] * carried + ["the zero of the reading"] * zero
    also = f"for {listing(first)}, and " if first else "only "
    read_columns = listing([system.driver, *load])
    return f"{system.channel} is computed of {read_columns}. The recorded {system.channel} is read {also}to compare:"


def beside(
    at_best_zero: float | None, bare: float | None, acting: str, errors: ToCompare | None, unit: str
) -> list[str]:
    """The numbers to compare an error with, a row each, all rms in the reading's `unit`; nothing where none is known.

    `at_best_zero` is the error where the whole recording sets the zero, None where the zero is no choice; `bare` that
    without the effects that are `acting`, None where none is.
    """
    rows = [
        ("the same, if the whole recording sets the zero", at_best_zero),
        (f"without {acting}, same dimensions", bare),
        ("the noise of the readings", errors.noise if errors else None),
        (f"strokes{_of(errors)} that no fit had seen", errors.unseen if errors else None),
    ]
    kept = [[f"  {name}", size(value, unit)] for name, value in rows if value is not None]
    return ["beside it, rms:", *aligned(kept)] if kept else []


def _of(errors: ToCompare | None) -> str:
    return f" of {listing(list(errors.runs))}" if errors and errors.runs != ("",) else ""


def means(
    error: float, run: str, errors: ToCompare | None, content: Verdict | None, hint: str, unit: str, taken: bool = True,
    whole: bool = False, together: Sequence[str] = (),
) -> list[str]:  # fmt: skip
    """What the error says of a diagnosis: nothing if that was fitted to the recording; else how well it holds.

    `error`: rms, in the reading's `unit`, the zero at its best. `hint`: what may help first, a sentence. `taken`:
    whether anything of the diagnosis is simulated. `whole`: whether the whole recording set the zero. `together`: the
    commands that diagnose `run` with recordings of the same string, those first that take adopted effects out; empty
    where none is known.
    """
    if errors is None:
        return []
    if not taken:
        return _with_mend(f"nothing of the diagnosis{_of(errors)} is in this error", run, errors, together, "")
    whose = holdout.whose_if_known(content) if content else ""
    others = [f"the error on strokes that no fit had seen is {whose.strip(' ()')}"] if whose else []
    if run in errors.runs:
        return [f"the simulator was fitted to {run}, so its error on {run} is no test of it", *others]
    if errors.expected is None:
        return []
    which = f"the error if the whole recording sets the zero, {size(error, unit)}," if whole else "the error"
    ratio = f"{which} is {times(error / errors.expected)} times what was to be expected ({size(errors.expected, unit)})"
    if error <= AS_EXPECTED * errors.expected:
        return [f"{ratio}: the diagnosis{_of(errors)} holds in {run} too", *others]
    poorly = f"{ratio}: the diagnosis{_of(errors)} holds poorly in {run}"
    return [*_with_mend(poorly, run, errors, together, hint), *others]


def _with_mend(fault: str, run: str, errors: ToCompare, together: Sequence[str], hint: str) -> list[str]:
    """Says that a diagnosis holds poorly in another run, and what to do; `together` are the commands for both."""
    first_try, then = (f"{hint} ", "Else") if hint else ("", "Mend:")
    if not together:
        return [f"{fault}. {first_try}{then} diagnose {run} itself"]
    first = "take out first what was adopted, then " * (len(together) > 1)
    same = (
        f"{run} is of the same string as {listing(list(errors.runs))} (string.id), and is simulated here as if nothing "
        f"had happened to it before. {first_try}{then} {first}diagnose both together:"
    )
    return [f"{fault}. {same}", *(f"  {line}" for line in together)]
