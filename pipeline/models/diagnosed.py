"""The diagnosed simulator: eqs 1–4 with the physics that the diagnosis finds missing in the training points.

Every run of a string is diagnosed alone, as a recording that has holes where points are held out. What is predicted
depends on what was done before: the simulator goes through the motion of the training points and of the points asked.
A run of which no training points were seen is simulated by the nominal equations.

Source: Kennedy and O'Hagan, "Bayesian calibration of computer models", Journal of the Royal Statistical Society B 63,
2001 (a simulator and what it lacks); of each mechanism: docs/physics.md.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import numpy as np
import pandas as pd
from pydantic import Field, field_validator

from ..diagnosis import faint_recordings
from ..diagnosis.choice import cross_validation, kept, outcome
from ..diagnosis.choice.candidates import apart
from ..diagnosis.choice.search import LARGEST, TRIED
from ..diagnosis.fit import calibrate
from ..diagnosis.fit.problem import State
from ..diagnosis.mechanisms import library
from ..diagnosis.study import engine
from ..ground.errors import BadInput
from ..ground.kinematics import Array, point_contraction_mm, point_motor_turns
from ..run.description import Run
from .about import About
from .parts.diagnosed.diagnosed_problem import SAMPLES, holed, plain
from .parts.diagnosed.diagnosed_run import Simulator
from .parts.saved import read_json, write_json
from .parts.settings import checked

FOUND_BY_NAME = ("pipeline.diagnosis.*", "pipeline.systems.*")  # at run time; for its fingerprint
FORESEEING = 10  # explanations that are tried, those first that foresee best
MIDDLE, HELD_BACK = 0.5, 0.12  # of every winding, hold and unwinding: parts that are held back, at its end too
UNDONE_TURNS = 0.02  # rms by which an inverse may miss what its forward map made
LEAST_POINTS = 20  # in which a stroke can be seen at all; a run with fewer stays nominal
KNOWN = ["time_s", "stroke", "phase", "motor_turns", "load_n"]
TOLERANCES = {
    "radius": "radius_tolerance", "length_mm": "length_tolerance_mm",
    "torsion_zone_mm": "torsion_zone_tolerance_mm", "separator_mm": "separator_tolerance_mm",
}  # fmt: skip


@checked
class Settings:
    """Settings: which mechanisms the library shall lack.

    Heat follows the whole motion: where an inverse seeks a part of it, each error of the part feeds the next.
    """

    without: Annotated[tuple[str, ...], Field(strict=False)] = ("thermal",)

    @field_validator("without")
    @classmethod
    def _known(cls, ids: tuple[str, ...]) -> tuple[str, ...]:
        strange = sorted(set(ids) - set(library.mechanisms()))
        if strange:
            raise ValueError(f"{strange[0]} is no mechanism; use {', '.join(library.mechanisms())}")
        return ids


class Diagnosed:
    """A simulator for every known run of a string, by run and string; it never names an id in `without`."""

    def __init__(self, **settings: object) -> None:
        self.without = frozenset(Settings(**settings).without)  # type: ignore[arg-type]
        self.simulators: dict[tuple[str, str], Simulator] = {}

    def fit(self, points: pd.DataFrame, seed: int) -> None:
        """Diagnose every run of every string in the points; nothing is drawn by the seed."""
        enough = [(key, rows) for key, rows in _by_run(points) if len(rows) >= LEAST_POINTS]
        self.simulators = {key: simulator_of(points.iloc[rows], self.without) for key, rows in enough}

    def forward(self, points: pd.DataFrame) -> Array:
        """Contraction in mm, shape (points,), with the points asked together as parts of one motion."""
        return self._each(points, Simulator.forward, point_contraction_mm)

    def inverse(self, points: pd.DataFrame) -> Array:
        """Twist in turns, shape (points,), with the points asked together as parts of one motion."""
        return self._each(points, Simulator.inverse, point_motor_turns)

    def save(self, path: Path) -> None:
        """Write all simulators as JSON: the effects that each names, its numbers, and its training motion."""
        saved = [{"string": string, **simulator.saved()} for (_, string), simulator in self.simulators.items()]
        write_json(path, {"without": sorted(self.without), "simulators": saved})

    def load(self, path: Path) -> None:
        """Take over the simulators of a JSON file."""
        content = read_json(path)
        self.without = frozenset(Settings(without=content["without"]).without)
        strings = [entry.pop("string") for entry in content["simulators"]]
        simulators = map(Simulator.from_saved, content["simulators"])
        self.simulators = {(loaded.run.run, string): loaded for string, loaded in zip(strings, simulators, strict=True)}

    def _each(
        self, points: pd.DataFrame, by_simulator: Callable[[Simulator, pd.DataFrame], Array],
        by_nominal: Callable[[pd.DataFrame], Array],
    ) -> Array:  # fmt: skip
        """The prediction of each run's simulator for its points, or of the nominal equations, shape (points,)."""
        answer = np.empty(len(points))
        for key, rows in _by_run(points):
            group_points, simulator = points.iloc[rows], self.simulators.get(key)
            answer[rows] = by_simulator(simulator, group_points) if simulator else by_nominal(group_points)
        return answer


def _by_run(points: pd.DataFrame) -> list[tuple[tuple[str, str], Array]]:
    """Rows of the points of every run of every string, by run and string."""
    groups = points.groupby(["run", "string"], sort=True).indices
    return [((str(run), str(string)), rows) for (run, string), rows in groups.items()]


def run_of(points: pd.DataFrame) -> Run:
    """The `run.yaml` of a run, as far as a diagnosis needs it, from the points' columns."""
    row = points.iloc[0]
    rig = {name: float(row[name]) for name in ("torsion_zone_mm", "separator_mm") if np.isfinite(row[name])}
    tolerance = {key: float(row[name]) for key, name in TOLERANCES.items()}
    string = {key: float(row[key]) for key in ("radius_mm", "length_mm", "stiffness_n_per_mm")}
    content = {"run": str(row["run"]), "actuator": str(row["actuator"]), "string": {"material": "string", **string}}
    return Run.model_validate({**content, "rig": rig, "tolerance": tolerance})


def simulator_of(points: pd.DataFrame, without: frozenset[str]) -> Simulator:
    """The simulator of one string's run, fitted to its training points, however little they show."""
    ordered = points.sort_values("time_s", kind="stable").drop_duplicates("time_s").reset_index(drop=True)
    run, samples = run_of(ordered), ordered[SAMPLES]
    try:
        studied = engine.study(holed(run, samples, without))
        faint_recordings.refuse_faint(studied, Path(run.run))
    except (BadInput, np.linalg.LinAlgError) as error:  # too little to decide anything is enough to calibrate
        base = calibrate.base(plain(run, samples, float(samples["time_s"].iloc[0])))
        alone = (base.values.tolist(), float(base.zeros[0]))
        return Simulator(run, ordered[KNOWN], str(error), [], *alone, base.acts, 0.0, alone)
    explained = studied.verdict in ("explained", "ambiguous")
    named = [list(explanation.ids) for explanation in studied.sets] if explained else []

    def simulator(state: State) -> Simulator:
        level_mm = float(np.mean(studied.problem.simulate(state)))
        return Simulator(
            run, ordered[KNOWN], studied.verdict, named, state.values.tolist(), float(state.zeros[0]), state.acts,
            level_mm,
            (studied.base.values.tolist(), float(studied.base.zeros[0])),
        )  # fmt: skip

    if not explained:
        return simulator(studied.base)
    tried: list[tuple[float, Simulator]] = []
    for state in foreseeing(studied):
        first = simulator(state)
        tried.append((undone(first), first))
        if tried[-1][0] < UNDONE_TURNS:
            return first
    return min(tried, key=lambda pair: pair[0])[1]


def undone(simulator: Simulator) -> float:
    """The rms difference in turns between the motion and its inverse after forward, on parts of each motion held back.

    What acts by a motor's speed, or by the heat of its work, needs a motion that is known better than its ends tell.
    """
    samples = simulator.known
    place = samples.groupby(["stroke", "phase"]).cumcount() / samples.groupby(["stroke", "phase"])["time_s"].transform(
        "size"
    )
    back = (np.abs(place - MIDDLE) < HELD_BACK).to_numpy() | (place > 1.0 - HELD_BACK).to_numpy()
    back_points, rest = samples[back], replace(simulator, known=samples[~back])
    if not back.any():
        return 0.0
    placed = back_points.assign(displacement_mm=rest.forward(back_points), motor_turns=np.nan)
    return float(np.sqrt(np.mean(np.square(rest.inverse(placed) - back_points["motor_turns"].to_numpy(float)))))


def foreseeing(studied: outcome.Study) -> Iterator[State]:
    """The simulators that best predict left-out stretches, chosen from the tied explanations and the best of each size.

    A name should be as simple as a recording allows; a prediction need not.
    """
    search = studied.search
    beside = [explanation for size in range(1, LARGEST + 1) for explanation in search.all_of(size)[:TRIED]]
    tried = list({explanation.keys: explanation for explanation in [*studied.sets, *beside]}.values())
    errors = cross_validation.left_out_errors(search.linear, tried)
    good = tried[int(np.argmin(errors))].ids
    if len(good) < LARGEST:  # what foresees best may have been too far behind to be searched on
        sets = [(*good, id_) for id_ in search.linear.catalogue if id_ not in good]
        more = [search.explain(ids) for ids in sets if apart(ids)]
        tried, errors = [*tried, *more], [*errors, *cross_validation.left_out_errors(search.linear, more)]
    for place in np.argsort(errors, kind="stable")[:FORESEEING]:
        state = studied.best if tried[place] is studied.sets[0] else kept.at_work(search, tried[place])
        if not outcome.cancels(studied.problem, state):
            yield state
    yield studied.best


MODEL = Diagnosed
ABOUT = About(needs_motion=True)
