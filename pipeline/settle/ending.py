"""How a loop ended: `settled.json` and a line."""

import json
from collections.abc import Sequence
from pathlib import Path

from ..ground.files import write_text
from .choose import Budget
from .step import Place, Step

NAME = "settled.json"


def settled(place: Place, steps: Sequence[Step], runs: Sequence[Path], budget: Budget, why: str, sentence: str) -> None:
    """Write why the loop ended, the verdict of its last step, the runs and what was spent; and say it."""
    verdict, left = place.diagnosis(steps[-1].number), budget.left(steps)
    mechanisms = [entry["id"] for entry in verdict["mechanisms"]]
    spent = {"runs": budget.runs - left.runs, "strokes": budget.strokes - left.strokes}
    content = {
        "why": why,
        "sentence": sentence,
        "verdict": verdict["verdict"],
        "mechanisms": mechanisms,
        "alternatives": verdict["alternatives"],
        "runs": [str(run) for run in runs],
        "spent": {**spent, "minutes": round(budget.minutes - left.minutes, 3)},
    }
    write_text(place.out / NAME, json.dumps(content, indent=1, ensure_ascii=False) + "\n")
    named = f": {' + '.join(mechanisms)}" if mechanisms else ""
    print(f"settled: {sentence}{named if why == 'verdict' else ''}", flush=True)
