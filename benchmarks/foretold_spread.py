"""How many true values lie in the intervals of what a verdict foretells of other strokes.

Concealed single effects on the poor protocol, by four authors, each judged by a judge that does not know its author;
the true values are those of the author's rig, whose instruments read without noise once the protocol is over.
"""

import argparse
import importlib
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import numpy as np
from kept_cases import kept_cases
from scipy.stats import binomtest
from settled_ties import RIG, Case, NotOnRig, asked, cases, recordings

from pipeline.diagnosis import verdict
from pipeline.diagnosis.proposal.expected import DOWN, DWELL, STROKES, UP
from pipeline.diagnosis.proposal.legs import Leg, Rig
from pipeline.rig.authors.interface import OutOfReach

INSTRUMENTS = {
    "workshop.recording": ("working_on", "noise_mm", "step_mm"),
    "lattice.recording": ("sampling_on", "noise_mm", "quantum_mm"),
    "kinetics.recording": ("logging_on", "noise_mm", "step_mm"),
    "mechanics.making": ("noise_on", "reading_mm", "resolution_mm"),
}  # by an author's module: what lets the instruments go on, and what they call their noise and their resolution
FINE_MM = 1e-5
PLACES = np.linspace(0.01, 0.99, 120)  # shares of the way, at which both directions are compared
SEEN = 2.0  # noise floors, from which a person sees a loop
Legs = list[np.ndarray]


def quiet(goes_on: Callable[..., Any], noise: str, step: str) -> Callable[..., Any]:
    """What lets instruments go on, without noise in what comes."""

    def without_noise(before: Any, longer: Any) -> Any:
        after = goes_on(before, longer)
        clean = getattr(after, noise).copy()
        clean[len(getattr(before, noise)) :] = 0.0
        return replace(after, **{noise: clean, step: FINE_MM})

    return without_noise


@contextmanager
def silence() -> Iterator[None]:
    """Rigs whose instruments read without noise, rounding and wild values after the protocol."""
    held = []
    for name, (goes_on, noise, step) in INSTRUMENTS.items():
        module = importlib.import_module(f"pipeline.rig.authors.{name}")
        held.append((module, goes_on, getattr(module, goes_on)))
        setattr(module, goes_on, quiet(getattr(module, goes_on), noise, step))
    module = importlib.import_module("pipeline.rig.authors.kinetics.recording")
    held.append((module, "with_outliers", module.with_outliers))
    module.with_outliers = lambda chance, reading_mm, floor_mm: reading_mm
    try:
        yield
    finally:
        for module, name, value in held:
            setattr(module, name, value)


def along(case: Case, legs: list[Leg]) -> tuple[Legs, Legs]:
    """The true reading in mm and the motion in turns over each leg, each of shape (samples of the leg,)."""
    with silence():
        table = recordings(case, [legs])[1][1]
    time_s, turns, reading = (table[name].to_numpy() for name in ("time_s", "motor_turns", "displacement_mm"))
    at = np.searchsorted(time_s, np.cumsum([leg[0] for leg in legs])[:-1], side="right")
    return np.split(reading, at), np.split(turns, at)


def loop_mm(reading: Legs, motion: Legs) -> float:
    """By how much both ways of a stroke part at most at one motion."""
    low, high = max(motion[way].min() for way in (UP, DOWN)), min(motion[way].max() for way in (UP, DOWN))
    places = low + PLACES * (high - low)
    order = {way: np.argsort(motion[way], kind="stable") for way in (UP, DOWN)}
    up, down = (np.interp(places, motion[way][order[way]], reading[way][order[way]]) for way in (UP, DOWN))
    return float(np.abs(up - down).max())


def true_mm(case: Case, rig: Rig, known: dict[str, Any]) -> dict[str, float]:
    """What the rig truly does, by the keys of the numbers that are foretold."""
    values = {}
    for kind, (slower, load) in STROKES.items():
        values[f"loop_{kind}_mm"] = loop_mm(*along(case, [rig.home(), *rig.stroke(slower=slower, load=load)]))
    if "strokes" in known:
        reading, _ = along(case, [rig.home(), *(rig.stroke() * known["strokes"])])
        values["top_mm"] = float(reading[-2][-1] - reading[DWELL][-1])
    if "stand_s" in known:
        reading, _ = along(case, [rig.home(), *rig.stroke(dwell_s=known["stand_s"]), *rig.rest(known["stand_s"])])
        for key, leg in (("hold_mm", reading[DWELL]), ("rest_mm", reading[-1])):
            values[key] = float(leg[-1] - leg[0])
    return values


def measured(case: Case) -> dict[str, Any]:
    """A case: what was named, and each number of the best explanation, foretold, with its interval, and true."""
    line: dict[str, Any] = {**asdict(case), "verdict": "none", "numbers": []}
    try:
        content, study, _ = asked(case, recordings(case, []))
        line |= {"verdict": content["verdict"], "named": [entry["id"] for entry in content["mechanisms"]]}
        known = content["evidence"].get("expected")
        if known:
            best, floor = known["explanations"][0], content["evidence"]["floor_mm"]
            true = true_mm(case, Rig(study.problem.record), known)
            line["numbers"] = [
                {"key": key, "foretold": best[key], "half": half, "true": true[key], "floor": floor}
                for key, half in best.get("plus_minus", {}).items()
            ]
    except (OutOfReach, NotOnRig):
        pass
    return line


def shares(lines: Sequence[dict[str, Any]]) -> str:
    """How many true values lie inside, rightly named cases and others, with exact 95 % intervals."""
    rows = ["| numbers | cases | inside | share (95 %) |", "|---|---|---|---|"]
    for right in (True, False):
        some = [line for line in lines if line["numbers"] and (line["named"] == [line["effect"]]) is right]
        groups = {
            "loops": lambda each: each["key"].startswith("loop"),
            "loops of two noise floors or more": lambda each: (
                each["key"].startswith("loop") and max(each["true"], each["foretold"]) >= SEEN * each["floor"]
            ),
            "holds, rests, more strokes": lambda each: not each["key"].startswith("loop"),
        }
        for name, chosen in groups.items():
            numbers = [(line["seed"], each) for line in some for each in line["numbers"] if chosen(each)]
            inside = sum(abs(each["true"] - each["foretold"]) <= each["half"] for _, each in numbers)
            if numbers:
                low, high = binomtest(inside, len(numbers)).proportion_ci(method="exact")
                share = f"{inside / len(numbers):.2f} ({low:.2f} to {high:.2f})"
                who = "rightly named" if right else "named otherwise"
                count = len({seed for seed, _ in numbers})
                rows.append(f"| {name}, {who} | {count} | {inside} of {len(numbers)} | {share} |")
    return "\n".join(rows)


def main() -> None:
    """Measure case by case, keep each in a file, and print the table; what the file has is not measured again."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=970_000)
    parser.add_argument("--cases", type=int, default=54, help="of the drawn order")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE", help="measured cases (.jsonl)")
    options = parser.parse_args()
    verdict.next_experiment = lambda study, run: None  # it takes long, and changes nothing of what is foretold
    drawn = [case for case in cases(options.seed) if case.author != RIG]
    print(shares(kept_cases(drawn[: options.cases], options.out, measured)))


if __name__ == "__main__":
    main()
