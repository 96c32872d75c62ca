"""Every law of this hand, by the effect that it is a law of."""

from pipeline.rig.authors.lattice import (
    backlash,
    compaction,
    creep,
    drift,
    eccentricity,
    elasticity,
    end_stop,
    friction,
    jam,
    lag,
    odd_bench,
    odd_sensor,
    overtwist,
    plastic,
    slack,
    slips,
    stick_slip,
    stiffening,
    swing,
    thermal,
    viscous,
    wear,
    windup,
)
from pipeline.rig.authors.lattice.law import Law

MODULES = (
    plastic, creep, stiffening, elasticity, thermal, compaction, wear, friction, viscous, stick_slip, backlash,
    windup, slips, slack, jam, overtwist, lag, drift, eccentricity, end_stop, swing, odd_bench, odd_sensor,
)  # fmt: skip
ALL: tuple[Law, ...] = tuple(law for module in MODULES for law in module.LAWS)
BY_EFFECT: dict[str, tuple[Law, ...]] = {}
for _law in ALL:
    BY_EFFECT[_law.effect] = (*BY_EFFECT.get(_law.effect, ()), _law)
