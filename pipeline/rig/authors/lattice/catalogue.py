"""Every law of this hand, by the effect that it is a law of."""

import pipeline.rig.authors.lattice.backlash as backlash
import pipeline.rig.authors.lattice.compaction as compaction
import pipeline.rig.authors.lattice.creep as creep
import pipeline.rig.authors.lattice.drift as drift
import pipeline.rig.authors.lattice.eccentricity as eccentricity
import pipeline.rig.authors.lattice.elasticity as elasticity
import pipeline.rig.authors.lattice.end_stop as end_stop
import pipeline.rig.authors.lattice.friction as friction
import pipeline.rig.authors.lattice.jam as jam
import pipeline.rig.authors.lattice.lag as lag
import pipeline.rig.authors.lattice.odd_bench as odd_bench
import pipeline.rig.authors.lattice.odd_sensor as odd_sensor
import pipeline.rig.authors.lattice.overtwist as overtwist
import pipeline.rig.authors.lattice.plastic as plastic
import pipeline.rig.authors.lattice.slack as slack
import pipeline.rig.authors.lattice.slips as slips
import pipeline.rig.authors.lattice.stick_slip as stick_slip
import pipeline.rig.authors.lattice.stiffening as stiffening
import pipeline.rig.authors.lattice.swing as swing
import pipeline.rig.authors.lattice.thermal as thermal
import pipeline.rig.authors.lattice.viscous as viscous
import pipeline.rig.authors.lattice.wear as wear
import pipeline.rig.authors.lattice.windup as windup
from pipeline.rig.authors.lattice.law import Law

MODULES = (
    plastic, creep, stiffening, elasticity, thermal, compaction, wear, friction, viscous, stick_slip, backlash,
    windup, slips, slack, jam, overtwist, lag, drift, eccentricity, end_stop, swing, odd_bench, odd_sensor,
)  # fmt: skip
ALL: tuple[Law, ...] = tuple(law for module in MODULES for law in module.LAWS)
BY_EFFECT: dict[str, tuple[Law, ...]] = {}
for _law in ALL:
    BY_EFFECT[_law.effect] = (*BY_EFFECT.get(_law.effect, ()), _law)
