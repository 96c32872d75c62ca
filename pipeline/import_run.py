"""A foreign recording → a run folder, through a mapping that says which column is what.

A mapping is a `run.yaml` without `run`: the string, the rig, how the file is written and where its channels stand.
"""

import argparse
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from pipeline import schemas
from pipeline.errors import BadInput, program
from pipeline.files import sha256
from pipeline.folders import whole_folder
from pipeline.formats import read_foreign
from pipeline.ingest import check, check_finite, questions
from pipeline.kinematics import Array
from pipeline.named_units import in_its_unit
from pipeline.names import checked, own_material, run_name
from pipeline.next_command import following
from pipeline.recording import asked_columns, to_samples
from pipeline.run_yaml import parse_run
from pipeline.strict_yaml import read_yaml, write_yaml

MOST_MOVED = 0.01  # of all stamps
LEAP = 10.0  # usual steps: a single stamp at either end that stands apart by more was not sampled there


def mend_time(time_s: Array) -> tuple[Array, dict[str, int]]:
    """Time stamps that rise strictly, and how often each rule was needed.

    `backward_time_stamps`: where the clock falls back for good, all that follows is moved to one usual step after the
    sample before; a single stamp that falls back, or leaps ahead, is put between its neighbours.
    `repeated_time_stamps`: samples that share a stamp are spread evenly up to the next. `leaping_time_stamps`: the
    first or the last stamp, where it stands apart by ten usual steps and by more than any other gap, is moved to one
    usual step from its neighbour. No sample is dropped.
    """
    time_s = np.array(time_s)
    steps = np.diff(time_s)
    usual_s = float(np.median(steps[steps > 0])) if (steps > 0).any() else 1.0
    backward = repeated = 0
    for row in range(1, len(time_s)):
        if time_s[row] >= time_s[row - 1]:
            continue
        backward += 1
        if row + 1 < len(time_s) and time_s[row + 1] > time_s[row - 1]:
            time_s[row] = (time_s[row - 1] + time_s[row + 1]) / 2
        elif row > 1 and time_s[row] > time_s[row - 2]:
            time_s[row - 1] = (time_s[row - 2] + time_s[row]) / 2
        else:
            time_s[row:] += time_s[row - 1] + usual_s - time_s[row]
    _, first, count = np.unique(time_s, return_index=True, return_counts=True)
    for start, same in zip(first[count > 1], count[count > 1], strict=True):
        following = start + same
        gap_s = time_s[following] - time_s[start] if following < len(time_s) else same * usual_s
        gap_s = min(gap_s, same * usual_s) if gap_s > 2 * same * usual_s else gap_s  # a gap stays a gap
        time_s[start:following] += gap_s * np.arange(same) / same
        repeated += int(same) - 1
    steps, leaping = np.diff(time_s), 0
    for end, beside in ((0, 1), (-1, -2)) if len(steps) > 2 else ():
        if steps[end] > max(LEAP * usual_s, *np.delete(steps, end)):
            time_s[end] = time_s[beside] + np.sign(time_s[end] - time_s[beside]) * usual_s
            leaping += 1
    mended = {
        "backward_time_stamps": backward,
        "repeated_time_stamps": repeated,
        "leaping_time_stamps": leaping,
    }
    return time_s, {rule: times for rule, times in mended.items() if times}


def check_mended(before_s: Array, after_s: Array, file: Path) -> None:
    """Raise BadInput where mending moved over 1 % of the stamps by ten usual steps: the clock itself was wrong."""
    usual_s = float(np.median(np.abs(np.diff(before_s))))
    moved = np.abs(after_s - before_s) > LEAP * usual_s
    if moved.sum() > max(1, MOST_MOVED * len(moved)):
        row = int(np.argmax(moved))
        problem = f"falls back or leaps near row {row + 1}, which only moving {int(moved.sum())} stamps would mend"
        mend = "correct the stamps there, or cut the recording where its clock begins anew"
        raise BadInput(file, "time_s", problem, mend)


def read_mapping(path: Path) -> dict[str, Any]:
    """Content of a mapping; raises BadInput when it is not there, not YAML, or names a run."""
    content = read_yaml(path)
    if not isinstance(content, dict) or {"run", "mended"} & content.keys():
        mend = "write it as a run.yaml, without run and mended"
        raise BadInput(path, "mapping", "is not a mapping", mend)
    return content


def origin(file: Path, mapping: Path) -> str:
    """Where a run came from, as comments of YAML: both files by name and check sum."""
    told = (("imported from", file), ("through the mapping", mapping))
    return "".join(f"# {what} {str(path)!a}, sha256 {sha256(path)}\n" for what, path in told)


def write_run(content: dict[str, Any], samples: pd.DataFrame, folder: Path, came_from: str) -> None:
    """Make a run folder, whole or not at all; raises BadInput when it is there already."""
    with whole_folder(folder, "run", "choose another --run; runs are never overwritten") as temporary:
        schemas.write(samples, schemas.samples(list(samples.columns)), temporary / "recording.parquet")
        (temporary / "run.yaml").write_text(came_from + write_yaml(content), encoding="utf-8")


def import_run(file: Path, mapping: Path, name: str, out: Path) -> str:
    """Import one file as run `name` under `out`; a sentence that says what was done. Raises BadInput."""
    folder = out / name
    content = {"run": name, **read_mapping(mapping)}
    try:
        checked(run_name, name, folder / "run.yaml", "run")
        run = parse_run(content, folder / "run.yaml")
        if run.string:
            checked(own_material, run.string.material, mapping, "string.material")
    except BadInput as error:  # the mapping is what a person can mend, but for the name
        where = "--run" if error.field == "run" else str(mapping)
        raise BadInput(where, error.field, error.problem, error.mend) from None
    table = read_foreign(file, run.file, asked_columns(run))
    samples = to_samples(run, table, file, mapping)
    check_finite(samples, file)
    time_s, mended = mend_time(samples["time_s"].to_numpy())
    check_mended(samples["time_s"].to_numpy(), time_s, file)
    samples["time_s"] = time_s
    checked_samples = check(run, samples, file)  # a run folder keeps all of them: ingest leaves out what this did
    for question in questions(run, checked_samples, file):
        print(f"warning: {question}", file=sys.stderr)
    loads = "load_n" in run.channels or "load_n" in table.columns or in_its_unit("load_n", table.columns)
    if not loads:
        samples = samples.drop(columns="load_n", errors="ignore")  # rig.load_n stays the one place that says it
    kept = {key: value for key, value in content.items() if key not in ("file", "channels")}
    write_run({**kept, **({"mended": mended} if mended else {})}, samples, folder, origin(file, mapping))
    said = ", ".join(f"{times} {rule.replace('_', ' ')}" for rule, times in mended.items())
    return f"{folder}: {len(samples)} samples" + (f"; mended {said}" if said else "")


@program
def main() -> None:
    """Import one file."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", type=Path)
    mapping = "what is where in the file (docs/import.md), such as pipeline/mappings/tsa_haptic_1.yaml"
    parser.add_argument("--map", type=Path, required=True, help=mapping)
    parser.add_argument("--run", required=True, help="name of the new run: lower-case letters, digits and -")
    parser.add_argument(
        "--out", type=Path, default=Path("raw"), help="the folder in which the run's folder is made; default: raw"
    )
    arguments = parser.parse_args()
    print(import_run(arguments.file, arguments.map, arguments.run, arguments.out))
    print(following(arguments.out / arguments.run, recorded=True))


if __name__ == "__main__":
    main()
