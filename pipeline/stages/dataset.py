"""Strokes → dataset: the points of a material, tared, numbered by stroke, and parted into two splits.

`within` holds out blocks inside strokes (interpolation), `later` the last quarter of a string's strokes
(extrapolation in n). Both are the same whatever the seed, so every model and seed is judged on the same points.
"""

from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np
import pandas as pd

from ..ground.errors import BadInput, program
from ..ground.input.outputs import file_to_write
from ..ground.input.parser import Parser
from ..ground.stored import schemas
from ..ground.stored.files import whole
from ..ground.words.jump_notes import write_jumps
from ..ground.words.left_out import LeftOut, write_left_out
from ..run.folder import checked_info
from ..run.lossy import all_lossy, moving_strokes, touched
from ..run.made_from import note_runs
from ..string.history import Recorded, by_string, read_usable
from ..string.not_compared import not_compared, to_confirm
from ..string.rests import Rests
from ..string.tare_notes import set_anew, tare_notes
from ..string.zero import jumps_among, offsets_mm
from .points import Piece, moving, points_of
from .splits import HELD_OUT_POINTS, Mask, Split, blocks_from_top, held_out

LATER_LEAST_STROKES = 4

__all__ = ["HELD_OUT_POINTS", "Dataset", "blocks_from_top", "held_out", "make_dataset", "points_of", "touched"]


class Dataset:
    """Points of all runs of a material but for the strokes `left_out` of a run; columns of `schemas.DATASET`.

    Runs of the same string continue each other's stroke numbers and share its tare (`zero.offsets_mm`); of the runs
    `without` the strokes count and no point is taken. What is held out is told from the strokes alone; points are read
    and labelled piece by piece.
    """

    def __init__(
        self,
        recorded: list[Recorded],
        left_out: Mapping[str, frozenset[int]] | None = None,
        without: frozenset[str] = frozenset(),
    ) -> None:
        self._moving: list[Piece] = []
        for runs in by_string(recorded):
            done = 0
            for recorded_run, offset_mm in zip(runs, offsets_mm(runs), strict=True):
                assert recorded_run.run.string is not None
                done = max(done, recorded_run.run.string.strokes_before)
                if recorded_run.run.run not in without:
                    self._moving += moving(
                        recorded_run, done, offset_mm, (left_out or {}).get(recorded_run.run.run, frozenset())
                    )
                done += int(recorded_run.strokes["stroke"].max())
        strokes: dict[str, set[int]] = {}
        for piece in self._moving:
            strokes.setdefault(piece.recorded.run.string_id, set()).add(piece.number)
        self._later = {  # the first stroke that each string holds out
            string: sorted(numbers)[int(0.75 * len(numbers) + 0.5)]
            for string, numbers in strokes.items()
            if len(numbers) >= LATER_LEAST_STROKES
        }
        self.within = Split(map(self._held_within, self._moving))
        self.later = Split(map(self._held_later, self._moving))

    @staticmethod
    def _held_within(piece: Piece) -> tuple[Mask, Mask]:
        block = piece.block
        return held_out(block, np.full(len(block), piece.number)), np.ones(len(block), bool)

    def _held_later(self, piece: Piece) -> tuple[Mask, Mask]:
        first, points = self._later.get(piece.recorded.run.string_id), piece.stop - piece.first
        return np.full(points, first is not None and piece.number >= first), np.full(points, first is not None)

    def pieces(self) -> Iterator[pd.DataFrame]:
        """The points in their order, once."""
        for piece in self._moving:
            points = piece.points()
            points["within"] = self.within.labels(*self._held_within(piece))
            points["later"] = self.later.labels(*self._held_later(piece))
            yield points[schemas.DATASET.names]

    @property
    def words(self) -> list[str]:
        """How many points each split has, a line each."""
        splits = (("within", self.within), ("later", self.later))
        counts = ((name, split.train.count, split.test.count) for name, split in splits)
        return [f"{name}: {train} points to train on, {test} held out" for name, train, test in counts]


def make_dataset(
    recorded: list[Recorded],
    left_out: Mapping[str, frozenset[int]] | None = None,
    without: frozenset[str] = frozenset(),
) -> pd.DataFrame:
    """The points of a `Dataset`, all of them held."""
    return pd.concat(Dataset(recorded, left_out, without).pieces(), ignore_index=True)


def _on_pages(of_string: list[Rests]) -> list[str]:
    """The sentences of the pages on the zero of one string's runs."""
    jumped = [jump.advice for jump in jumps_among(of_string) if jump.is_unconfirmed]
    return [*jumped, *to_confirm(of_string), *set_anew(of_string)]


def usable_points(
    recorded: list[Recorded], source: Path | str, keep_lossy: bool, refused: list[LeftOut] | None = None
) -> tuple[Dataset, list[list[Rests]]]:
    """The points of runs of a material, and the rests of each string of several; what is left out is printed.

    Strokes with missing samples are left out unless `keep_lossy`. A run in which all are is added to those that are
    `refused`, and its strokes count; without such a list it raises BadInput. So do too few points, which are the
    `source`'s.
    """
    strokes_left: dict[str, frozenset[int]] = {}
    for recorded_run in recorded:
        lossy = touched(recorded_run.strokes, checked_info(recorded_run.folder))
        if lossy:
            named = f"stroke{'s' * (len(lossy) > 1)} {', '.join(map(str, sorted(lossy)))}"
            print(f"{recorded_run.run.run}: samples are missing in {named}", end=": ")
            print("kept all the same" if keep_lossy else "left out")
            strokes_left[recorded_run.run.run] = frozenset() if keep_lossy else lossy
            every_one = strokes_left[recorded_run.run.run] >= moving_strokes(recorded_run.strokes)
            if refused is not None and every_one:
                refused.append(LeftOut.of(recorded_run.run.run, all_lossy(recorded_run.run.run)))
    without = frozenset(refusal.run for refusal in refused or ())
    if without >= {recorded_run.run.run for recorded_run in recorded}:
        raise all_lossy(", ".join(sorted(without)))
    rests = [[Rests.of(run) for run in runs] for runs in by_string(recorded) if len(runs) > 1]
    jumped = [jump for of_string in rests for jump in jumps_among(of_string)]
    notes = [note for of_string in rests for _, note in tare_notes(of_string)]
    every_rest = [of_run for of_string in rests for of_run in of_string]
    notes += [f"Beware: {note}" for note in not_compared(every_rest)]
    print("".join(f"{sentence}\n" for sentence in [*(jump.advice for jump in jumped), *notes]), end="")
    dataset = Dataset(recorded, strokes_left, without)
    if not dataset.within.train.count or not dataset.within.test.count:
        mend = "record more strokes, or more samples a stroke"
        raise BadInput(source, "within", "there are too few points to hold some out and learn from others", mend)
    return dataset, rests


def note_zeros(rests: list[list[Rests]], path: Path) -> None:
    """Write the note on what the zero of each string's runs did, for those who use the dataset beside it."""
    write_jumps(path, {of_string[0].run.string_id: _on_pages(of_string) for of_string in rests})


@program
def main() -> None:
    """Write `dataset.parquet` of one material."""
    parser = Parser(description=__doc__)
    parser.add_argument("run_dirs", type=Path, nargs="+")
    parser.add_argument("--processed", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True, help="the file of the dataset, Parquet; required")
    parser.add_argument("--out-left-out", type=Path, help="where to write, as JSON, which runs were left out and why")
    parser.add_argument("--out-jumps", type=Path, help="where to write, as JSON, jumps of the zero to be confirmed")
    parser.add_argument("--out-made-from", type=Path, help="where to note, as JSON, the runs' files by content")
    parser.add_argument("--keep-lossy", action="store_true", help="keep strokes in which samples were lost")
    parser.add_argument("--note-refusals", action="store_true", help="leave out a run in which every stroke is lossy")
    arguments = parser.parse_args()
    stored = [file for run in arguments.run_dirs for file in (arguments.processed / run.name).glob("*.parquet")]
    file_to_write(arguments.out, reads=stored)
    for name in ("out_left_out", "out_jumps", "out_made_from"):
        file_to_write(getattr(arguments, name) or arguments.out, f"--{name.replace('_', '-')}", stored)
    recorded, refused = read_usable(arguments.run_dirs, arguments.processed)
    noted = refused if arguments.note_refusals else None
    dataset, rests = usable_points(recorded, arguments.out, arguments.keep_lossy, noted)
    with whole(arguments.out) as temporary:
        schemas.put(dataset.pieces(), schemas.DATASET, temporary)
    if arguments.out_left_out:
        write_left_out(arguments.out_left_out, refused)
    if arguments.out_jumps:
        note_zeros(rests, arguments.out_jumps)
    if arguments.out_made_from:
        note_runs([run.name for run in arguments.run_dirs], arguments.processed, arguments.out_made_from)
    print("\n".join(dataset.words))


if __name__ == "__main__":
    main()
