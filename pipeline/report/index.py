"""Reports → index.html, one page: the short answer first, then every material's and every run's part, folded."""

import argparse
from collections.abc import Sequence
from pathlib import Path

from markupsafe import Markup

from ..ground.errors import program
from ..ground.files import write_text
from ..run.left_out import LeftOut
from ..string.jump_notes import read_jumps
from . import diagnoses, jumps, left_out, materials
from .glance import glance
from .made_by import MadeBy
from .marks import add_mark, mark_from
from .web.glossary import glossary
from .web.page import Text, anchor, document, paragraph, together

OTHERS = {
    "campaign/campaign.html": "What a new string teaches a model",
    "proof/proof.html": "The concealed proof",
    "real/index.html": "Recordings of public rigs",
}


def others(reports: Path) -> Markup:
    """Links to the pages of other targets that are there when the index is written."""
    there = [
        Markup('<a href="{}">{}</a>').format(page, words)
        for page, words in OTHERS.items()
        if (reports / page).is_file()
    ]
    return paragraph(Markup("Also made: {}.").format(Markup(" · ").join(there))) if there else Markup("")


def page(
    reports: Path, named: list[str], runs: list[str], gone: list[LeftOut], mark: MadeBy, jumped: Sequence[str] = ()
) -> str:
    """The page's HTML; links are relative to the reports' folder, so that it can be moved as a whole."""
    numbers = Markup(
        'All numbers: <a href="metrics.csv">metrics.csv</a>, its columns explained in <a href="{}">{}</a>.'
    )
    described = "metrics.csv-metadata.json"
    body: list[Text] = [glance(reports, named, runs)]
    places: list[tuple[str, Text]] = [("glance", "At a glance")]
    if gone:
        places.append(("left-out", "Left out"))
        body.append(left_out.section(gone))
    if jumped:
        places.append(("jumps", "The zero jumps"))
        body.append(jumps.section(jumped))
    if named:
        body.append(paragraph(numbers.format(described, described)))
    body.append(others(reports))
    for material in named:
        places.append((anchor("material", material), material))
        body.append(materials.section(reports, material))
    if runs:
        places.append(("diagnosis", "What the simulator leaves out"))
        body.append(diagnoses.section(reports, runs))
    places.append(("glossary", "Glossary"))
    body.append(glossary())
    return document("twistbench reports", together(filter(None, body)), mark, places)


@program
def main() -> None:
    """Write `index.html`."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.index", description=__doc__)
    parser.add_argument("materials", nargs="*")
    parser.add_argument("--runs", nargs="*", default=[], help="runs that are diagnosed")
    parser.add_argument("--reports", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True, help="the file of the page, HTML; required")
    add_mark(parser)
    left_out.arguments(parser)
    jumps.arguments(parser)
    arguments = parser.parse_args()
    mark, gone = mark_from(arguments.made_by), left_out.told(arguments)
    jumped = read_jumps(arguments.jumps)
    write_text(arguments.out, page(arguments.reports, arguments.materials, arguments.runs, gone, mark, jumped))


if __name__ == "__main__":
    main()
