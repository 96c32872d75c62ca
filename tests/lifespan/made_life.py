"""Strings that wear out, made without the rig and by other formulas than the laws that are to foretell them."""

from pathlib import Path

import numpy as np
import pandas as pd
import yaml
from made_recording import BASE, content


def worn(generator: np.random.Generator, strokes: int = 2000) -> tuple[np.ndarray, np.ndarray]:
    """Strokes and a loss that grows: exponentials of random rates, a power of its own and a random walk."""
    n = np.arange(1.0, strokes + 1.0)
    life = generator.uniform(60.0, 300.0)
    loss = sum(generator.uniform(0.0, 0.04) * -np.expm1(-n / (life * 10 ** generator.uniform(-1.5, 0.3))) for _ in "ab")
    loss = loss + 0.06 * (n / life) ** generator.uniform(0.7, 1.6)
    loss = loss + 0.0004 * np.cumsum(generator.standard_normal(strokes))
    return n, loss - loss[:3].mean()


def samples(strokes: int, loss_per_stroke: float, noise_mm: float = 0.02, load_swing_n: float = 0.0) -> pd.DataFrame:
    """A recording of strokes whose travel shrinks by a share each, at 10 Hz; the string stretches by 1 mm per 20 N."""
    generator = np.random.default_rng(0)
    parts = []
    for stroke in range(strokes):
        turns = np.concatenate([np.zeros(8), np.linspace(0, 20, 50), np.full(6, 20.0), np.linspace(20, 0, 50)])
        load_n = 20.0 + load_swing_n * np.sin(np.arange(len(turns)) / 7.0)
        down = np.concatenate([np.zeros(64), np.full(50, 0.1)])
        x = BASE.contraction_mm(turns, 20.0) * (1.0 - loss_per_stroke * stroke)
        parts.append(np.column_stack([turns, x - 0.05 * stroke - down - (load_n - 20.0) / 20.0, load_n]))
    turns, x, load_n = np.concatenate([*parts, np.array([[0.0, parts[-1][-1, 1], 20.0]] * 8)]).T
    x = x + noise_mm * generator.standard_normal(len(x))
    table = {"time_s": 0.1 * np.arange(len(x)), "motor_turns": turns, "displacement_mm": x, "load_n": load_n}
    return pd.DataFrame(table)


def folder(place: Path, name: str, table: pd.DataFrame, **changes: object) -> Path:
    """A run folder with a recording under a place."""
    path = place / name
    path.mkdir(parents=True)
    (path / "run.yaml").write_text(yaml.safe_dump(content(name, **changes)))
    table.to_parquet(path / "recording.parquet", index=False)
    return path
