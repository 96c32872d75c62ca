"""Whether a string can bear its load: grams read as newtons would tear it, and kilonewtons would be next to nothing."""

from pathlib import Path

import numpy as np

from ...ground.errors import BadInput
from ...ground.kinematics import Geometry
from ...ground.numbers import quantiles
from ...ground.stored.rows import Rows
from ..description import Channel, Run

STRONGEST_MPA = 3000.0  # no fibre bears more
THINNEST_MM = 0.005  # of a radius: no string is thinner, and one in metres reads so
DOUBT_STRETCH = 0.1  # of the length: hardly a string stretches by so much
LEAST_LOAD_N = 0.2  # a load cell that never shows more, and no noise about 0, hardly shows newtons
NOISE = 0.25  # of the largest load: one that goes so far to the other side of 0 is noise about none
MOST_LOAD_N = 1e6  # of either sign: no string that a bench twists carries as much


def check_load(samples: Rows, path: Path) -> None:
    """Raise BadInput for a load that no bench carries."""
    (load_n,) = quantiles.ordered(lambda: samples.pieces("load_n"), len(samples), [(len(samples) - 1) // 2])
    if abs(load_n) > MOST_LOAD_N:
        mend = "check channels.load_n, its unit and scale, and rig.load_n"
        raise BadInput(path, "load_n", f"is {load_n:.3g} N", mend)


def load_mistake(run: Run, samples: Rows, base: Geometry, path: Path, most: float) -> BadInput | None:
    """The argument against a load: its stress on two such strings, or a stretch beyond the share `most`; else None."""
    load_n = quantiles.median(lambda: map(np.abs, samples.pieces("load_n")), len(samples))
    stress_mpa = load_n / (2.0 * np.pi * base.radius_mm**2)
    share = load_n / base.stiffness_n_per_mm / base.length_mm
    if stress_mpa <= STRONGEST_MPA and share <= most:
        return None
    would = (
        f"which no fibre bears: {stress_mpa / 1000:.2g} GPa on two strings of {base.radius_mm:g} mm radius"
        if stress_mpa > STRONGEST_MPA
        else f"which would stretch the string by {share:.0%} of its length"
    )
    if base.radius_mm < THINNEST_MM:
        mend = f"is it in metres? Then it is {1000.0 * base.radius_mm:g} mm; else check it"
        return BadInput(path, "string.radius_mm", f"is {base.radius_mm:g} mm, thinner than any string", mend)
    from_run_yaml = "load_n" in run.rig and samples.extremes("load_n") == (run.rig["load_n"],) * 2
    mend = "give rig.load_n in newtons" if from_run_yaml else "set channels.load_n.unit to gf"
    mend = f"are they grams? {mend}; else check radius_mm and stiffness_n_per_mm"
    return BadInput(path, "load_n", f"is {load_n:.4g} N, {would}", mend)


def small_load(run: Run, samples: Rows, base: Geometry, path: Path) -> BadInput | None:
    """What speaks against a logged load that is next to nothing; None where run.yaml says so, or no string bore it."""
    channel, (low_n, high_n) = run.channels.get("load_n", Channel.model_validate({})), samples.extremes("load_n")
    less_n, most_n = sorted((abs(low_n), abs(high_n)))
    about_zero = low_n < 0 < high_n and less_n > NOISE * most_n
    scaled = channel.unit not in (None, "N") or abs(channel.scale) != 1.0
    if not 0 < most_n < LEAST_LOAD_N or about_zero or scaled or low_n == high_n == run.rig.get("load_n"):
        return None
    if 1000.0 * most_n / (2.0 * np.pi * base.radius_mm**2) > STRONGEST_MPA:
        return None  # kilonewtons would tear it
    mend = "kN? Then set channels.load_n.unit to 'kN'; else check that the load is that small"
    return BadInput(path, "load_n", f"is {most_n:.4g} N at most, next to no load", mend)
