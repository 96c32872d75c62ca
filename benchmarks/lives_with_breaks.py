"""How often `at least N strokes left` holds of strings whose creep comes back in breaks, with and without recovery.

    python benchmarks/lives_with_breaks.py --strings 60 --seed 5     # the numbers of docs/lifespan.md, in minutes

Wear is that of `tests/lifespan/made_life.py`. Creep is one exponential, two, or a logarithm of the strokes since the
break, of which a break takes 60 to 100 % back: formulas of this file alone. A string is asked at up to five strokes,
where breaks tell recovery. *As wear* is the forecast that takes all of it for wear.
"""

import argparse
import sys
from pathlib import Path
from types import SimpleNamespace

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "lifespan"))

import numpy as np
import pandas as pd
from made_life import worn

from pipeline.lifespan.forecast import life_questions
from pipeline.lifespan.forecast.strokes_left import first_passed
from pipeline.lifespan.stroke_health.recovery import NO_BREAK, recovery

STROKES, LIMIT_MM, NOISE_MM, REFERENCE = 1500, 1.0, 0.004, 3
LEAST_ASKED, MOST_ASKED = 15, 400  # strokes
WAYS = {"with recovery": recovery, "as wear": lambda strokes: NO_BREAK}


def creep_mm(kind: str, a_run: int, rng: np.random.Generator) -> np.ndarray:
    """Creep at each stroke, shape (strokes,), in mm; every `a_run` strokes a break takes a share of it back."""
    size_mm, back = rng.uniform(0.1, 0.8), rng.uniform(0.6, 1.0)
    life = a_run * 10 ** rng.uniform(-1.0, 0.5)
    lives = np.array([life, life * rng.uniform(3.0, 10.0)])
    shares = np.array([0.6, 0.4]) if kind == "two exponentials" else np.array([1.0, 0.0])
    parts_mm, since, creep = np.zeros(2), 0.0, np.zeros(STROKES)
    for stroke in range(STROKES):
        if stroke and stroke % a_run == 0:
            parts_mm, since = parts_mm * (1.0 - back), since ** (1.0 - back) if since > 1.0 else 0.0
        since += 1.0
        parts_mm = parts_mm + (size_mm * shares - parts_mm) * -np.expm1(-1.0 / lives)
        logarithm = 0.5 * size_mm * np.log1p(since / (0.2 * a_run))
        creep[stroke] = logarithm if kind == "logarithm" else parts_mm.sum()
    return creep


def one_string(rng: np.random.Generator) -> list[dict[str, object]]:
    """The answers on one string, each beside the strokes that were truly left."""
    n, loss = worn(rng, STROKES)
    wear_mm = 10.0 * loss * rng.choice([1.0, 0.5, 0.05], p=[0.5, 0.3, 0.2])
    kind, a_run = str(rng.choice(["exponential", "two exponentials", "logarithm"])), int(rng.integers(4, 25))
    longer_mm = wear_mm + creep_mm(kind, a_run, rng)
    off_mm = np.abs(np.abs(longer_mm - longer_mm[:REFERENCE].mean()) + NOISE_MM * rng.standard_normal(STROKES))
    runs = [f"r{stroke // a_run}" for stroke in range(STROKES)]
    table = pd.DataFrame({"run": runs, "stroke": n.astype(int), "model_error_mm": off_mm, "rest_mm": -longer_mm})
    table = table.assign(
        stroke_mm=10.0, model_error_mm_error=NOISE_MM, rest_mm_error=NOISE_MM, stroke_mm_error=NOISE_MM
    )
    passed = first_passed(n[REFERENCE:], off_mm[REFERENCE:], LIMIT_MM)
    end, answers = passed if np.isfinite(passed) else float(STROKES), []
    for asked in (int(2.6 * a_run), int(3.5 * a_run), int(5.2 * a_run), int(0.5 * end), int(0.75 * end)):
        young = table[table["stroke"] <= asked]
        if not LEAST_ASKED <= asked <= min(MOST_ASKED, end - 1.0) or not recovery(young).is_known:
            continue
        for way, breaks in WAYS.items():
            life_questions.recovery = breaks
            span = life_questions.model_error(SimpleNamespace(strokes=young), LIMIT_MM).left.span(0.9)
            left, is_open = end - asked, not np.isfinite(passed)
            holds = True if span.low <= left else None if is_open else False  # open: the record ends before it is told
            error = abs(span.median - left) / left if not is_open and np.isfinite(span.median) else np.nan
            answers.append({"way": way, "kind": kind, "holds": holds, "median_off": error})
    return answers


def main() -> None:
    """Ask the strings, and print how often the lower bound held and how far the median is off."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--strings", type=int, default=60, help="default: 60")
    parser.add_argument("--seed", type=int, default=5, help="default: 5")
    arguments = parser.parse_args()
    rng = np.random.default_rng(arguments.seed)
    table = pd.DataFrame([answer for _ in range(arguments.strings) for answer in one_string(rng)])
    for way, part in table.groupby("way", sort=False):
        judged = part["holds"].dropna().astype(bool)
        off = part["median_off"].median()
        print(f"{way}: {len(part)} asked, `at least` held in {judged.sum()} of {len(judged)}, median off by {off:.2f}")


if __name__ == "__main__":
    main()
