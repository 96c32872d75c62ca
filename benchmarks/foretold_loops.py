"""Whether the loops that a verdict foretells of strokes at half the speed and under half the load are there then.

Concealed single effects on the poor protocol, by every author, each judged by a judge that does not know its author;
each string then makes these strokes. Source of the cases: `settled_ties.py`.
"""

import argparse
import sys
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import numpy as np
import pandas as pd
from kept_cases import kept_cases
from scipy.stats import binomtest
from settled_ties import Case, NotOnRig, asked, cases, recordings

from pipeline.diagnosis.proposal.expected import STROKES
from pipeline.diagnosis.proposal.legs import Rig
from pipeline.rig.authors.interface import OutOfReach

BINS = 30  # of the twist, over which both ways are compared
APART = 4.0  # noise floors, from which two foretold loops can be told apart in one stroke


def loop(table: pd.DataFrame, legs: Sequence[tuple[float, float, float]]) -> float:
    """By how much winding and unwinding part at most, in mm, in the stroke of `legs`: a way home, then four."""
    ends = np.cumsum([leg[0] for leg in legs])
    time_s, turns, reading = (table[name].to_numpy() for name in ("time_s", "motor_turns", "displacement_mm"))
    ways = []
    for leg in (2, 4):
        rows = (time_s > ends[leg - 1]) & (time_s < ends[leg])
        place = np.digitize(turns[rows], np.linspace(turns.min(), turns.max(), BINS + 1)[1:-1])
        ways.append(pd.Series(reading[rows]).groupby(place).mean())
    return float((ways[0] - ways[1]).abs().max())


def measured(case: Case) -> dict[str, Any]:
    """A case: what was named, and each loop as foretold by the two likeliest explanations and as it came."""
    line: dict[str, Any] = {**asdict(case), "verdict": "none", "loops": []}
    try:
        content, study, _ = asked(case, recordings(case, []))
        line |= {"verdict": content["verdict"], "named": [entry["id"] for entry in content["mechanisms"]]}
        known = content["evidence"].get("expected")
        if not known:
            return line
        rig, floor = Rig(study.problem.record), content["evidence"]["floor_mm"]
        for kind, (slower, share) in STROKES.items():
            key, legs = f"loop_{kind}_mm", [rig.home(), *rig.stroke(slower=slower, load=share)]
            if all(key in explanation for explanation in known["explanations"]):
                came = loop(recordings(case, [legs])[1][1], legs)
                told = {"+".join(explanation["ids"]): explanation[key] for explanation in known["explanations"][:2]}
                line["loops"].append({"kind": kind, "floor_mm": floor, "came_mm": came, "foretold_mm": told})
    except (OutOfReach, NotOnRig):
        pass
    return line


def told(lines: Sequence[dict[str, Any]]) -> str:
    """By how many noise floors the best explanation misses each loop; which of two comes nearer where they differ."""
    rows = ["| stroke | loops | missed by, noise floors (median, nine of ten) |", "|---|---|---|"]
    loops = [(line, each) for line in lines for each in line["loops"]]
    for kind in STROKES:
        missed = [
            abs(next(iter(each["foretold_mm"].values())) - each["came_mm"]) / each["floor_mm"]
            for line, each in loops
            if each["kind"] == kind and [line["effect"]] == line["named"]
        ]
        middle, most = np.percentile(missed, [50, 90]) if missed else (np.nan, np.nan)
        rows.append(f"| {kind.replace('_', ' ')}, rightly named | {len(missed)} | {middle:.1f}, {most:.1f} |")
    for right in (True, False):
        nearer, several = 0, 0
        for line, each in loops:
            values = list(each["foretold_mm"].values())
            if ([line["effect"]] == line["named"]) is right and len(values) > 1:
                best, other = values
                if abs(best - other) >= APART * each["floor_mm"]:
                    several += 1
                    nearer += abs(best - each["came_mm"]) < abs(other - each["came_mm"])
        low, high = binomtest(nearer, several).proportion_ci(method="exact") if several else (0.0, 1.0)
        name = "rightly named" if right else "named otherwise"
        rows.append(
            f"{name}, two foretold loops apart: the best is nearer in {nearer} of {several} ({low:.2f} to {high:.2f})"
        )
    return "\n".join(rows)


def main() -> None:
    """Measure case by case, keep each in a file, and print the table; what the file has is not measured again."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=810_000)
    parser.add_argument("--cases", type=int, default=60, help="of the drawn order")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE", help="measured cases (.jsonl)")
    options = parser.parse_args()
    print(told(kept_cases(cases(options.seed)[: options.cases], options.out, measured)))


if __name__ == "__main__":
    main()
