"""Eqs 2 to 5, or a twisted pair's, in C, and the two analytic models that are nothing else."""

import numpy as np

from ..ground.kinematics import RAD_PER_TURN, loaded_radius
from .c_text import Body, function, read, real
from .inputs import Inputs
from .interface import Source

LOADED = ("radius_mm", "length_mm", "stiffness_n_per_mm", "load_n")


def zone(inputs: Inputs) -> str:
    """The length that contractions are taken relative to, as an expression in mm."""
    return read(inputs, "length_mm" if inputs.pair else "torsion_zone_mm")


def _mm_per_turn(inputs: Inputs) -> str:
    """String that a turn winds up, 2πr under load, as an expression in mm."""
    radius = read(inputs, "radius_mm")
    if inputs.pair:
        return f"{real(RAD_PER_TURN)} * {radius}"
    if not set(LOADED) & set(inputs.names):
        return real(RAD_PER_TURN * float(loaded_radius(*(inputs.baked[name] for name in LOADED))))
    length, stiffness, load = (read(inputs, name) for name in LOADED[1:])
    return f"{real(RAD_PER_TURN)} * {radius} * tsa_sqrt({length} / ({length} + {load} / {stiffness}))"


def physics(inputs: Inputs) -> str:
    """Functions `tsa_mm_per_turn`, `tsa_base_mm` (eq. 4) and `tsa_base_turns` (eq. 5) of the state.

    Both are written without the difference of near numbers that eq. 4 has at small twists.
    """
    per_turn = function(
        "tsa_real", "tsa_mm_per_turn(const tsa_state *at)", "(void)at;", f"return {_mm_per_turn(inputs)};"
    )
    whole, separator = zone(inputs), read(inputs, "separator_mm")
    head = "(const tsa_state *at, tsa_real mm_per_turn, tsa_real"
    if inputs.pair:
        forward = function(
            "tsa_real",
            f"tsa_base_mm{head} motor_turns)",
            f"const tsa_real whole_mm = {whole}, wound_mm = motor_turns * mm_per_turn;",
            "const tsa_real left = whole_mm * whole_mm - wound_mm * wound_mm;",
            "(void)at;",
            "return left > 0 ? wound_mm * wound_mm / (whole_mm + tsa_sqrt(left)) : whole_mm;",
        )
        inverse = function(
            "tsa_real",
            f"tsa_base_turns{head} contraction_mm)",
            f"const tsa_real whole_mm = {whole};",
            "const tsa_real x = contraction_mm < 0 ? 0 : contraction_mm > whole_mm ? whole_mm : contraction_mm;",
            "(void)at;",
            "return tsa_sqrt(x * (2 * whole_mm - x)) / mm_per_turn;",
        )
        return per_turn + forward + inverse
    forward = function(
        "tsa_real",
        f"tsa_base_mm{head} motor_turns)",
        f"const tsa_real zone_mm = {whole}, open_mm = {separator} + motor_turns * mm_per_turn;",
        "(void)at;",
        "return open_mm * open_mm / (tsa_sqrt(zone_mm * zone_mm + open_mm * open_mm) + zone_mm);",
    )
    inverse = function(
        "tsa_real",
        f"tsa_base_turns{head} contraction_mm)",
        f"const tsa_real square = contraction_mm * (contraction_mm + 2 * {whole});",
        "(void)at;",
        f"return (tsa_sqrt(square > 0 ? square : 0) - {separator}) / mm_per_turn;",
    )
    return per_turn + forward + inverse


def body(source: Source) -> Body:
    """The nominal or the calibrated analytic model."""
    c_body = Body(physics(source.inputs))
    c_body.code += function(
        "tsa_real",
        "tsa_raw_forward(const tsa_state *at, tsa_real motor_turns)",
        f"return tsa_base_mm(at, tsa_mm_per_turn(at), motor_turns) + {real(source.zero_mm)};",
    )
    c_body.code += function(
        "tsa_real",
        "tsa_raw_inverse(const tsa_state *at, tsa_real displacement_mm)",
        f"return tsa_base_turns(at, tsa_mm_per_turn(at), displacement_mm - {real(source.zero_mm)});",
    )
    return c_body


def standardised(source: Source) -> list[str]:
    """The conditions' table (`conditions.Conditions.table`) as expressions, one a column."""
    conditions, inputs = source.model.conditions, source.inputs
    scaled = [
        f"({read(inputs, name)} - {real(mean)}) * {real(1.0 / std)}"
        for name, mean, std in zip(conditions.names, conditions.mean, conditions.std, strict=True)
    ]
    return scaled + [f"(tsa_real)(at->material == {number})" for number in range(1, len(conditions.materials))]


def paper_conditions(source: Source, mean: np.ndarray, std: np.ndarray, log_stroke: bool = True) -> list[str]:
    """The scaled conditions b, l, r and n (`condition_columns.conditions`) as expressions; mean and std of shape (4,).

    Mean and std in the columns' units.
    """
    exprs = [read(source.inputs, name) for name in ("separator_mm", "length_mm", "radius_mm")]
    exprs.append("tsa_log((tsa_real)(at->stroke + 1))" if log_stroke else "(tsa_real)at->stroke")
    return [
        real((source.inputs.baked.get(name, 0.0) - m) / s)
        if not expr.startswith(("at->", "tsa_log", "(tsa_real)"))
        else f"({expr} - {real(m)}) * {real(1.0 / s)}"
        for name, expr, m, s in zip(("separator_mm", "length_mm", "radius_mm", "n"), exprs, mean, std, strict=True)
    ]
