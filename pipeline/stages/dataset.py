"""Strokes → dataset: the points of a material, tared, numbered by stroke, and parted into two splits.

`within` holds out blocks inside strokes (interpolation), `later` the last quarter of a string's strokes
(extrapolation in n). Both are the same whatever the seed, so every model and seed is judged on the same points.
"""

import argparse
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..ground import schemas
from ..ground.errors import BadInput, program
from ..ground.files import write_text
from ..ground.kinematics import TOLERANCE
from ..ground.outputs import file_to_write
from ..run.folder import checked_info
from ..run.left_out import LeftOut, to_json
from ..run.lossy import MOVING, all_lossy, moving_strokes, touched
from ..string import jump_notes
from ..string.history import Recorded, by_string, read_usable
from ..string.zero import jumps, offsets_mm

TRAINING_POINTS = 5000  # as in the paper
HELD_OUT_POINTS = 20000  # more tell no more, and cost the learned models minutes
MOST_BLOCKS = 80  # into which a stroke's winding, or unwinding, is cut
BLOCK_LEAST_SAMPLES = 10
HOLD_OUT = 4  # one block in so many
WHICH_OF_FOUR = np.array([0, 2, 1, 3])  # in the first group of four blocks, the second, …
LATER_LEAST_STROKES = 4

Numbers = NDArray[np.int64]
Mask = NDArray[np.bool_]


def blocks_from_top(samples: int) -> Numbers:
    """Block of each sample of one winding, counted from its top and given in order of rising twist."""
    count = min(max(samples // BLOCK_LEAST_SAMPLES, 1), MOST_BLOCKS)
    return (np.arange(samples) * count // max(samples, 1))[::-1].copy()


def held_out(block: Numbers, stroke: Numbers) -> Mask:
    """Whether a block of a stroke is held out in the split `within`.

    One block of every four, another one from group to group so that no part of the range is favoured, and shifted from
    stroke to stroke so that over four strokes every twist is held out once. Strokes 1, 5 and 9, which the tables show,
    hold out their very top.
    """
    first = WHICH_OF_FOUR[block // HOLD_OUT % len(WHICH_OF_FOUR)]
    return np.asarray(block % HOLD_OUT == (first + stroke - 1) % HOLD_OUT)


def points_of(
    recorded: Recorded, strokes_before: int, offset_mm: float, left_out: frozenset[int] = frozenset()
) -> pd.DataFrame:
    """The moving points of a run, with stroke number, phase, block and the string's dimensions.

    Raises BadInput when every stroke is left out.
    """
    run, samples = recorded.run, recorded.samples
    assert run.string is not None
    parts = []
    stretches = recorded.strokes[recorded.strokes["phase"].isin(MOVING) & (recorded.strokes["stroke"] > 0)]
    stretches = stretches[~stretches["stroke"].isin(left_out)]
    if stretches.empty:
        raise all_lossy(run.run)
    for (stroke, phase), group in stretches.groupby(["stroke", "phase"], sort=True):
        rows = np.concatenate(
            [np.arange(a, b + 1) for a, b in zip(group["first_sample"], group["last_sample"], strict=True)]
        )
        block = blocks_from_top(len(rows))
        part = samples.iloc[rows][["time_s", "motor_turns", "displacement_mm", "load_n"]].reset_index(drop=True)
        part["displacement_mm"] += offset_mm
        part["stroke"] = int(stroke) + strokes_before
        part["phase"] = phase
        part["direction"] = 1 if phase == "winding" else -1
        part["block"] = block if phase == "winding" else block[::-1]
        parts.append(part)
    points = pd.concat(parts, ignore_index=True)
    parts.clear()  # of a long recording they are as large as all of it
    points = points.sort_values("time_s", ignore_index=True)
    points["run"], points["string"], points["actuator"] = run.run, run.string_id, run.actuator
    points["radius_mm"] = run.string.radius_mm
    points["length_mm"] = run.string.length_mm
    points["stiffness_n_per_mm"] = run.string.nominal_stiffness_n_per_mm
    points["torsion_zone_mm"] = run.rig.get("torsion_zone_mm", np.nan)
    points["separator_mm"] = run.rig.get("separator_mm", np.nan)
    tolerance = {**TOLERANCE, **run.tolerance}
    points["radius_tolerance"] = tolerance["radius"]
    for name in ("length", "torsion_zone", "separator"):
        points[f"{name}_tolerance_mm"] = tolerance[f"{name}_mm"]
    return points


def _thinned(eligible: Mask, most: int) -> Mask:
    """At most so many of the eligible rows, evenly spaced over them."""
    rows = np.flatnonzero(eligible)
    if len(rows) > most:
        rows = rows[np.linspace(0, len(rows) - 1, most).round().astype(int)]
    chosen = np.zeros(len(eligible), bool)
    chosen[rows] = True
    return chosen


def _split(test: Mask, eligible: Mask) -> NDArray[np.object_]:
    """Labels "train", "test" and "" of the points."""
    labels = np.full(len(test), "", object)  # a pointer each: text side by side is as large as all channels
    labels[_thinned(eligible & ~test, TRAINING_POINTS)] = "train"
    labels[_thinned(test, HELD_OUT_POINTS)] = "test"
    return labels


def make_dataset(
    recorded: list[Recorded],
    left_out: Mapping[str, frozenset[int]] | None = None,
    without: frozenset[str] = frozenset(),
) -> pd.DataFrame:
    """Points of all runs of a material but for the strokes `left_out` of a run; columns of `schemas.DATASET`.

    Runs of the same string continue each other's stroke numbers and share its tare (`zero.offsets_mm`); of the runs
    `without` the strokes count and no point is taken.
    """
    parts = []
    for runs in by_string(recorded):
        done = 0
        for one, offset_mm in zip(runs, offsets_mm(runs), strict=True):
            assert one.run.string is not None
            done = max(done, one.run.string.strokes_before)
            if one.run.run not in without:
                parts.append(points_of(one, done, offset_mm, (left_out or {}).get(one.run.run, frozenset())))
            done += int(one.strokes["stroke"].max())
    points = parts[0] if len(parts) == 1 else pd.concat(parts, ignore_index=True)
    parts.clear()
    everything = np.ones(len(points), bool)
    points["within"] = _split(held_out(points["block"].to_numpy(), points["stroke"].to_numpy()), everything)
    test, enough = ~everything, ~everything
    for string, strokes in points.groupby("string")["stroke"].unique().items():
        if len(strokes) >= LATER_LEAST_STROKES:
            own = (points["string"] == string).to_numpy()
            first = np.sort(strokes)[int(0.75 * len(strokes) + 0.5)]
            enough |= own
            test |= own & (points["stroke"].to_numpy() >= first)
    points["later"] = _split(test, enough)
    return points[schemas.DATASET.names]


@program
def main() -> None:
    """Write `dataset.parquet` of one material."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("run_dirs", type=Path, nargs="+")
    parser.add_argument("--processed", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True, help="the file of the dataset, Parquet; required")
    parser.add_argument("--out-left-out", type=Path, help="where to write, as JSON, which runs were left out and why")
    parser.add_argument("--out-jumps", type=Path, help="where to write, as JSON, jumps of the zero to be confirmed")
    parser.add_argument("--keep-lossy", action="store_true", help="keep strokes in which samples were lost")
    parser.add_argument("--note-refusals", action="store_true", help="leave out a run in which every stroke is lossy")
    arguments = parser.parse_args()
    stored = [file for run in arguments.run_dirs for file in (arguments.processed / run.name).glob("*.parquet")]
    file_to_write(arguments.out, reads=stored)
    for name in ("out_left_out", "out_jumps"):
        file_to_write(getattr(arguments, name) or arguments.out, f"--{name.replace('_', '-')}", stored)
    recorded, refused = read_usable(arguments.run_dirs, arguments.processed)
    strokes_left: dict[str, frozenset[int]] = {}
    for one in recorded:
        lossy = touched(one.strokes, checked_info(one.folder))
        if lossy:
            print(f"{one.run.run}: samples are missing in strokes {', '.join(map(str, sorted(lossy)))}", end=": ")
            print("kept all the same" if arguments.keep_lossy else "left out")
            strokes_left[one.run.run] = frozenset() if arguments.keep_lossy else lossy
            if arguments.note_refusals and strokes_left[one.run.run] >= moving_strokes(one.strokes):
                refused.append(LeftOut.of(one.run.run, all_lossy(one.run.run)))
    without = frozenset(one.run for one in refused)
    if without >= {one.run.run for one in recorded}:
        raise all_lossy(", ".join(sorted(without)))
    jumped = [jump for runs in by_string(recorded) for jump in jumps(runs)]
    print("".join(f"{jump.advice}\n" for jump in jumped), end="")
    dataset = make_dataset(recorded, strokes_left, without)
    if not {"train", "test"} <= set(dataset["within"]):
        mend = "record more strokes, or more samples a stroke"
        raise BadInput(arguments.out, "within", "there are too few points to hold some out and learn from others", mend)
    schemas.write(dataset, schemas.DATASET, arguments.out)
    if arguments.out_left_out:
        write_text(arguments.out_left_out, to_json(refused) + "\n")
    if arguments.out_jumps:
        said = [jump.advice for jump in jumped if not jump.taken_off]
        write_text(arguments.out_jumps, jump_notes.to_json(said) + "\n")
    for split in ("within", "later"):
        counts = dataset[split].value_counts()
        print(f"{split}: {counts.get('train', 0)} points to train on, {counts.get('test', 0)} held out")


if __name__ == "__main__":
    main()
