"""A rounded loop by direction that grows with load or twist: friction of strands and guides."""

import numpy as np

from ...ground.kinematics import Array
from ..numerics.recursions import play
from ..recording.drivers import Drivers
from .interface import Mechanism, Nonlinear, Term
from .plain_drag import drag, drag_along, leaves
from .shared_laws import grid, share_of_travel, travelled

DRY = (0.003, 0.01, 0.03, 0.1)  # of the highest rate: below it what slides without a string begins to stick
STOPS = (0.004, 0.012, 0.03, 0.08, 0.2)  # of the range: half-widths of the stops that add up to a loop
ROUNDINGS = ((0.005, 0.02), (0.02, 0.06), (0.06, 0.2))  # of the range: a drive's loop has two stops, out of these
ELEMENTS = {"share": 1.0, "inner_share": 0.4}  # of the widest play: how wide each play of a loop on the twist is
WIDTHS = {"sharp": "half_turns", "round": "wide_half_turns"}
ALONG = 0.7  # of the mean square with the same friction everywhere: friction along the travel must leave less
SLOW = (0.02, 0.1)  # of the highest rate: below it a string's dry friction closes its loop
SLACK_LOAD = 0.5  # load units: a cable that hangs loose yields more to the same friction
TOTALS = {
    "mm": "half_loop_mm", "load_mm_per_10_n": "half_loop_mm_per_10_n", "slack_mm": "half_loop_slack_mm",
    "near_mm": "half_loop_near_mm", "middle_mm": "half_loop_middle_mm", "far_mm": "half_loop_far_mm",
}  # fmt: skip


def candidates(drivers: Drivers) -> list[Nonlinear]:
    """Stretch, by stops of every width, or of two widths without twist; or a play of twist that grows with load.

    Where nothing is twisted it may also be dry alone: open at once, closed at rest. `loaded`: whether the recording
    can tell a loop that follows the load from one that does not.
    """
    fastest = float(np.percentile(np.abs(drivers.rate), 99))
    loaded = float(drivers.loaded)
    if not drivers.levered:
        travel = travelled(drivers) if drivers.velocity is None else {}
        dry = [{**kind, "loaded": loaded, **travel} for kind in _dry(drivers)]
        pairs = [(float(f"{a * drivers.span:.6g}"), float(f"{b * drivers.span:.6g}")) for a, b in ROUNDINGS]
        return [*({"half_turns": a, "wide_half_turns": b, "loaded": loaded, **travel} for a, b in pairs), *dry]
    span, top = (float(f"{value:.6g}") for value in (drivers.span, fastest))
    stretch = [{"span_turns": span, "fastest_turns_per_s": top, "loaded": loaded}]
    usual = float(f"{max(float(np.median(drivers.load)), 1e-3):.6g}")
    plays = [
        {**nonlinear, "usual_load": usual}
        for nonlinear in grid("play_turns", 1e-3 * drivers.span, 0.1 * drivers.span, 14)
    ]
    return [*stretch, *plays]


def suggest(drivers: Drivers, residual: Array, predicted: Array) -> list[Nonlinear]:
    """Dry friction that changes along the travel, where the reading follows derivatives and such friction shows.

    The residual has the shape (samples,), in the reading's unit.
    """
    if drivers.velocity is None:
        return []
    drag_columns = [*drag(drivers), np.ones_like(drivers.motion)]
    if leaves(residual, [*drag_columns, *drag_along(drivers)]) > ALONG * leaves(residual, drag_columns):
        return []
    return [{**kind, "loaded": float(drivers.loaded), **travelled(drivers)} for kind in _dry(drivers)]


def _dry(drivers: Drivers) -> list[Nonlinear]:
    """Rates at which dry friction closes its loop, from shares of the highest rate."""
    fastest = float(np.percentile(np.abs(drivers.rate), 99))
    return [{"slow_turns_per_s": float(f"{share * fastest:.6g}")} for share in DRY]


def terms(drivers: Drivers, nonlinear: Nonlinear) -> list[Term]:
    """Stretch by a memory of direction, growing with load, with load and twist, or not at all; or lost twist.

    A loop that grows with the twist alone is a play of constant width, and not friction's. Without a lever that
    changes there is no twist to grow with.
    """
    if "play_turns" in nonlinear:
        width = nonlinear["play_turns"] * np.maximum(drivers.load / nonlinear["usual_load"], 0.0)
        lost = play(drivers.motion, width) - drivers.motion
        half = play(drivers.motion, ELEMENTS["inner_share"] * width) - drivers.motion
        return [Term("share", "twist", lost, "1", high=1.25), Term("inner_share", "twist", half, "1", high=1.25)]
    if "slow_turns_per_s" in nonlinear:
        sides = {"dry": np.tanh(drivers.rate / nonlinear["slow_turns_per_s"])}
    elif "half_turns" in nonlinear:
        sides = {name: drivers.directed(nonlinear[key]) for name, key in WIDTHS.items()}
    else:
        sides = {f"stop_{share:g}": drivers.directed(share * nonlinear["span_turns"]) for share in STOPS}
    all_terms = []
    for name, side in sides.items():
        all_terms += [
            Term(f"{name}_{key}", "resistance", side * size, "mm/10N" if "10_n" in key else "mm", total=TOTALS.get(key))
            for key, size in {**envelopes(drivers, bool(nonlinear["loaded"])), **along(drivers, nonlinear)}.items()
        ]
    if "fastest_turns_per_s" in nonlinear:
        for share in SLOW:
            side = np.tanh(drivers.rate / (share * nonlinear["fastest_turns_per_s"]))
            all_terms.append(Term(f"dry_{share:g}_mm", "resistance", side))
            all_terms.append(
                Term(f"dry_{share:g}_twist_mm_per_10_n", "resistance", side * drivers.load * drivers.tangent, "mm/10N")
            )
    return all_terms


def half_loop(values: Nonlinear) -> float:
    """Half the width of a loop on the twist at the usual load, in turns: each play by its share; 0 of other loops."""
    return values.get("play_turns", 0.0) * sum(wide * values.get(name, 0.0) for name, wide in ELEMENTS.items())


def envelopes(drivers: Drivers, loaded: bool) -> dict[str, Array]:
    """The height of a loop, by name: the same everywhere, or growing with load, or with load and twist.

    Each of shape (samples,), a factor without a unit.
    """
    load, slope = drivers.load, drivers.tangent
    envelope_by_unit = {"mm": np.ones_like(load)}
    if drivers.levered:
        envelope_by_unit["load_twist_mm_per_10_n"] = load * slope
        envelope_by_unit["load_steep_mm_per_10_n"] = load * slope**3
    if loaded and drivers.levered:
        envelope_by_unit["root_load_twist_mm"] = np.sqrt(np.abs(load)) * slope
    if loaded:
        envelope_by_unit["load_mm_per_10_n"] = np.abs(load)
    if loaded and not drivers.levered:
        envelope_by_unit["slack_mm"] = np.exp(-np.abs(load) / SLACK_LOAD)
    return envelope_by_unit


def along(drivers: Drivers, nonlinear: Nonlinear) -> dict[str, Array]:
    """Weights of a loop's height at the beginning, in the middle and at the end of the travel, by name.

    Cables wrap further around what guides them at one place than at another. Each of shape (samples,), a factor
    without a unit: Bernstein polynomials of the share of the travel, so that the loop is nowhere less than nothing.
    """
    if "from_turns" not in nonlinear:
        return {}
    share = share_of_travel(drivers, nonlinear)
    return {"near_mm": np.square(1.0 - share), "middle_mm": 2.0 * share * (1.0 - share), "far_mm": np.square(share)}


MECHANISM = Mechanism(
    id="friction_hysteresis",
    driver="direction x load",
    columns=("direction x load",),
    equation="dx = -sum k_i f_i g_i s_i, s_i: stop operators of the twist (Prandtl-Ishlinskii), or its direction",
    letters={
        "F_0": "usual_load",
        "a_i": "how much of each play counts: share and inner_share",
        "b_i": "how wide each play is, as a share of w | 1 and 0.4",
        "f_i": "how an element grows with the load: not at all, with the load, or with its root | by its name",
        "g_i": "how it grows with the helix angle: the words `twist` and `steep` in the names | by its name",
        "k_i": "the strengths",
        "play": "the twist that follows once the play is taken up",
        "s_i": "a stop, which turns with the direction, or the direction itself, which is 0 at rest | -1 to 1",
        "w": "play_turns",
    },
    plain_equation="h s; h: half the loop, s: the direction of motion, from -1 to 1, rounded where it turns",
    strengths=("a_i", "h", "k_i"),
    meanings={
        "fastest_turns_per_s": "the highest speed of the recording, {scale}",
        "half_turns": "half the width of the narrow stop that rounds the loop",
        "play_turns": "half the width of the widest play at the usual load",
        "usual_load": "the load at which the widths hold: they grow in proportion to the load",
        "wide_half_turns": "half the width of the wide stop that rounds the loop",
    },
    source=(
        "Visintin, Differential Models of Hysteresis, 1994 (Prandtl-Ishlinskii); Armstrong-Helouvry, Dupont and "
        "Canudas de Wit, Automatica 30, 1994 (along the travel too)"
    ),
    confused_with="backlash, sensor_lag, viscous_loss",
    told_apart_by="two loads (backlash does not follow the load) and two speeds (a lag follows the speed)",
    meaning="winding and unwinding differ by a rounded loop that grows with load or twist.",
    sentence="Friction makes the {reading} of {up} differ from that of {down}, by {loop} ({size}).",
    details=(
        "half the loop is {half_loop_mm}",
        "half the loop grows by {half_loop_mm_per_10_n}",
        "half the loop is larger by {half_loop_slack_mm} where nothing loads it",
        "half the loop is larger by {half_loop_near_mm} where the motion begins",
        "half the loop is larger by {half_loop_far_mm} where the motion ends",
        "half the loop is larger by half of {half_loop_middle_mm} in the middle of the motion",
        "half the width of the loop is {half_loop_turns} at {usual_load_n}",
    ),
    derived={"half_loop_turns": half_loop},
    variants={"play_turns": "theta_s = theta + sum a_i (play(theta, b_i w F/F_0) - theta)"},
    names={
        "share": "the play of the whole width (b = 1)",
        "inner_share": "the play of 0.4 of the width (b = 0.4)",
        "stop": "the state of a stop, from -1 to 1, as wide as that share of the range",
        "dry": "the direction, closed below that share of the highest speed",
        "load": "the load",
        "load_twist": "load x tan(helix angle)",
        "dry_*_twist": "load x tan(helix angle) x direction, closed below that share of the highest speed",
        "load_steep": "load x tan(helix angle)^3",
        "near": "(1 - share of the travel)^2",
        "middle": "2 x share of the travel x (1 - share of the travel)",
        "far": "(share of the travel)^2",
        "root_load_twist": "the root of the load, x tan(helix angle)",
    },
    candidates=candidates,
    remembers_turns=True,
    terms=terms,
    suggest=suggest,
)
