"""The files of one string's answer: lifespan.json and lifespan.png, and the older answer that they replace."""

import json
from pathlib import Path

from ..ground.errors import BadInput
from ..ground.stored.files import write_text
from ..ground.stored.regular_file import read_regular
from . import as_json, figure
from .forecast.life_questions import Answer
from .stroke_health.health import Health

LARGEST = 10_000_000  # bytes of a lifespan.json
SHOWN = 6  # runs that are named


def write(health: Health, answers: list[Answer], level: float, out: Path) -> list[str]:
    """Write both into the string's folder in `out`; says where they are and what they replace."""
    path, picture = (out / health.string / name for name in ("lifespan.json", "lifespan.png"))
    before = runs_of(path)
    write_text(path, json.dumps(as_json.lifespan(health, answers, level), indent=1) + "\n")
    figure.page(health, answers, level, picture)
    lines = [f"Written: {path} and {picture}."]
    if before and set(before) != set(health.runs):
        made_of = ", ".join(before[:SHOWN]) + (f" and {len(before) - SHOWN} more" if len(before) > SHOWN else "")
        lacks = sorted(set(before) - set(health.runs))
        why = f", and lacks {', '.join(lacks[:SHOWN])}" if lacks else ""
        lines.append(f"This replaces the answer that was there, from {made_of}{why}.")
    return lines


def runs_of(path: Path) -> list[str]:
    """The runs of an older answer; none where there is no readable one."""
    try:
        runs = json.loads(read_regular(path, LARGEST))["runs"] if path.is_file() else []
    except (BadInput, OSError, ValueError, KeyError, TypeError, RecursionError):
        return []
    return [str(run) for run in runs] if isinstance(runs, list) else []
