"""Columns of a motion that is planned, beside its reading: without effects, a band, the explanations that tie."""

import argparse
import shlex
import sys
from typing import cast

import numpy as np

from ..ground.command import command
from ..ground.kinematics import Array
from .document.content import Verdict
from .prediction.planned_motion import Plan, expected_error
from .prediction.prediction_band import adopted_diagnosis
from .words.foretold.prediction import (
    AFTER_RECORDING,
    OUTSIDE,
    column_of,
    in_one_number,
    no_band,
    of_band,
    of_half_speed,
    of_rivals,
    of_state,
    stretches,
)
from .words.foretold.residual import RESIDUAL
from .words.language.quantity import listing
from .words.language.vocabulary import Vocabulary


def after_recording(arguments: argparse.Namespace) -> str:
    """The command that simulates the same plan after the recorded motion."""
    words = [str(arguments.run_dir), *(["--simulation", str(arguments.simulation)] if arguments.simulation else [])]
    words += ["--motion", str(arguments.motion), AFTER_RECORDING, *([RESIDUAL] if arguments.residual else [])]
    return f"{command('simulate')} {shlex.join([*words, '--out', str(arguments.out)])}"


def planned_columns(plan: Plan, arguments: argparse.Namespace) -> tuple[dict[str, Array], list[str]]:
    """Columns of a planned motion beside its reading, each of shape (samples,) in its unit; and what is said.

    Raises BadInput for a diagnosis.json that is none.
    """
    called = Vocabulary.of(plan.run.system)
    channel, unit = plan.run.system.channel, called.unit
    predicted, inside, ending = plan.predicted, plan.inside(), channel.rpartition("_")[2]
    if plan.outside and plan.outside.asks:
        when = stretches(plan.outside.rows, plan.samples["time_s"].to_numpy())
        asks = f"it asks for {'. It asks for '.join(plan.outside.asks)}. Nothing says how well the simulator does "
        asks += f"there, {when}. Mend: {listing(plan.outside.mends)}, or record a stroke that does as the plan, "
        asks += "diagnose both recordings together, and predict with that"
        print(f"warning: {arguments.motion}: {asks}", file=sys.stderr)
    columns = {OUTSIDE: (~inside).astype(float)} if plan.outside else {}
    columns[f"without_effects_{ending}"] = plan.without_effects
    own = (plan.source, cast(Verdict, plan.content)) if arguments.simulation else None
    place, diagnosis = own or adopted_diagnosis(plan.run)
    width = plan.band(diagnosis, place) if diagnosis else None
    expected = expected_error(width, inside)
    if diagnosis is None or width is None:
        words = [no_band(str(place), shlex.quote(str(arguments.run_dir)), arguments.simulation is None)]
    else:
        low, high, half = f"low_{ending}", f"high_{ending}", np.where(inside, width.half_width, np.nan)
        rivals = plan.curves(diagnosis, place)
        columns = {low: predicted - half, high: predicted + half, **columns}
        columns |= {column_of(ids, channel): curve for ids, curve in rivals.items()}
        gaps = [curve - predicted for curve in rivals.values()]
        words = in_one_number(width, inside, gaps, len(plan.tied), channel, unit)
        words += [*of_band(width, inside, low, high, called), *of_rivals(predicted, rivals, inside, channel, unit)]
        slow = plan.outside.too_slow_below if plan.outside else 0.0
        words += of_half_speed(diagnosis, slow, ending, plan.problem.drivers.units.motion, unit)
    gap = plan.changed_by_recording(expected)
    return columns, [*words, *([] if gap is None else [of_state(gap, expected, called, after_recording(arguments))])]
