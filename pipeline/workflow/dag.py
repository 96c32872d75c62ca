"""The plan of the files to make: the runs in `raw/`, their materials, and the fits for them."""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from ..ground.configuration import ModelPlan
from ..ground.errors import BadInput
from ..ground.input.strict_yaml import LARGEST, read_yaml
from ..ground.model_names import NOMINAL, PAPER
from ..ground.names import LONGEST, MATERIAL_NAME, SYNTHETIC, SYNTHETIC_DEVICE, checked, run_name
from ..ground.stored.regular_file import read_regular
from ..ground.words import jump_notes
from ..ground.words.left_out import LeftOut
from ..ground.words.unfinished import mend_of_unfinished
from ..run import made_from
from ..run.description import STRING_ACTUATORS
from ..run.folder import capture_info, find_runs, read_run, unfinished

# The material in a run.yaml that cannot be read as a whole, such as one with a NaN: on a line that is no comment.
NAMED = re.compile(r"""^[^#\n]*\bmaterial: *(["']?)([A-Za-z0-9][A-Za-z0-9_-]*)\1 *([,}\n#]|$)""", re.MULTILINE)
VERDICT = "diagnosis.json"  # of a run's diagnosis, in its folder
SYNTHETIC_FILES = ("run.yaml", "recording.frames", "capture.json")


@dataclass
class Plan:
    """Runs by material, runs that are in no table, and folders that are not used at all."""

    materials: dict[str, list[str]] = field(default_factory=dict)
    others: list[str] = field(default_factory=list)  # no string
    unfinished: list[LeftOut] = field(default_factory=list)  # a capture under way, or cut off
    misnamed: list[LeftOut] = field(default_factory=list)  # a folder whose name no run can have
    refused: list[LeftOut] = field(default_factory=list)  # a run.yaml or a recording that cannot be used

    def add(self, material: str, run: str) -> None:
        """Put a run under its material."""
        self.materials.setdefault(material, []).append(run)

    def leave_out(self, refused: Mapping[str, LeftOut]) -> None:
        """Make nothing for refused runs, as for runs with a bad run.yaml; a material without another run is dropped."""
        for material, runs in list(self.materials.items()):
            self.refused += [replace(refused[run], material=material) for run in runs if run in refused]
            self.materials[material] = [run for run in runs if run not in refused]
            if not self.materials[material]:
                del self.materials[material]
        self.refused += [refused[run] for run in self.others if run in refused]
        self.others = [run for run in self.others if run not in refused]

    @property
    def runs(self) -> list[str]:
        """Runs with files to make."""
        return [run for runs in self.materials.values() for run in runs] + self.others

    @property
    def left_out(self) -> list[LeftOut]:
        """Folders that are not used."""
        return self.refused + self.unfinished + self.misnamed


def _perhaps(folder: Path) -> str:
    """The material that the `run.yaml` of an unusable folder names, if the word is one that a material may have."""
    path = folder / "run.yaml"
    try:
        named = read_yaml(path)["string"]["material"]
    except (BadInput, KeyError, TypeError, IndexError):
        try:
            match = NAMED.search(read_regular(path, LARGEST, path.name).decode("utf-8"))
        except (BadInput, UnicodeDecodeError):
            return ""
        named = match[2] if match else ""
    shown = isinstance(named, str) and len(named) <= LONGEST and MATERIAL_NAME.fullmatch(named)
    return named if shown else ""


def _place(plan: Plan, folder: Path) -> None:
    """Put a folder where it belongs."""
    run = folder.name
    try:
        run_name(run)
    except ValueError as error:
        problem = str(error).rpartition("; ")[0]
        mend = "rename the folder, and `run` in its run.yaml with it: lower-case letters, digits and -"
        plan.misnamed.append(LeftOut.of(run, BadInput(folder, "its name", problem, mend), _perhaps(folder)))
        return
    try:
        if unfinished(folder):
            mend = mend_of_unfinished(folder)
            cut_off = BadInput(folder, "recording", "is unfinished", mend)
            plan.unfinished.append(LeftOut.of(run, cut_off, _perhaps(folder)))
            return
        read = read_run(folder)
    except (BadInput, OSError) as error:
        if not isinstance(error, BadInput):
            error = BadInput(folder, "folder", f"cannot be read ({error.strerror})", "check who may read it")
        plan.refused.append(LeftOut.of(run, error, _perhaps(folder)))
        return
    if read.actuator in STRING_ACTUATORS and read.string:
        plan.add(read.string.material, run)
    else:
        plan.others.append(run)


def make_plan(raw: Path, synthetic: list[str]) -> Plan:
    """Plan for the runs in a folder and those that the pipeline records itself; a bad folder affects only itself.

    Raises BadInput when a name of the latter is none that a run can have, or belongs to a real recording, which must
    never be made again.
    """
    plan = Plan()
    for run in synthetic:
        checked(run_name, run, "configuration", "synthetic")
        info = capture_info(raw / run)
        hello = info.get("hello")
        if (raw / run).exists() and info and (not hello or hello.get("device") != SYNTHETIC_DEVICE):
            mend = "rename the run, or the one under `synthetic` in the configuration"
            raise BadInput(raw / run, "run", "is a real recording under a name of the synthetic rig", mend)
        plan.add(SYNTHETIC, run)
    for folder in find_runs(raw):
        if folder.name not in synthetic:
            _place(plan, folder)
    return plan


def recorded_files(raw: Path, run: str, synthetic: list[str]) -> list[str]:
    """Files of a run that its samples come from."""
    if run in synthetic:
        return [str(raw / run / name) for name in SYNTHETIC_FILES]
    return [str(raw / run / name) for name in (*made_from.FILES, "capture.json") if (raw / run / name).is_file()]


def stored(models: Mapping[str, ModelPlan], plan: Plan) -> Iterator[str]:
    """Tables, models and verdicts that the workflow keeps between its jobs; they are checked for damage."""
    for run in plan.runs:
        yield from (f"processed/{run}/{stage}.parquet" for stage in ("samples", "strokes"))
        yield f"processed/{run}/{made_from.OF_RUN}"
        yield f"reports/diagnosis/{run}/{VERDICT}"
    for material in plan.materials:
        yield from (f"processed/{material}/{table}.parquet" for table in ("dataset", "metrics"))
        yield from (f"processed/{material}/{note}" for note in ("left_out.json", jump_notes.NAME, made_from.NAME))
        for predictions in fits(models, material):
            yield predictions
            yield predictions.replace(".predictions.parquet", ".model")


def output_of(stored_file: str) -> str:
    """The output of a rule that a stored file is, or lies in: of a diagnosis its folder."""
    path = Path(stored_file)
    return str(path.parent) if path.name == VERDICT else stored_file


def fits(models: Mapping[str, ModelPlan], material: str, only: str | None = None) -> Iterator[str]:
    """The predictions files of all fits of a material in the configuration, or of one model's fits within."""
    for model, settings in models.items():
        for split, count in settings["seeds"].items():
            if only is None or (model == only and split == "within"):
                for seed in range(count):
                    yield f"processed/{material}/{model}/{split}-{seed}.predictions.parquet"


def table_order(models: Iterable[str], default: Iterable[str]) -> list[str]:
    """Models in the order of the tables: the INN, the others as in the default configuration, others, the traditional.

    Snakemake puts what a configuration on top of the default one names before all else.
    """
    names, first, last = list(models), PAPER, NOMINAL
    in_default = [model for model in default if model in names]
    middle = [model for model in dict.fromkeys([*in_default, *names]) if model not in (first, last)]
    return [first, *middle, last]
