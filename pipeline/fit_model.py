"""Dataset → a fitted model of a name, in a file that `export` writes for a controller and `predict --saved` asks.

Two fits lie beside each other: `within` left out blocks inside strokes, `later` the last strokes. The errors on what
each left out are printed. The first is the one to export; its export tells the errors of both.
"""

import shlex
from pathlib import Path

import pandas as pd

from .export.closing_words import SENTENCE
from .export.held_out import ANEW, errors_of
from .export.interface import names
from .ground.command import command
from .ground.errors import BadInput, program
from .ground.input.outputs import file_to_write
from .ground.input.parser import Parser
from .ground.stored import schemas
from .ground.stored.given_table import opened
from .ground.words.progress import steps
from .models.interface import Model
from .models.parts.configured import configured, fitting
from .models.parts.divided import SPLITS, divided
from .models.parts.fitted_to import note_points
from .models.parts.saved import write_bytes
from .models.parts.saved_files import DATASET_FILE, MAKE_DATASET, dataset_mend, refuse_of_checkout
from .models.parts.settings import shown
from .stages.train import seed


def fit(name: str, settings: str, dataset: Path, files: dict[str, Path], number: int) -> Model:
    """Fit a model to each split of a dataset, then write its files, and return the fit to blocks inside strokes.

    A split of too few strokes has a file without content. `number` is the seed. Raises BadInput for settings, points or
    a dataset that a model cannot be fitted to.
    """
    table = opened(dataset, schemas.DATASET, dataset_mend(dataset))
    models, trained = {split: configured(name, settings) for split in SPLITS}, dict[str, pd.DataFrame]()
    for split in steps(SPLITS, "split"):
        train, test = divided(table, split, dataset)
        if len(test):
            with fitting(name):
                models[split].fit(train, number)
            trained[split] = train
    if "within" not in trained:
        raise BadInput(dataset, "within", "has no points that are held out", dataset_mend(dataset))
    for split, file in files.items():
        if split in trained:
            model = models[split]
            model.save(file)
            note_points(file, trained[split], split)
        else:
            write_bytes(file, b"")
    return models["within"]


@program
def main() -> None:
    """Write the model's files, and print its errors and the commands that come next."""
    parser = Parser(prog=command("fit_model"), description=__doc__)
    parser.add_argument("model", metavar="MODEL", help=f"one of {', '.join(names())}")
    parser.add_argument("dataset", type=Path, help=f"{DATASET_FILE}; made by: {MAKE_DATASET}")
    parser.add_argument("--settings", default="{}", metavar="JSON", help="the model's settings")
    parser.add_argument("--seed", type=seed, default=0, help="what a network begins with; default: 0")
    parser.add_argument(
        "--out",
        type=Path,
        metavar="FOLDER",
        help="the folder in which MODEL/within-SEED.model is put; default: the dataset's, where others look for it",
    )
    arguments = parser.parse_args()
    if arguments.model not in names():
        problem = "is no model that can be exported"
        raise BadInput("MODEL", shown(arguments.model) or '""', problem, f"choose one of {', '.join(names())}")
    configured(arguments.model, arguments.settings)
    out = arguments.dataset.parent if arguments.out is None else arguments.out
    refuse_of_checkout(out, "--out" if arguments.out else "dataset")
    files = {split: out / arguments.model / f"{split}-{arguments.seed}.model" for split in SPLITS}
    for file in files.values():
        file_to_write(file, reads=[arguments.dataset])
    model = fit(arguments.model, arguments.settings, arguments.dataset, files, arguments.seed)
    errors = errors_of(files["within"], arguments.model, model, arguments.dataset, None).replace(ANEW, "").strip()
    print("\n".join([str(files["within"]), *(f"  {sentence}" for sentence in SENTENCE.split(errors))]))
    file, dataset = shlex.quote(str(files["within"])), shlex.quote(str(arguments.dataset))
    beside = f" --dataset {dataset}" if out.resolve() != arguments.dataset.resolve().parent else ""
    print(f"Next: export it: {command('export')} {file} --format c{beside}")
    saved = f"{command('predict')} {dataset} questions.csv --saved {file} --out answers.csv"
    print(f"  or ask it, as its export answers: {saved}")


if __name__ == "__main__":
    main()
