"""A saved model fitted once more, with its own settings, to all points of its dataset, or of one of its strings.

None is left to test it on.
"""

import json
from pathlib import Path

from ..ground.errors import BadInput
from ..ground.stored import schemas
from ..ground.stored.given_table import opened as opened_table
from ..models.interface import about, settings_of
from ..models.parts.configured import configured, fitting
from ..models.parts.fitted_to import ALL, note_points
from ..models.parts.settings import shown, values
from ..models.parts.thinned import thinned
from .source import Beside, dataset_of, opened

STEM, OF_ONE = "all-0", "all-of-"  # of the file that is written beside the saved model; of one string, before its name


def string_alone(file: Path) -> str:
    """The string that alone a file's model was fitted to, from the file's name; empty for any other file."""
    stem = file.resolve().stem
    return stem.removeprefix(OF_ONE) if stem.startswith(OF_ONE) else ""


def fitted_to_all(file: Path, name: str | None, beside: Beside) -> Path:
    """The file of the model fitted to all points, or to those of one string if named.

    Raises BadInput as the export of the saved one does, and for a string that the dataset does not have.
    """
    source = opened(file, name, beside)
    string = "" if about(source.name).each_string_apart else beside.string or ""
    table = opened_table(dataset_of(file, beside), schemas.DATASET, "say --dataset FILE")
    if string:
        recorded = sorted(set(table["string"].astype(str)))
        if string not in recorded:
            problem = f"is {shown(string)}, which is not in {dataset_of(file, beside)}"
            raise BadInput("--string", string, problem, f"say one of {', '.join(recorded)}")
        table = table[table["string"].astype(str) == string]
    points = thinned(table)
    settings = values(source.model.settings) if settings_of(source.name) else {}
    model = configured(source.name, json.dumps(settings))
    with fitting(source.name):
        model.fit(points, 0)
    out = file.with_name(f"{OF_ONE + string if string else STEM}{file.suffix}")
    model.save(out)
    note_points(out, table, ALL, string)
    return out
