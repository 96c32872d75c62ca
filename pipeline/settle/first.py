"""The first recording, if there is none yet: equal strokes within the limits, and the simulator's prediction."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np

from ..ground.errors import BadInput
from ..ground.kinematics import Array
from ..run.description import Run
from ..wire.motion import Leg, Limits
from .choose import SLOWER, Budget, leg_json
from .limits import EXAMPLE, OPTION, beyond
from .proposed import Curves, ProposedRun
from .step import Step

STROKES = (6, 5, 4)  # the most that limits and budget allow; fewer leave the diagnosis none to hold out
SPEEDS = (0.5, 1.0)  # of what is allowed: half of it leaves a later run a higher one
REST_S, HOLD_S, SPARE = 3.0, 0.5, 1.02  # SPARE: times the shortest time for a way
POINTS = 400  # of a curve
BY_HAND = "a first recording: at least four strokes from rest to rest"


def strokes(limits: Limits, count: int, share: float) -> list[Leg]:
    """Legs of that many equal strokes over the whole allowed twist, at a share of the allowed speed.

    The load stays as it hangs.
    """
    low, high = max(limits.turns[0], min(0.0, limits.turns[1])), limits.turns[1]
    way_s = SPARE * replace(limits, turns_per_s=share * limits.turns_per_s).way_s(high - low)
    to_begin_s = max(REST_S, SLOWER * limits.way_s(low - limits.at_turns))
    legs = [Leg(to_begin_s, low), Leg(REST_S, low)]
    for _ in range(count):
        legs += [Leg(way_s, high), Leg(HOLD_S, high), Leg(way_s, low), Leg(HOLD_S, low)]
    return [*legs, Leg(REST_S, low)]


def first_run(run: Run, limits: Limits | None, budget_left: Budget) -> ProposedRun:
    """The first recording in the form of a run of `next_runs.json`; without limits a person makes it, without legs.

    Raises BadInput where the limits or the budget leave no room for it.
    """
    if limits is None:
        return {"title": BY_HAND, "legs": [], "from": 0.0, "load": None}
    low, high = limits.turns
    if not high > max(low, 0.0):
        mend = f"allow twist above 0, as in {EXAMPLE}"
        raise BadInput(OPTION, "turns", f"leave nothing to wind: {low:g} to {high:g} turns", mend)
    why = ""
    for share in SPEEDS:
        for count in STROKES:
            legs = strokes(limits, count, share)
            title = f"a first recording: {count} equal strokes to {high:g} turns"
            entries = [leg_json(leg) for leg in legs]
            proposed: ProposedRun = {"title": title, "legs": entries, "from": limits.at_turns, "load": None}
            proposed["turns_per_s2"] = limits.turns_per_s2
            why = beyond(legs, limits) or budget_left.lacks(Step(0, "proposed", proposal=proposed)) or ""
            if not why:
                return {**proposed, "curves": foretold(run, legs, limits)}
    mend = "allow more seconds, minutes or strokes, or record it with the capture program"
    raise BadInput("settle", "first recording", f"does not fit in what is allowed: {why}", mend)


def foretold(run: Run, legs: list[Leg], limits: Limits) -> Curves:
    """The prediction for legs by `run.yaml`'s simulator without a mechanism: curves as in `next_runs.json`."""
    ends_s = np.cumsum([0.0, *(leg.seconds for leg in legs)])
    time_s = np.linspace(0.0, ends_s[-1], POINTS)
    turns = np.interp(time_s, ends_s, [limits.at_turns, *(leg.turns for leg in legs)])
    load_n = run.rig.get("load_n", sum(limits.load_n) / 2 if limits.load_n else 0.0)
    nominal_mm = simulated_mm(run, time_s, turns, load_n)
    return {
        "time_s": time_s.tolist(),
        "motor_turns": turns.tolist(),
        "load": [load_n] * POINTS,
        "calibrated": (nominal_mm - nominal_mm[0]).tolist(),
        "rivals": {},
    }


def simulated_mm(run: Run, time_s: Array, turns: Array, load_n: float) -> Array:
    """Displacement by the dimensions of `run.yaml` under one load. In mm, shape (samples,)."""
    system = run.system
    rate = np.gradient(turns, time_s)
    inputs = SimpleNamespace(
        time_s=time_s,
        motion=turns,
        rate=rate,
        acceleration=np.gradient(rate, time_s),
        load=np.full_like(turns, load_n / system.load_unit),
    )
    values = np.array([parameter.nominal for parameter in system.parameters(run)])
    return np.asarray(system.simulate(values, inputs, {}))
