import math

import pytest

from pipeline.ground.units import conversion


@pytest.mark.parametrize(
    ("column", "unit", "raw", "value"),
    [
        ("motor_turns", "rad", math.tau, 1.0),
        ("motor_turns", "deg", 90.0, 0.25),
        ("motor_turns", None, 3.0, 3.0),
        ("motor_deg", "rad", math.pi, 180.0),
        ("displacement_mm", "m", 0.0123, 12.3),
        ("displacement_mm", "cm", 1.5, 15.0),
        ("displacement_mm", "um", 1500.0, 1.5),
        ("position_m", "mm", 250.0, 0.25),
        ("load_n", "kgf", 2.0, 19.6133),
        ("load_n", "kN", 0.02, 20.0),
        ("load_n", "gf", 100.0, 0.980665),
        ("load_n", "lbf", 1.0, 4.4482216152605),
        ("load_n", "ozf", 16.0, 4.4482216152605),
        ("load_n", "mN", 150.0, 0.15),
        ("torque_nm", "Nmm", 12.0, 0.012),
        ("time_s", "us", 2.5e6, 2.5),
        ("time_s", "ms", 40.0, 0.04),
        ("temperature_c", "K", 300.0, 26.85),
        ("motor_current_a", "mA", 120.0, 0.12),
        ("force_n", "V", 7.0, 7.0),
    ],
)
def test_conversion(column, unit, raw, value):
    factor, shift = conversion(column, unit)
    assert factor * raw + shift == pytest.approx(value)


def test_counts():
    factor, _ = conversion("motor_turns", "count", 4096.0)
    assert factor * 2048 == pytest.approx(0.5)
    factor, _ = conversion("motor_deg", "count", 8192.0)
    assert factor * 4096 == pytest.approx(180.0)
    with pytest.raises(ValueError, match="counts belong to angles"):
        conversion("displacement_mm", "count", 100.0)


def test_a_load_in_kg_is_told_to_be_in_kilograms_of_force():
    with pytest.raises(ValueError, match=r"converts to N: a load cell that shows kg .* write kgf$"):
        conversion("load_n", "kg")
    with pytest.raises(ValueError, match=r"converts to mm$"):
        conversion("displacement_mm", "kg")


@pytest.mark.parametrize("unit", ["\u00b5m", "\u03bcm", "micron", "micrometre"])
def test_a_micrometre_is_not_mistaken_for_a_metre(unit):
    """A column in micrometres was told: did you mean 'm'?"""
    with pytest.raises(ValueError, match="did you mean 'um'"):
        conversion("displacement_mm", unit)
