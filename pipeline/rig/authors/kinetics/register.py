"""Every law by the effect that it is a form of."""

from collections.abc import Mapping

from pipeline.rig.authors.kinetics.bedding import PLASTIC, STIFFENING
from pipeline.rig.authors.kinetics.coils import JAM, OVERTWIST
from pipeline.rig.authors.kinetics.friction import FRICTION, VISCOUS
from pipeline.rig.authors.kinetics.heat import MOISTURE, THERMAL
from pipeline.rig.authors.kinetics.law import Law
from pipeline.rig.authors.kinetics.packing import COMPACTION, WEAR
from pipeline.rig.authors.kinetics.play import BACKLASH, END_STOP, SLACK, WINDUP
from pipeline.rig.authors.kinetics.sensing import DRIFT, LAG
from pipeline.rig.authors.kinetics.slips import CLAMP_SLIP, COUNT_SLIP, STICK_SLIP
from pipeline.rig.authors.kinetics.spoilers import CLOCKS, PULLEY, SHAKING, SNAG
from pipeline.rig.authors.kinetics.stretch import CREEP, ELASTICITY
from pipeline.rig.authors.kinetics.swing import ECCENTRICITY, SWING

BY_EFFECT: Mapping[str, tuple[Law, ...]] = {
    "plastic_elongation": PLASTIC,
    "creep": CREEP,
    "stiffening": STIFFENING,
    "axial_elasticity": ELASTICITY,
    "thermal": THERMAL,
    "radius_compaction": COMPACTION,
    "wear": WEAR,
    "friction_hysteresis": FRICTION,
    "viscous_loss": VISCOUS,
    "stick_slip": STICK_SLIP,
    "backlash": BACKLASH,
    "shaft_windup": WINDUP,
    "count_slip": COUNT_SLIP,
    "slack": SLACK,
    "jam": JAM,
    "overtwist": OVERTWIST,
    "sensor_lag": LAG,
    "sensor_drift": DRIFT,
    "eccentricity": ECCENTRICITY,
    "clamp_slip": CLAMP_SLIP,
    "end_stop": END_STOP,
    "load_swing": SWING,
    "x_moisture": MOISTURE,
    "x_pulley": PULLEY,
    "x_shaking": SHAKING,
    "x_snag": SNAG,
    "x_clocks": CLOCKS,
}
