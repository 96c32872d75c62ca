"""The reports of one material → reports/<material>/index.html, which shows its tables and figures."""

import argparse
from pathlib import Path

from ..ground.errors import program
from ..ground.stored.files import write_text
from ..ground.words.jump_notes import read_jumps
from .parts import jumps
from .parts.material_head import left_out_of, model_to_take
from .parts.materials import part
from .parts.recorded_strings import by_stroke, recorded_strings, runs_of_strings
from .shown.run_strokes import tared_runs
from .web.glossary import glossary
from .web.markdown import INDEX
from .web.marks import add_mark, mark_from
from .web.page import document, together


@program
def main() -> None:
    """Write `index.html` into the folder of a material: its tables, its figures, the ways to its other pages."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.material_page", description=main.__doc__)
    parser.add_argument("folder", type=Path, help="reports/<material>; a file that is not there is not shown")
    parser.add_argument("--dataset", type=Path, help="the material's dataset.parquet: which strings the page is of")
    parser.add_argument("--runs", type=Path, nargs="*", default=[], help="raw/<run>: whose run.yaml says `tare: run`")
    add_mark(parser)
    jumps.arguments(parser)
    arguments = parser.parse_args()
    folder: Path = arguments.folder
    parts = [jumps.box(read_jumps(arguments.jumps)), model_to_take(folder)]
    if arguments.dataset:
        strokes = by_stroke(arguments.dataset)
        tared = tared_runs(arguments.runs) if arguments.runs else None
        parts += [recorded_strings(strokes, folder.name, tared), left_out_of(runs_of_strings(strokes))]
    parts += [part(folder.parent, folder.name, up="../"), glossary()]
    text = document(folder.name, together(filter(None, parts)), mark_from(arguments.made_by), above=INDEX)
    write_text(folder / "index.html", text)


if __name__ == "__main__":
    main()
