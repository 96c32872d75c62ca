"""Carry out the experiment that a tied verdict proposes: the same bench goes on where its recording ended."""

import argparse
import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from ..ground.errors import program
from ..ground.kinematics import Array
from ..rig.motion_commands import Commands
from ..run.run_yaml import RunYaml
from .case import Case
from .conceal import write_run
from .conceal_batch import drawn
from .nuisance import Recorded, late_s, record
from .perform import perform
from .plan import read
from .protocol import Protocol

SAME_LOAD = 0.02  # relative: what a load cell's noise makes of the same weight


@dataclass(frozen=True)
class Leg:
    """One part of the experiment: the motor goes evenly to a twist while a load hangs."""

    seconds: float
    motor_turns: float  # at the leg's end
    load_n: float


@dataclass(frozen=True)
class Continued(Protocol):
    """A protocol and the legs after it, in one go, so that every state is carried on."""

    legs: tuple[Leg, ...] = ()

    @cached_property
    def told(self) -> Commands:
        """The motion and the legs in steps of the rig."""
        first = super().told
        turns, load_n = [first.motor_turns], [first.load_n]
        for leg in self.legs:
            steps = max(round(leg.seconds / self.step_s), 1)
            turns.append(np.linspace(turns[-1][-1], leg.motor_turns, steps + 1)[1:])
            load_n.append(np.full(steps, leg.load_n))
        time_s: Array = np.arange(sum(map(len, turns)), dtype=np.float64) * self.step_s
        return Commands(time_s, np.concatenate(turns), np.concatenate(load_n), first.strokes_s)


def same_again(protocol: Protocol, seconds: float) -> tuple[Leg, ...]:
    """The last stroke again, as often as fits into about that many seconds, at least once."""
    stroke = protocol.motion.each()[-1]
    way_s = (stroke.top_turns - stroke.bottom_turns) / stroke.speed_turns_per_s
    legs = [Leg(way_s, stroke.top_turns, stroke.load_n), Leg(stroke.hold_s, stroke.top_turns, stroke.load_n)]
    legs += [Leg(way_s, stroke.bottom_turns, stroke.load_n), Leg(stroke.rest_s, stroke.bottom_turns, stroke.load_n)]
    lasting = [leg for leg in legs if leg.seconds > 0.0]
    return tuple(lasting * max(round(seconds / sum(leg.seconds for leg in lasting)), 1))


def weighed(case: Case, legs: Sequence[Leg]) -> bool:
    """Whether the second recording has a load channel: it has one if weights change."""
    usual_n = case.bench.loads_n[0]
    return case.load_cell or any(abs(leg.load_n / usual_n - 1.0) > SAME_LOAD for leg in legs)


def gone_on(case: Case, legs: Sequence[Leg], draw: int) -> Recorded:
    """Recording of the legs alone, its clock running on; noise of the case's kind, drawn afresh by `draw`."""
    protocol = Continued(case.protocol.kind, case.protocol.motion, case.protocol.rate_hz, tuple(legs))
    late_rng, noise_rng = (np.random.default_rng(child) for child in np.random.SeedSequence([case.seed, draw]).spawn(2))
    count = len(protocol.phases[0])
    late = late_s(case.nuisance, case.protocol.rate_hz, count, late_rng)
    performed = perform(case.bench, protocol, case.effects | case.always, late)
    load_cell = weighed(case, legs)
    whole = record(performed, case.nuisance, case.protocol.rate_hz, load_cell, case.thermocouple, noise_rng)
    after = (whole.table["time_s"] > case.protocol.told.time_s[-1]).to_numpy()
    rows = whole.table[after].reset_index(drop=True)
    return Recorded(rows, whole.error_mm[after], whole.wild[after], whole.stroke[after])


def described(case: Case, legs: Sequence[Leg], run: str) -> RunYaml:
    """Content of the second run.yaml: the same string, its strokes counted on."""
    content = case.bench.described(f"{run}-more", not weighed(case, legs))
    strokes_before = len(case.protocol.motion.each())
    content["string"] = {**(content["string"] or {}), "id": run, "strokes_before": strokes_before}
    return content


def proposed(path: Path) -> tuple[Leg, ...]:
    """Legs that a verdict asks for; none unless it is a tie, or when there is no verdict."""
    verdict = json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}
    if verdict.get("verdict") != "ambiguous":
        return ()
    return tuple(Leg(**leg) for leg in (verdict.get("next_run") or {}).get("legs", []))


@program
def main() -> None:
    """Write OUT/<run>/proposed/<run>-more/ and OUT/<run>/same/<run>-more/ for every tied case of a batch."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.proof.carry_on", description=__doc__)
    parser.add_argument("--cases", type=read, required=True, help="JSON, as pipeline.proof.plan writes it")
    parser.add_argument("--verdicts", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True, help="the folder of the added runs; required")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    for planned in arguments.cases:
        legs = proposed(arguments.verdicts / planned.run / "diagnosis.json")
        if not legs or planned.author:  # an author's string is not there for a second recording
            continue
        case = drawn(planned)
        ways = {"proposed": legs, "same": same_again(case.protocol, sum(leg.seconds for leg in legs))}
        for draw, (way, done) in enumerate(ways.items(), start=3):
            folder = arguments.out / planned.run / way / f"{planned.run}-more"
            write_run(described(case, done, planned.run), gone_on(case, done, draw).table, folder)
        print(f"{planned.run}: {len(legs)} legs carried out")


if __name__ == "__main__":
    main()
