"""Every effect that this author knows, with its laws by name."""

from collections.abc import Mapping

from pipeline.rig.authors.mechanics.bench import bumpy_rail, second_weight, shaken_bench
from pipeline.rig.authors.mechanics.coil import adhering_coil, two_coils
from pipeline.rig.authors.mechanics.drive import (
    packed_strands,
    spider_coupling,
    strand_pads,
    toothed,
    torsion_spring,
    two_dogs,
)
from pipeline.rig.authors.mechanics.friction import grease_dashpot, shoe_on_rail, stirred_fluid, strand_sliders
from pipeline.rig.authors.mechanics.load import bouncing_weight, foam_stop, hard_seat, hard_stop, pendulum, springy_seat
from pipeline.rig.authors.mechanics.scene import Writer
from pipeline.rig.authors.mechanics.sensor import filtered, heavy_pickup, orbiting_eyelet, tilted_axis
from pipeline.rig.authors.mechanics.slips import one_flat, one_ridge, several_flats, several_ridges
from pipeline.rig.authors.mechanics.string import (
    crimped_braid,
    hardening_knots,
    kelvin_voigt,
    linear_spring,
    pressed_fibres,
    springy_core,
    two_kelvins,
    viscous_knots,
)

WRITERS: Mapping[str, tuple[Writer, ...]] = {
    "plastic_elongation": (hardening_knots, viscous_knots),
    "creep": (kelvin_voigt, two_kelvins),
    "axial_elasticity": (linear_spring, crimped_braid),
    "radius_compaction": (springy_core, pressed_fibres),
    "friction_hysteresis": (shoe_on_rail, strand_sliders),
    "viscous_loss": (grease_dashpot, stirred_fluid),
    "backlash": (toothed, two_dogs),
    "shaft_windup": (torsion_spring, spider_coupling),
    "jam": (strand_pads, packed_strands),
    "slack": (hard_seat, springy_seat),
    "end_stop": (hard_stop, foam_stop),
    "overtwist": (adhering_coil, two_coils),
    "clamp_slip": (one_ridge, several_ridges),
    "count_slip": (one_flat, several_flats),
    "load_swing": (bouncing_weight, pendulum),
    "sensor_lag": (filtered, heavy_pickup),
    "eccentricity": (orbiting_eyelet, tilted_axis),
    "x_shaken_bench": (shaken_bench,),
    "x_second_weight": (second_weight,),
    "x_bumpy_rail": (bumpy_rail,),
}
LAWS: Mapping[str, tuple[str, ...]] = {
    effect: tuple(writer.__name__ for writer in writers) for effect, writers in WRITERS.items()
}
