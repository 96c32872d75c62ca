"""A dataset → reports/<material>/croissant.json: what its columns are, for programs that read Croissant metadata.

Source: MLCommons, Croissant format specification 1.0, 2024.
"""

import argparse
import json
import os
from pathlib import Path

import pandas as pd
import pyarrow as pa

from ..ground.errors import program
from ..ground.stored import schemas
from ..ground.stored.files import sha256, write_text
from ..ground.units import unit_of
from .layout.made_by import MadeBy, sentence
from .web.marks import add_mark, mark_from

CONTEXT = {  # as the specification gives it
    "@language": "en", "@vocab": "https://schema.org/", "citeAs": "cr:citeAs", "column": "cr:column",
    "conformsTo": "dct:conformsTo", "cr": "http://mlcommons.org/croissant/", "rai": "http://mlcommons.org/croissant/RAI/",
    "data": {"@id": "cr:data", "@type": "@json"}, "dataType": {"@id": "cr:dataType", "@type": "@vocab"},
    "dct": "http://purl.org/dc/terms/", "equivalentProperty": "cr:equivalentProperty",
    "examples": {"@id": "cr:examples", "@type": "@json"}, "extract": "cr:extract", "field": "cr:field",
    "fileProperty": "cr:fileProperty", "fileObject": "cr:fileObject", "fileSet": "cr:fileSet", "format": "cr:format",
    "includes": "cr:includes", "isLiveDataset": "cr:isLiveDataset", "jsonPath": "cr:jsonPath", "key": "cr:key",
    "md5": "cr:md5", "parentField": "cr:parentField", "path": "cr:path", "recordSet": "cr:recordSet",
    "references": "cr:references", "regex": "cr:regex", "repeated": "cr:repeated", "replace": "cr:replace",
    "samplingRate": "cr:samplingRate", "sc": "https://schema.org/", "separator": "cr:separator",
    "source": "cr:source", "subField": "cr:subField", "transform": "cr:transform",
}  # fmt: skip
CONFORMS = "http://mlcommons.org/croissant/1.0"
KINDS = {pa.float64(): "sc:Float", pa.int32(): "sc:Integer", pa.string(): "sc:Text", pa.bool_(): "sc:Boolean"}
FILE, POINTS = "dataset.parquet", "points"
HOLDS = {
    "run": "name of the recording",
    "string": "which string it is: a name of its own",
    "stroke": "the stroke's number since the string was new, from 1",
    "phase": "winding or unwinding",
    "direction": "1 winding, -1 unwinding",
    "block": "number of the block of neighbouring points that the split within strokes holds out, or not, as a whole",
    "within": "in the split within strokes: train, test, or empty where it is not used",
    "later": "in the split of whole later strokes: train, test, or empty where it is not used",
    "time_s": "time since the recording began",
    "motor_turns": "twist of the string, 0 where it is untwisted",
    "displacement_mm": "contraction of the string, its zero that of the simulator at rest before the first stroke",
    "load_n": "load on the string",
    "actuator": "kind of rig",
    "radius_mm": "radius of the string, as measured",
    "length_mm": "length of the string, as measured",
    "stiffness_n_per_mm": "stiffness of the string, as measured, or the usual one",
    "torsion_zone_mm": "length of the torsion zone, no number where the rig has none",
    "separator_mm": "size of the separator, no number where the rig has none",
    "radius_tolerance": "one sigma of the radius, as a share of it",
    "length_tolerance_mm": "one sigma of the length",
    "torsion_zone_tolerance_mm": "one sigma of the torsion zone",
    "separator_tolerance_mm": "one sigma of the separator",
}


def fields(names: list[str]) -> list[dict[str, object]]:
    """Each column of a dataset as a field: type, unit and what it holds."""
    entries: list[dict[str, object]] = []
    for name in names:
        unit = unit_of(name)
        entries.append(
            {
                "@type": "cr:Field",
                "@id": f"{POINTS}/{name}",
                "name": name,
                "description": HOLDS[name] + (f", in {unit}" if unit != "1" else ""),
                "dataType": KINDS[schemas.DATASET.field(name).type],
                "source": {"fileObject": {"@id": FILE}, "extract": {"column": name}},
            }
        )
    return entries


def croissant(dataset: Path, table: pd.DataFrame, beside: Path, mark: MadeBy) -> dict[str, object]:
    """The metadata of a dataset file; `beside` is the folder in which they will lie, from which the file is named."""
    material, runs = dataset.parent.name, sorted(set(table["run"]))
    return {
        "@context": CONTEXT,
        "@type": "sc:Dataset",
        "name": f"twistbench-{material}",
        "description": f"{len(table)} points of {len(runs)} recordings of twisted strings of {material}, cut into "
        f"strokes and put on one zero: {', '.join(runs)}. {sentence(mark)}",
        "conformsTo": CONFORMS,
        "distribution": [
            {
                "@type": "cr:FileObject",
                "@id": FILE,
                "name": FILE,
                "contentUrl": Path(os.path.relpath(dataset, beside)).as_posix(),
                "contentSize": f"{dataset.stat().st_size} B",
                "encodingFormat": "application/x-parquet",
                "sha256": sha256(dataset),
            }
        ],
        "recordSet": [
            {
                "@type": "cr:RecordSet",
                "@id": POINTS,
                "name": POINTS,
                "description": "one record a sample of a winding or an unwinding",
                "field": fields([*table]),
            }
        ],
    }


@program
def main() -> None:
    """Write `croissant.json`."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.croissant", description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="the file of the metadata, json; required")
    add_mark(parser)
    arguments = parser.parse_args()
    table = schemas.read(arguments.dataset, schemas.DATASET)
    content = croissant(arguments.dataset, table, arguments.out.parent, mark_from(arguments.made_by))
    write_text(arguments.out, json.dumps(content, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main()
