"""Shaft and coupling twist elastically under the string's torque."""

import numpy as np

from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term

UP_TO = (0.12, 0.25, 0.45, 0.7)  # of the highest torque: where a spring in series bottoms
LOOP = 0.02  # of the range of motion: what a coupling that rubs needs to turn its loop round


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """One candidate; none without a lever that changes, where wind-up is stretch: `axial_elasticity`."""
    if not drivers.levered:
        return []
    highest = max(float(np.percentile(np.abs(drivers.load * drivers.sine), 99.9)), 1e-9)
    return [{"loop_turns": float(f"{LOOP * drivers.span:.6g}"), "highest_torque": float(f"{highest:.6g}")}]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Twist lost in proportion to the torque F r sin a, and parts that stiffen, bottom, yield or rub."""
    torque = drivers.load * drivers.sine
    side, highest = drivers.directed(nonlinear["loop_turns"]), nonlinear["highest_torque"]
    stops = [
        Term(
            f"up_to_{share:g}_turns_per_10_n", "twist", -np.clip(torque, -share * highest, share * highest), "turns/10N"
        )
        for share in UP_TO
    ]
    return [
        Term("yielding_turns", "twist", -torque * np.abs(torque), "turns"),
        Term("rubbing_turns_per_10_n", "twist", -torque * side, "turns/10N"),
        Term("turns_per_10_n", "twist", -torque, "turns/10N"),
        Term("stiffening_turns_per_10_n", "twist", -np.sign(torque) * np.sqrt(np.abs(torque)), "turns/10N"),
        *stops,
    ]


MECHANISM = Mechanism(
    id="shaft_windup",
    driver="torque (load x twist)",
    columns=("load x twist",),
    equation="theta_s = theta - F r sin a / k_t",
    letters={
        "k_t": "the stiffness of the shaft: the radius over the strengths",
    },
    strengths=("k_t",),
    meanings={
        "highest_torque": "the highest torque of the recording, {scale}",
        "loop_turns": "over which {motion} the part that rubs turns round",
    },
    source=(
        "Timoshenko, Strength of Materials, 1930 (torsion of a shaft); "
        "couplings: Budynas and Nisbett, Shigley's Mechanical Engineering Design, 2011"
    ),
    confused_with="radius_compaction, a wrong radius (under one load)",
    told_apart_by="two loads; or lock the string's end and twist",
    meaning="the shaft twists under torque.",
    sentence="The shaft winds up under the torque of the {string}, which costs up to {span} of {reading} ({size}).",
    details=("{turns_per_10_n} in proportion to the torque",),
    names={
        "up_to": "the torque, up to that share of the highest",
        "yielding": "the torque squared",
        "rubbing": "the torque x direction",
        "stiffening_turns": "the root of the torque",
    },
    twisted=True,
    candidates=candidates,
    remembers_turns=True,
    terms=terms,
)
