"""How far the zero of a run with `tare: run` is off, on simulated strings whose true zero is known.

    python benchmarks/set_zeros.py          # tables of docs/models.md, in a few seconds

Only rests are simulated, by formulas of this file alone: elements that creep and recover with times of their own, and
a growth that stays. Half of the strings hang without load in a break, a third were hung up just before the first run.
"""

import sys
from itertools import pairwise, product
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import numpy as np

from pipeline.rig.setup import described, read_setup
from pipeline.string.recovered import recovered
from pipeline.string.rests import Rests

RUN = described(read_setup("paper"), Path("raw/a-1/run.yaml"))
STRINGS, RUNS, SEED = 200, 3, 11
LOAD_N, WOUND = 20.0, 1.8  # the tension at rest, and how many times as high it is in a stroke
SIZES_MM = (0.0, 0.1, 0.2, 0.4, np.inf)  # of estimates, that are told apart in the second table
STROKES = {"5 to 24": (5, 25), "3 to 5": (3, 6)}
OTHER = 1 / 3  # of the strokes are under another load where loads vary; the first and the last are not
OTHER_LOADS = {
    "one load": (1.0, 1.0),
    "up to as much": (1.5, 1.5),
    "more": (1.5, 2.0),
}  # of the run before, and of its own


def elements(kind: str, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Times and sizes of elements that creep: shape (elements,), in s and in mm at rest under the load."""
    size = np.exp(rng.uniform(np.log(0.3), np.log(3.0)))
    if kind in ("two times", "none"):
        times_s = np.array([8.0, 70.0]) * np.exp(rng.uniform(np.log(0.3), np.log(8.0)))
        return times_s, np.array([0.12, 0.24]) * size * (kind != "none")
    times_s = np.logspace(0.0, 5.0, 21)
    if kind == "logarithm of time":
        return times_s, np.full(21, 0.03) * size
    return times_s, 0.02 * size * (times_s / 100.0) ** rng.uniform(0.1, 0.25)


def one_string(
    kind: str, strokes: tuple[int, int], rng: np.random.Generator, other: tuple[float, float] = (1.0, 1.0)
) -> list[tuple[Rests, Rests, float]]:
    """Each two runs that follow each other, and the length in mm that the string truly took back in between.

    `other`: times the usual load, under which some strokes of the runs are, of the even ones and of the odd ones.
    """
    times_s, sizes_mm = elements(kind, rng)
    stroke_s, rest_s, noise_mm = rng.uniform(8.0, 60.0), rng.uniform(2.0, 10.0), float(rng.choice([0.003, 0.01, 0.02]))
    loaded_in_a_break, hung_s = rng.random() < 0.5, 7200.0 if rng.random() < 0.7 else 0.0
    stays_mm, after_strokes = rng.uniform(0.3, 3.0) * 0.05, rng.uniform(2.0, 10.0)

    def later(state: np.ndarray, tension: float, time_s: float) -> np.ndarray:
        return sizes_mm * tension + (state - sizes_mm * tension) * np.exp(-time_s / times_s)

    def level_mm(state: np.ndarray, done: int) -> float:
        return float(-state.sum() - stays_mm * (1.0 - np.exp(-done / after_strokes)))

    state, done, ended_mm = later(np.zeros(len(times_s)), 1.0, hung_s), 0, 0.0
    runs, took_mm = list[Rests](), list[float]()
    for number in range(RUNS):
        state = later(state, 1.0, 4.0)
        levels_mm, loads = [level_mm(state, done)], [1.0]
        if number:
            took_mm.append(levels_mm[0] - ended_mm)
        count = int(rng.integers(*strokes))
        for stroke in range(count):
            time_s = stroke_s * float(rng.choice([1.0, 1.0, 1.0, 0.5, 2.0]))
            varies = other != (1.0, 1.0) and 0 < stroke < count - 1
            load = other[number % 2] if varies and rng.random() < OTHER else 1.0
            state = later(later(state, load * WOUND, 0.6 * time_s), load, 0.4 * time_s + rest_s)
            done += 1
            levels_mm.append(level_mm(state, done))
            loads.append(load)
        ended_mm = levels_mm[-1]
        state = later(state, float(loaded_in_a_break), np.exp(rng.uniform(np.log(60.0), np.log(86400.0))))
        levels = np.array(levels_mm) + rng.normal(0.0, noise_mm / 3.0, len(levels_mm))
        runs.append(rests_of(levels, LOAD_N * np.array(loads), noise_mm))
    return list(zip(runs, runs[1:], took_mm, strict=False))


def rests_of(levels_mm: np.ndarray, load_n: np.ndarray, noise_mm: float) -> Rests:
    """The rests of a run that read so much, in mm, under loads in N, both of shape (rests,): all at one twist."""
    count = len(levels_mm)
    turns, loads = (0.0,) * count, tuple(load_n.tolist())
    after, levels = tuple(range(count)), tuple(levels_mm)
    return Rests(RUN, Path(), "", (0.0, 1.0), count - 1, after, turns, loads, levels, 20.0, noise_mm)


def by_size(told_mm: np.ndarray, off_mm: np.ndarray) -> None:
    """Print how far estimates of a size are off, both of the shape (breaks,), in mm."""
    print("\n| estimate (mm) | breaks | off: median, 90 % |\n| --- | --- | --- |")
    for low, high in pairwise(SIZES_MM):
        off = off_mm[(told_mm > low) & (told_mm <= high)]
        print(f"| {low:g} to {high:g} | {len(off)} | {np.median(off):.3f}, {np.quantile(off, 0.9):.2f} mm |")


def main() -> None:
    """Print the errors of both zeros: with what the string took back left in, and without it."""
    sizes, errors = [], []
    print("| strings that creep by | strokes a run | loads | breaks | left in: median, 90 %, worst | told by strokes |")
    print("| --- | --- | --- | --- | --- | --- |")
    for kind in ("two times", "logarithm of time", "power of time", "none"):
        for (name, strokes), (loads, other) in product(STROKES.items(), OTHER_LOADS.items()):
            rng = np.random.default_rng(SEED)
            pairs = [pair for _ in range(STRINGS) for pair in one_string(kind, strokes, rng, other)]
            left_in = np.abs([took_mm for *_, took_mm in pairs])
            told = np.abs([recovered(before, after).mm - took_mm for before, after, took_mm in pairs])
            cells = [
                f"{np.median(off):.3f}, {np.quantile(off, 0.9):.2f}, {off.max():.2f} mm" for off in (left_in, told)
            ]
            print(f"| {kind} | {name} | {loads} | {len(pairs)} | {' | '.join(cells)} |")
            if kind != "none" and other == (1.0, 1.0):
                sizes.append(np.array([recovered(before, after).mm for before, after, _ in pairs]))
                errors.append(told)
    by_size(np.concatenate(sizes), np.concatenate(errors))


if __name__ == "__main__":
    main()
