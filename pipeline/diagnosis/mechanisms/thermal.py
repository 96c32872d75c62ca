"""Length follows temperature, measured or from self-heating."""

import numpy as np

from ...ground.kinematics import Array
from ..numerics.recursions import lowpass
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .shared_laws import AS_THE_FIRST, GOES_ON, LATER_RUNS, begun, remembered, time_constants, within

TIMES_S = (10.0, 30.0, 90.0, 270.0, 800.0)  # in which the string takes on heat
LEAST_RANGE_K = 0.3  # of a logged temperature: a smaller range tells nothing
MOVING = 0.05  # of the highest rate: faster is moving, for heat that comes whenever the motor turns
BEHIND_S = 30.0  # time constants of the node between the heat source and the string, where there are two


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Lengthens or shortens when warm, by the measured temperature where there is one or by self-heating.

    The times that the recording can show and its usual powers, for scale, go with each candidate.
    """
    measured = drivers.temperature_c is not None and np.ptp(drivers.smooth(drivers.temperature_c)) > LEAST_RANGE_K
    taus = time_constants(drivers, TIMES_S)
    scales = {"fastest_s": taus[0], "slowest_s": taus[-1]}
    for name, power in _powers(drivers).items():
        scales[f"usual_{name}"] = float(f"{np.mean(power):.6g}")
    measurable = [{"sign": sign, "measured": 1.0, **scales} for sign in (1.0, -1.0)] if measured else []
    calculated = [{"sign": sign, "measured": 0.0, **scales} for sign in (1.0, -1.0)]
    return [*measurable, *begun(drivers, calculated, (GOES_ON, AS_THE_FIRST))]


def _powers(drivers: Drivers) -> dict[str, Array]:
    """What may heat, by name; a current that is not recorded heats nothing."""
    rate = np.abs(drivers.rate)
    current = np.zeros_like(rate) if drivers.current_a is None else drivers.current_a
    moving = 1.0 - np.exp(-rate / (MOVING * max(float(np.percentile(rate, 99)), 1e-9)))
    torque = np.abs(drivers.load) * np.maximum(drivers.sine, 0.0)
    powers = {"friction": rate * np.abs(drivers.load), "speed": rate**2, "current": current**2, "moving": moving}
    return powers | ({"torque": rate * torque, "holding": torque**2} if drivers.levered else {})


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Strain with the measured temperature (at once or delayed), or with filtered friction and motor power."""
    sign, all_terms = nonlinear["sign"], []
    if nonlinear["measured"]:
        measured = np.zeros_like(drivers.motion) if drivers.temperature_c is None else drivers.temperature_c
        kelvin = drivers.smooth(measured)
        kelvin = kelvin - kelvin[0]
        all_terms.append(Term("at_once_mm_per_k", "length", sign * kelvin, "mm/K"))
        for tau_s in within(TIMES_S, nonlinear)[:4:2]:
            delayed = lowpass(kelvin, drivers.time_s, tau_s, 0.0)
            all_terms.append(Term(f"after_{tau_s:g}_s_mm_per_k", "length", sign * delayed, "mm/K"))
        return all_terms
    for name, power in _powers(drivers).items():
        usual = nonlinear.get(f"usual_{name}", 0.0)
        if usual == 0.0:
            continue
        for tau_s in within(TIMES_S, nonlinear):
            warm = remembered(power / usual, drivers, tau_s, nonlinear)
            all_terms.append(Term(f"{name}_{tau_s:g}_s_mm", "length", sign * warm))
            if tau_s > BEHIND_S:
                behind = remembered(warm, drivers, BEHIND_S, nonlinear)
                all_terms.append(Term(f"{name}_{tau_s:g}_s_behind_mm", "length", sign * behind))
    return all_terms


MECHANISM = Mechanism(
    id="thermal",
    driver="temperature",
    columns=("temperature", "heat"),
    equation="dx = -a (T - T0), dT/dt = (power - T)/tau where T is not measured",
    letters={
        "T": "the temperature; of a strength after_… it follows the measured one in the time in the name",
        "T0": "the temperature at the start",
        "a": "the strengths",
        "tau": "the time constant of each strength | in its name",
        "power": "the heat of the motion, from speed and load",
    },
    strengths=("a",),
    meanings={
        "measured": "1 means: it follows the measured temperature, and 0: one that is calculated from the motion",
        "usual_friction": "the mean of speed x load, {scale}",
        "usual_speed": "the mean of the speed squared, {scale}",
        "usual_current": "the mean of the motor's current squared, {scale}",
        "usual_moving": "about the share of the time in which it moves, {scale}",
        "usual_torque": "the mean of speed x load x sin(helix angle), {scale}",
        "usual_holding": "the mean of (load x sin(helix angle))^2, {scale}",
    },
    scale_units={
        "usual_friction": "10N turns/s",
        "usual_speed": "turns2/s2",
        "usual_current": "A2",
        "usual_torque": "10N turns/s",
        "usual_holding": "100N2",
    },
    source=(
        "Landau and Lifshitz, Theory of Elasticity, 1959 (thermal expansion); "
        "one heated node: Incropera and DeWitt, Fundamentals of Heat and Mass Transfer, 1996 (lumped capacitance)"
    ),
    confused_with="creep, plastic_elongation, sensor_drift",
    told_apart_by="another speed and a pause at the same load: only heat follows the power; or a thermocouple",
    meaning="the length follows the temperature.",
    sentence="The length follows {temperature}, by up to {span} ({size}), {times}.",
    details=("{at_once_mm_per_k}",),
    names={
        "friction": "the heat of speed x load",
        "speed": "the heat of the speed squared",
        "moving": "the heat of moving at any speed",
        "torque": "the heat of speed x torque",
        "holding": "the heat of the torque squared: a motor that holds is warmed by its current",
        "behind": "what is passed on later still",
    },
    optional=(LATER_RUNS, "usual_holding"),
    candidates=candidates,
    terms=terms,
)
