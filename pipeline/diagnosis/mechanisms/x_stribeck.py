"""Friction that is higher where the motion creeps: it falls from sticking to sliding as the speed grows."""

import numpy as np

from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term

FALLS = (0.02, 0.05, 0.1)  # of the highest rate: at it the friction beyond sliding has mostly gone
DRY = 0.2  # of that rate: below it the direction is no longer known
STANDS, CREEPS = 0.004, 0.3  # of the highest rate: a slower motion stands; of the samples: least share that creeps


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Rates over which the friction falls; none below which less than three tenths of the recording creep.

    A swing that only passes through low rates cannot tell it from what friction and a loss do there. Where something is
    twisted there are none: its loop hides it.
    """
    if drivers.levered:
        return []
    rate = np.abs(drivers.rate)
    fastest = float(np.percentile(rate, 99))
    rates = [
        share * fastest for share in FALLS if np.mean((rate > STANDS * fastest) & (rate < share * fastest)) > CREEPS
    ]
    return [{"falls_turns_per_s": float(f"{falls:.6g}")} for falls in rates]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """The friction beyond that of sliding, against the motion."""
    share = drivers.rate / nonlinear["falls_turns_per_s"]
    return [Term("more_mm", "resistance", np.tanh(share / DRY) * np.exp(-np.square(share)))]


MECHANISM = Mechanism(
    id="x_stribeck",
    driver="low speed",
    equation="F = (F_s - F_c) exp(-(v/v_s)^2) sign(v)",
    letters={
        "F": "the force of friction",
        "F_c": "the friction where it slides",
        "F_s": "the friction where it sticks",
        "v": "the speed",
        "v_s": "the speed above which it is gone",
    },
    meanings={
        "falls_turns_per_s": "the speed above which it is gone",
    },
    source=(
        "Armstrong-Helouvry, Dupont and Canudas de Wit, A survey of models for machines with friction, "
        "Automatica 30, 1994 (Stribeck curve)"
    ),
    confused_with="friction_hysteresis (which is the same at each speed), stick_slip",
    told_apart_by="slow motion: two speeds that are far below all others",
    meaning="friction is higher where the motion creeps than where it slides; on rigs without a string.",
    sentence="Friction is higher where the {motion} creeps, by up to {span} from one way to the other ({size}).",
    details=("it is {more_mm} more", "it has mostly gone at {falls_turns_per_s}"),
    candidates=candidates,
    terms=terms,
)
