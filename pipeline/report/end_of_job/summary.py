"""What a run of the workflow says at its end: the tables that it was asked for, the pages, and the verdicts."""

from collections.abc import Iterable
from pathlib import Path

from ...ground.jump_notes import NAME, read_jumps
from ..model_to_take.fitted import lines_at_end
from ..parts.diagnoses import verdicts
from ..text import paper
from ..text.plain_markdown import spoken

PAGES = {
    "index.html": "tables and figures on one page",
    "models.html": "beside the floor",
    "comparison.html": "beside the paper",
}
TABLE_FORMS = ("csv", "md", "tex")
FIGURES = ("figure_4.png", "figure_5.png")
JUMPED = "Beware: the zero jumps between runs, as said above: until that is mended, the model to take may be wrong."
WHOLE = {
    "index.html": "the way to all of it", "campaign/campaign.html": "what a new string teaches a model",
    "proof/proof.html": "the concealed proof", "real/index.html": "public rigs",
}  # fmt: skip


def of_material(folder: Path, paths: set[Path]) -> list[str]:
    """Both tables of a material, its other pages and its fitted models; nothing of what was not asked for."""
    names = {f"Table {'I' * number}": f"table_{number}" for number in paper.TABLES}
    text = [
        spoken(path.read_text(encoding="utf-8")) for stem in names.values() if (path := folder / f"{stem}.md") in paths
    ]
    for name, stem in names.items():
        files = [str(path) for suffix in TABLE_FORMS if (path := folder / f"{stem}.{suffix}") in paths]
        text += [f"{name}: {', '.join(files)}"] if files else []
    figures = [str(folder / name) for name in FIGURES if folder / name in paths]
    if figures:
        text.append(f"figures: {', '.join(figures)}")
    text += [f"{words}: {folder / page}" for page, words in PAGES.items() if folder / page in paths]
    to_take = lines_at_end(folder.name, paths, folder / "models.csv")
    notes = [path for path in paths if path.name == NAME and path.parent.name == folder.name]
    return text + ([JUMPED] if to_take and read_jumps(notes) else []) + to_take


def summary(made_paths: Iterable[str], reports: Path, materials: list[str], runs: list[str]) -> str:
    """Tables, places of the pages, and a line on each run's diagnosis.

    `made_paths` lists what the run was asked for and is whole: nothing else is named, however old it lies there.
    """
    paths, text = {path for path in map(Path, made_paths) if path.exists()}, []
    for material in materials:
        lines = of_material(reports / material, paths)
        if lines:
            text += [f"\n== {material} " + "=" * max(0, 90 - len(material)), *lines]
    words = verdicts([reports / "diagnosis" / run for run in runs if reports / "diagnosis" / run in paths])
    if words:
        text.append("\n== what the simulator leaves out " + "=" * 62)
        text.append(f"{words}\nfigures: {reports / 'diagnosis' / '<run>' / 'diagnosis.png'}")
    text += [f"\n{words}: {reports / page}" for page, words in WHOLE.items() if reports / page in paths]
    return "\n".join([*text, ""])
