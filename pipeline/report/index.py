"""Reports → index.html, the short answer first, and a page of each run. It leads to these and to each material's page.

What is few it shows itself, folded; of many it shows a line each. No page grows with the figures of all runs.
"""

import argparse
import json
import os
import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path

from markupsafe import Markup

from ..ground.errors import BadInput, program
from ..ground.input.words_by_file import SIGN
from ..ground.names import SYNTHETIC
from ..ground.stored.files import write_text
from ..ground.words.left_out import LeftOut
from . import left_out
from .layout.made_by import MadeBy
from .parts import diagnoses, jumps
from .parts.index_head import glance
from .parts.page_parts import FOLDER, Parts, of_materials, of_runs
from .parts.rig_mark import Marks, add_rig_mark, marks_of_runs
from .web.glossary import glossary
from .web.marks import add_mark, mark_from
from .web.page import Text, anchor, document, folded, paragraph, together

OTHERS = {
    "campaign/campaign.html": "What a new string teaches a model",
    "proof/proof.html": "The concealed proof",
    "real/index.html": "Recordings of public rigs",
}
NUMBERS = 'All numbers: <a href="metrics.csv">metrics.csv</a>, its columns explained in <a href="{0}">{0}</a>.'


def others(reports: Path) -> Markup:
    """Links to the pages of other targets that are there when the index is written."""
    pages_there = [
        Markup('<a href="{}">{}</a>').format(page, words)
        for page, words in OTHERS.items()
        if (reports / page).is_file()
    ]
    return paragraph(Markup("Also made: {}.").format(Markup(" · ").join(pages_there))) if pages_there else Markup("")


def material_of(strings: Mapping[str, Sequence[str]]) -> dict[str, str]:
    """The material of each run, of the runs of each material."""
    return {run: material for material, own in strings.items() for run in own}


def readable(reports: Path, runs: Sequence[str], of: Mapping[str, str]) -> tuple[list[str], list[LeftOut]]:
    """Runs whose diagnosis can be read, and those that are left out, for theirs cannot; `of` gives a run's material."""
    whole, damaged = [], []
    for run in runs:
        try:
            diagnoses.content_of(reports / "diagnosis" / run)
            whole.append(run)
        except BadInput as error:
            damaged.append(LeftOut.of(run, error, of.get(run, "")))
    return whole, damaged


def verdict_tag(reports: Path, run: str) -> Markup:
    """A run's verdict in its colour."""
    return diagnoses.tag_of(reports / "diagnosis" / run)


def page(
    reports: Path,
    materials: Parts,
    runs: Parts,
    strings: Mapping[str, Sequence[str]],
    gone: list[LeftOut],
    mark: MadeBy,
    jumped: jumps.Notes = jumps.NONE,
) -> str:
    """The index's HTML; links are relative to the reports' folder, so that it can be moved as a whole.

    `strings` gives the runs of each material, `jumped` what is said of jumps of its zero.
    """
    of = material_of(strings)
    body: list[Text] = [glance(reports, materials.names, runs.names, of, materials.link, runs.link, jumped)]
    places: list[tuple[str, Text]] = [("glance", "At a glance")]
    places += [(kind, kind.capitalize()) for kind, parts in (("materials", materials), ("runs", runs)) if not parts.few]
    if gone:
        places.append(("left-out", "Left out"))
        body.append(left_out.section(gone))
    if jumped:
        places.append(("jumps", jumps.title(jumped)))
    if materials.names:
        body.append(paragraph(Markup(NUMBERS).format("metrics.csv-metadata.json")))
    body.append(others(reports))
    body += materials.here(lambda material: "tables, figures, every model", level=2)
    places += [(anchor("material", name), name) for name in materials.names if materials.few]
    shown = runs.here(lambda run: verdict_tag(reports, run), level=3)
    if shown:
        places.append(("diagnosis", "What the simulator leaves out"))
        body.append(
            folded("diagnosis", "What the simulator leaves out", "each run's words and figure", together(shown))
        )
    places.append(("glossary", "Glossary"))
    body.append(glossary())
    return document("twistbench reports", together(filter(None, body)), mark, places)


def write_pages(reports: Path, folder: Path, runs: Parts, marks: Marks) -> None:
    """Write the pages of all runs in place of those of an earlier time, all of them or none."""
    temporary = folder.with_name(f".{folder.name}.{os.getpid()}")
    try:
        temporary.mkdir(parents=True)
        runs.write(temporary, marks, {run: verdict_tag(reports, run) for run in runs.names})
        shutil.rmtree(folder, ignore_errors=True)
        os.rename(temporary, folder)
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


@program
def main() -> None:
    """Write `index.html`, and beside it `pages/`."""
    parser = argparse.ArgumentParser(
        prog="python -m pipeline.report.index", description=main.__doc__, fromfile_prefix_chars=SIGN
    )
    parser.add_argument("materials", nargs="*")
    parser.add_argument("--runs", nargs="*", default=[], help="runs that are diagnosed")
    parser.add_argument("--strings", type=json.loads, default={}, metavar="JSON", help="the runs of each material")
    parser.add_argument("--reports", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True, help="the file of the page, HTML; required")
    add_mark(parser)
    add_rig_mark(parser)
    left_out.arguments(parser)
    jumps.arguments(parser)
    arguments = parser.parse_args()
    mark, gone, reports = mark_from(arguments.made_by), left_out.told(arguments), arguments.reports
    marks = marks_of_runs(arguments.rig_mark, mark, arguments.strings.get(SYNTHETIC, []))
    of = material_of(arguments.strings)
    diagnosed, damaged = readable(reports, arguments.runs, of)
    for left_out_run in damaged:
        print(f"left out: {left_out_run.why}", flush=True)
    gone = sorted([*gone, *damaged], key=lambda left_out_run: left_out_run.run)
    runs = of_runs(reports, diagnosed)
    materials = of_materials(reports, arguments.materials, arguments.strings, runs)
    text = page(reports, materials, runs, arguments.strings, gone, mark, jumps.by_material(arguments.jumps))
    write_text(arguments.out, text)
    write_pages(reports, arguments.out.with_name(FOLDER), runs, marks)


if __name__ == "__main__":
    main()
