"""Every effect that this author knows, with its laws by name."""

from collections.abc import Mapping

from pipeline.rig.authors.mechanics import bench, coil, drive, friction, load, sensor, slips, string
from pipeline.rig.authors.mechanics.scene import Writer

WRITERS: Mapping[str, tuple[Writer, ...]] = {
    "plastic_elongation": (string.hardening_knots, string.viscous_knots),
    "creep": (string.kelvin_voigt, string.two_kelvins),
    "axial_elasticity": (string.linear_spring, string.crimped_braid),
    "radius_compaction": (string.springy_core, string.pressed_fibres),
    "friction_hysteresis": (friction.shoe_on_rail, friction.strand_sliders),
    "viscous_loss": (friction.grease_dashpot, friction.stirred_fluid),
    "backlash": (drive.toothed, drive.two_dogs),
    "shaft_windup": (drive.torsion_spring, drive.spider_coupling),
    "jam": (drive.strand_pads, drive.packed_strands),
    "slack": (load.hard_seat, load.springy_seat),
    "end_stop": (load.hard_stop, load.foam_stop),
    "overtwist": (coil.adhering_coil, coil.two_coils),
    "clamp_slip": (slips.one_ridge, slips.several_ridges),
    "count_slip": (slips.one_flat, slips.several_flats),
    "load_swing": (load.bouncing_weight, load.pendulum),
    "sensor_lag": (sensor.filtered, sensor.heavy_pickup),
    "eccentricity": (sensor.orbiting_eyelet, sensor.tilted_axis),
    "x_shaken_bench": (bench.shaken_bench,),
    "x_second_weight": (bench.second_weight,),
    "x_bumpy_rail": (bench.bumpy_rail,),
}
LAWS: Mapping[str, tuple[str, ...]] = {
    effect: tuple(writer.__name__ for writer in writers) for effect, writers in WRITERS.items()
}
