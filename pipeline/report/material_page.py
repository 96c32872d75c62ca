"""The reports of one material → reports/<material>/index.html, which shows its tables and figures."""

import argparse
from pathlib import Path

from ..ground.errors import program
from ..ground.files import write_text
from .marks import add_mark, mark_from
from .materials import part
from .recorded_strings import recorded_strings
from .web.glossary import glossary
from .web.markdown import INDEX
from .web.page import document, together


@program
def main() -> None:
    """Write `index.html` into the folder of a material: its tables, its figures, the ways to its other pages."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.material_page", description=main.__doc__)
    parser.add_argument("folder", type=Path, help="reports/<material>; a file that is not there is not shown")
    parser.add_argument("--dataset", type=Path, help="the material's dataset.parquet: which strings the page is of")
    add_mark(parser)
    arguments = parser.parse_args()
    folder: Path = arguments.folder
    strings = [recorded_strings(arguments.dataset, folder.name)] if arguments.dataset else []
    body = together([*strings, part(folder.parent, folder.name, up="../"), glossary()])
    text = document(folder.name, body, mark_from(arguments.made_by), above=INDEX)
    write_text(folder / "index.html", text)


if __name__ == "__main__":
    main()
