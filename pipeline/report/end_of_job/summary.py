"""The last words of a workflow: the tables that were asked for, the pages, and the verdicts."""

import re
from collections.abc import Collection, Iterable
from pathlib import Path

from ...ground.words.counts import counted
from ...ground.words.jump_notes import NAME, Kind, gravest, read_jumps
from ..layout import paper
from ..layout.plain_markdown import spoken
from ..model_to_take.errors_compared import models_csv
from ..model_to_take.fitted import lines_at_end
from ..parts.diagnoses import verdicts

ON_ONE_PAGE = "tables, figures, every model and how to ask it"
PAGE = "index.html"
PAGES = {"models.html": "beside the floor", "comparison.html": "beside the paper"}
TABLE_FORMS = ("csv", "md", "tex")
FIGURES = ("figure_4.png", "figure_5.png")
MARK = re.compile(r" \([^()]*\)$")  # in a table's title: that its fits are small, and no results
RUNS = 8  # whose verdicts are said, the newest of them; the first page has all
DOUBTS = {
    Kind.JUMP: (
        "Beware: the zero jumps between runs, as said above: until that is mended, the model to take may be wrong."
    ),
    Kind.NOT_COMPARED: "Beware: the zero was not compared there: if it was moved, the model to take may be wrong.",
    Kind.SET_ANEW: "All strokes from there on share the error of that zero.",
}
WHOLE = {
    "index.html": "the way to all of it", "campaign/campaign.html": "what a new string teaches a model",
    "proof/proof.html": "the concealed proof", "real/index.html": "public rigs",
}  # fmt: skip


def of_material(folder: Path, paths: set[Path], alone: bool = True, whole_motion: Collection[str] = ()) -> list[str]:
    """The next steps for a material: its page, its model and the export; `alone`: both tables before them.

    Without a page of all of it both tables as well, and where each file that was asked for lies. What was not asked for
    is not named.
    """
    names = {f"Table {'I' * number}": f"table_{number}" for number in paper.TABLES}
    written = [path for stem in names.values() if (path := folder / f"{stem}.md") in paths]
    on_one_page = folder / PAGE in paths
    text = [line for path in written for line in _table(path)] if alone or not on_one_page else []
    if on_one_page:
        text.append(f"{ON_ONE_PAGE}: {folder / PAGE}")
    else:
        text += _files(folder, paths, names)
    with models_csv(folder, paths) as errors:
        to_take = lines_at_end(folder.name, paths, errors, on_one_page, whole_motion)
    notes = [path for path in paths if path.name == NAME and path.parent.name == folder.name]
    on_zero = read_jumps(notes)
    doubt = [DOUBTS[gravest(on_zero)]] if to_take and on_zero else []
    return [*text, *on_zero, *doubt, *to_take]


def _files(folder: Path, paths: set[Path], names: dict[str, str]) -> list[str]:
    """Where each table, by its name, the figures and the pages of a material lie."""
    text = []
    for name, stem in names.items():
        files = [str(path) for suffix in TABLE_FORMS if (path := folder / f"{stem}.{suffix}") in paths]
        text += [f"{name}: {', '.join(files)}"] if files else []
    figures = [str(folder / name) for name in FIGURES if folder / name in paths]
    text += [f"figures: {', '.join(figures)}"] if figures else []
    return text + [f"{words}: {folder / page}" for page, words in PAGES.items() if folder / page in paths]


def _table(path: Path) -> list[str]:
    """A table's title and its rows, as a terminal shows them; what stands beneath them is in the file."""
    lines = spoken(path.read_text(encoding="utf-8")).splitlines()
    return [lines[0], *(line for line in lines if line.startswith("|")), ""]


def _mark(folder: Path, paths: set[Path]) -> str:
    """The remark that a material's tables come from small fits, as in their titles; else empty."""
    table = next((path for path in sorted(paths) if path.parent == folder and path.name == "table_1.md"), None)
    title = table.read_text(encoding="utf-8").partition("\n")[0] if table else ""
    marked = MARK.search(spoken(title))
    return marked.group() if marked else ""


def _made_at(folder: Path) -> float:
    """When a diagnosis was made, in s since 1970; 0 where its verdict is missing."""
    verdict = folder / "verdict.txt"
    return verdict.stat().st_mtime if verdict.is_file() else 0.0


def summary(
    made_paths: Iterable[str], reports: Path, materials: list[str], runs: list[str], whole_motion: Collection[str] = ()
) -> str:
    """The next steps: each material's page and model, a line on each run's diagnosis, and all pages.

    `made_paths` lists what the run was asked for and is whole: nothing else is named, however old it lies there. The
    tables of one material are shown; of several, their pages are named. `whole_motion` names models that answer along a
    whole motion alone.
    """
    paths, text = {path for path in map(Path, made_paths) if path.exists()}, []
    tables = [material for material in materials if reports / material / "table_1.md" in paths]
    for material in materials:
        lines = of_material(reports / material, paths, len(tables) < 2, whole_motion)
        if lines:
            head = f"{material}{_mark(reports / material, paths)}"
            text += [f"\n== {head} " + "=" * max(0, 90 - len(head)), *lines]
    folders = [reports / "diagnosis" / run for run in runs if reports / "diagnosis" / run in paths]
    folders = sorted(folders, key=_made_at, reverse=True) if len(folders) > RUNS else folders
    words = verdicts(folders[:RUNS])
    if words:
        text.append("\n== what the simulator leaves out " + "=" * 62)
        earlier = f"{counted(len(folders) - RUNS, 'more run')}, made earlier, and " if len(folders) > RUNS else ""
        more = f"{earlier}of each "
        text.append(f"{words}\n{more}what to do: {reports / 'diagnosis' / '<run>' / 'verdict.txt'}")
    whole = [f"{words}: {reports / page}" for page, words in WHOLE.items() if reports / page in paths]
    return "\n".join([*text, *([""] if whole else []), *whole, ""])
