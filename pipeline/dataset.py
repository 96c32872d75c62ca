"""Run folders of one material → its dataset: the points of their strokes, numbered along each string's life and tared.

Questions are answered by it, and models are fitted to it. It is made whole or not at all, with notes beside it on the
zero of the runs and on the files that it was made from.
"""

import shlex
from pathlib import Path
from tempfile import TemporaryDirectory

from .ground.command import command
from .ground.errors import BadInput, program
from .ground.input.outputs import OF_A_RUN, file_to_write, folder_to_write
from .ground.input.parser import Parser
from .ground.stored import schemas
from .ground.stored.files import whole
from .ground.words import jump_notes
from .ground.words.progress import clear, steps
from .models.parts.questions.example import example
from .models.parts.saved_files import fit_command, refuse_of_checkout, usual_folder
from .run import made_from
from .run.description import STRING_ACTUATORS
from .run.folder import read_run, recording_path
from .run.run_arguments import refuse_twice, run_dir
from .stages.dataset import note_zeros, usable_points
from .stages.ingest import warn
from .string.from_raw import read_long
from .string.history import Recorded


def material_of_runs(folders: list[Path]) -> str:
    """The material of the strings in run folders; raises BadInput where it is not one, or two runs have one name."""
    folder_by_name: dict[str, Path] = {}
    materials: list[str] = []
    for folder in folders:
        run, file = read_run(folder), folder / "run.yaml"
        if run.string is None:
            problem = f"is {run.actuator}: kinematic models are of strings"
            raise BadInput(file, "actuator", problem, f"name runs of {' or '.join(STRING_ACTUATORS)}")
        materials.append(run.string.material)
        if materials[-1] != materials[0]:
            problem = f"is {materials[-1]}, and that of {folders[0]} is {materials[0]}"
            raise BadInput(file, "string.material", problem, "name the runs of one material: each has its own dataset")
        if run.run in folder_by_name:
            problem = f"is {run.run}, as that of {folder_by_name[run.run]}"
            raise BadInput(file, "run", problem, "name one of them, or give the other folder and run.yaml another name")
        folder_by_name[run.run] = folder
        recording_path(folder)
    return materials[0]


def to_write(out: Path, folders: list[Path]) -> list[Path]:
    """The files of a dataset in a folder: points, and notes on zeros and on the runs' files; raises BadInput."""
    refuse_of_checkout(folder_to_write(out))
    if str(out) == ".":
        raise BadInput("--out", "path", "is empty or the current folder itself", "name a folder of the dataset's own")
    if not str(out.absolute()).isprintable():  # Parquet takes no path that is not UTF-8
        raise BadInput("--out", ascii(str(out))[1:-1], "has signs that cannot be printed", "name another folder")
    if any((out / name).exists() for name in OF_A_RUN):
        raise BadInput("--out", str(out), "is a run's folder, in which nothing else is put", "name another folder")
    files = [out / name for name in ("dataset.parquet", jump_notes.NAME, made_from.NAME)]
    for file in files:
        file_to_write(file, reads=[each for folder in folders for each in folder.iterdir()])
    return files


def make(folders: list[Path], files: list[Path], keep_lossy: bool) -> list[str]:
    """Write the dataset of runs and its notes, and return how many points each split has; raises BadInput.

    While they are read, the samples of long recordings lie in a temporary folder beside the dataset.
    """
    place = next(folder for folder in files[0].absolute().parents if folder.is_dir())
    with TemporaryDirectory(prefix=".samples-", dir=place) as scratch:
        recorded = list[Recorded]()
        for number, folder in enumerate(steps(folders, "run read")):
            scratch_folder = Path(scratch) / read_run(folder).run
            made_from.note_run(folder, scratch_folder / made_from.OF_RUN)
            recorded.append(read_long(folder, scratch_folder / "samples.parquet"))
            clear()
            warn(recorded[number].run, recorded[number].rows, folder)
        dataset, rests = usable_points(recorded, ", ".join(map(str, folders)), keep_lossy)
        with whole(files[0]) as points, whole(files[1]) as zeros, whole(files[2]) as origins:
            schemas.put(dataset.pieces(), schemas.DATASET, points)
            note_zeros(rests, zeros)
            made_from.note_runs([each.run.run for each in recorded], Path(scratch), origins)
    return dataset.words


@program
def main() -> None:
    """Write the dataset, and print the commands that come next."""
    parser = Parser(prog=command("dataset"), description=__doc__)
    parser.add_argument("run_dir", type=run_dir, nargs="+", help="raw/<run>, recorded; all of one material")
    kept = "keep strokes in which samples were lost; default: they are left out, and named"
    parser.add_argument("--keep-lossy", action="store_true", help=kept)
    parser.add_argument(
        "--out",
        type=Path,
        metavar="FOLDER",
        help="the folder of dataset.parquet, which may be new; default: processed/<material>, but "
        "reports/mine/<material> in a checkout",
    )
    arguments = parser.parse_args()
    refuse_twice(arguments.run_dir, "its strokes would count twice")
    material = material_of_runs(arguments.run_dir)
    files = to_write(usual_folder(material) if arguments.out is None else arguments.out, arguments.run_dir)
    words = make(arguments.run_dir, files, arguments.keep_lossy)
    print("\n".join([f"{files[0]}: the points of {material}", *(f"  {line}" for line in words)]))
    lines = "".join(f"{line}\\n" for line in example(files[0]))
    ask = f"{command('predict')} {shlex.quote(str(files[0]))} questions.csv --out answers.csv"
    print(f"Next: write a question: printf {shlex.quote(lines)} > questions.csv")
    print(f"  answer it, with an interval: {ask}")
    print(f"  or fit a model, which can then be exported: {fit_command(dataset=files[0])}")


if __name__ == "__main__":
    main()
