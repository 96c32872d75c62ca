"""The fitted models in a project, for a person who must name one."""

import re
import shlex
import textwrap
from collections.abc import Collection
from pathlib import Path

from ...ground.command import INSTALLED, command, make_command
from ...ground.errors import BadInput
from ...ground.model_names import USUAL
from ...ground.stored import seal
from ...ground.words.counts import counted

RAW = Path("raw")  # of the folder that a program is started in
PROCESSED = Path("processed")  # of the folder that a program is started in
WORKFLOW = "Snakefile"  # of a checkout, whose main job makes what lies in `processed/`
MODEL_FILE = "processed/<material>/<model>/<split>-<seed>.model"
DATASET_FILE = "processed/<material>/dataset.parquet"
MAKE_DATASET = f"{command('dataset')} raw/<run> ..."  # of the runs of one material
FIRST = "within-0.model"  # of a model's files the one that is shown
MOST_MATERIALS = 5  # that a help lists
WIDTH = 80  # columns of a help


def fitted(material: Path, names: Collection[str]) -> list[Path]:
    """For each of the models fitted to a material, one file, the default model's first.

    A file of a split with too few strokes holds no model.
    """
    files = []
    for name in sorted(names, key=lambda name: (name != USUAL, name)):
        own_files = [file for file in sorted((material / name).glob("*-*.model")) if _holds(file)]
        files += sorted(own_files, key=lambda file: file.name != FIRST)[:1]
    return files


def in_words(material: Path, names: Collection[str]) -> str:
    """The fitted models of a material, or else those of all materials; empty where there are none."""
    files = fitted(material, names) or [file for folder in _materials() for file in fitted(folder, names)]
    return ", ".join(map(str, files))


def listed(names: Collection[str]) -> str:
    """Lines with the fitted models in `processed/`: for each material a path, and the names of the others."""
    lines = []
    for material in _materials():
        files = fitted(material, names)
        others = ", ".join(file.parent.name for file in files[1:])
        lines += [_narrow(f"  {files[0]}{f', and of {others}' if others else ''}")] if files else []
    if not lines:
        maker = f"made by\n  {fit_command()}" if INSTALLED else f"the main job makes\n  {MODEL_FILE}"
        return f"fitted models: none here yet; {maker}"
    more = [f"  and of {counted(len(lines) - MOST_MATERIALS, 'material')} more"] if len(lines) > MOST_MATERIALS else []
    return "\n".join(["fitted models here:", *lines[:MOST_MATERIALS], *more])


def _narrow(line: str) -> str:
    """A line of a help, on several lines where it is wider than a screen; no path is parted."""
    return textwrap.fill(line, WIDTH, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)


def datasets() -> list[Path]:
    """The materials' datasets in `processed/`."""
    return [path for folder in _materials() if (path := folder / "dataset.parquet").is_file()]


def material_of(dataset: Path) -> str:
    """The material of a dataset at the main job's place; empty for any other."""
    folder = dataset.resolve().parent
    return folder.name if folder.parent.name == PROCESSED.name else ""


def dataset_mend(dataset: Path) -> str:
    """The mend for a missing dataset: name an existing one, or make this one alone."""
    paths = ", ".join(map(str, datasets()))
    if INSTALLED:
        return f"{f'name {paths}; or ' if paths else ''}make it of run folders: {MAKE_DATASET}"
    make = make_command(dataset) if not dataset.exists() and _is_recorded(material_of(dataset)) else ""
    named = paths or f"{DATASET_FILE}, which the main job makes"
    return f"name {named}{f'; or make it alone, in seconds: {make}' if make else ''}"


def fit_command(name: str = "", dataset: Path | str = DATASET_FILE) -> str:
    """The command that fits a model to a dataset and saves it beside it; the usual model unless named."""
    file = dataset if dataset == DATASET_FILE else shlex.quote(str(dataset))
    return f"{command('fit_model')} {shlex.quote(name or USUAL)} {file}"


def usual_folder(material: str) -> Path:
    """Where the program `dataset` puts that of a material: in a checkout not where its main job makes one."""
    return Path("reports/mine" if Path(WORKFLOW).exists() else PROCESSED, material)


def is_of_checkout(folder: Path) -> bool:
    """Whether the main job of a checkout makes the dataset and the models of a folder."""
    place = folder.resolve()
    return place.parent.name == PROCESSED.name and (place.parents[1] / WORKFLOW).exists()


def refuse_of_checkout(folder: Path, field: str = "--out") -> None:
    """Raise BadInput for the folder of a checkout's own dataset: its main job would go on from what was put there."""
    if is_of_checkout(folder):
        material = folder.resolve().name
        make = make_command(PROCESSED / material / "dataset.parquet")
        other = f"name another folder by --out, such as {usual_folder(material)}"
        mend = f"{other}, or let it make them: {make}" if make else other
        raise BadInput(field, str(folder), "is where a checkout makes its own dataset and models", mend)


def _is_recorded(material: str) -> bool:
    """Whether a run in `raw/` names the material in its run.yaml, which is read as lines of text."""
    line = re.compile(rf"^ *material: *[\"']?{re.escape(material)}[\"']? *(#.*)?$", re.MULTILINE)
    files = RAW.glob("*/run.yaml") if material else ()
    return any(line.search(file.read_text("utf-8", "replace")) for file in files if file.is_file())


def dataset_beside(file: Path, name: str = "dataset.parquet") -> Path:
    """The dataset that a model was fitted to: the pipeline puts each model in a folder beside it."""
    return file.resolve().parent.parent / name


def check_own(file: Path, dataset: Path) -> None:
    """Raise BadInput where a fitted model lies beside another dataset: it was fitted to that one's points."""
    own = dataset_beside(file, dataset.name)
    if own.is_file() and dataset.is_file() and not own.samefile(dataset):
        raise BadInput("--saved", str(file), f"was fitted to {own}, and {dataset} is another", f"ask with {own}")


def _materials() -> list[Path]:
    return sorted(folder for folder in PROCESSED.glob("*") if folder.is_dir())


def _holds(file: Path) -> bool:
    """Whether a file holds a model."""
    return file.is_file() and file.stat().st_size > len(seal.sealed(b""))
