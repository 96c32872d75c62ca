"""Models.csv of each material → the index's table: the model to take, its errors, and beside it the simulator's."""

import csv
from collections.abc import Callable
from pathlib import Path

from markupsafe import Markup

from .stroke_conditions import APART
from .usual_model import ALONE, USUAL, WHY_USUAL, chosen_of, uses, weighed
from .web.page import Text, paragraph, together
from .web.table import table

FLOORS = ("floor", "floor_blind")
WAYS, SPLITS = ("forward", "inverse"), ("within", "later")
MODEL_HEADS = ["held-out points", "later strokes"]
Name = Callable[[str], Text]  # the name of a material as a link to its part
Cells = dict[tuple[str, str, str], str]  # model, split and way → RMSE, and times the floor that is


def read(models: Path) -> tuple[dict[str, str], Cells]:
    """Titles of the models of a material, and their errors on all points; nothing where the file is not there."""
    titles, cells = dict[str, str](), Cells()
    if not models.is_file():
        return titles, cells
    with open(models, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            if row["column"] != "all" or row["model"] in FLOORS:
                continue
            titles[row["model"]] = row["title"]
            times = f" ({float(row['ratio']):.2f} ×)" if row["ratio"] else ""
            cells[row["model"], row["split"], row["map"]] = f"{float(row['median']):.3f}{times}"
    return titles, cells


def row(models: Path) -> list[str]:
    """Title of the model to take, its errors both ways on both splits, and the diagnosed simulator's forward."""
    titles, cells = read(models)
    chosen = chosen_of(titles)
    own = [cells.get((chosen, split, way), "") for way in WAYS for split in SPLITS]
    return [titles.get(chosen, ""), *own, *(cells.get((ALONE, split, "forward"), "") for split in SPLITS)]


def later_apart(models: Path) -> str:
    """What the page of every model says of later strokes that differ in more than their number; empty where nothing."""
    lines = models.read_text(encoding="utf-8").splitlines() if models.is_file() else []
    return next((line for line in lines if line.startswith(APART)), "")


def errs_less(models: Path) -> str:
    """Which other model of a material errs less than the one to take; empty where none does."""
    titles, cells = read(models)
    return weighed(titles, {(model, split): float(cell.split()[0]) for (model, split, way), cell in cells.items()
                            if way == WAYS[0]})  # fmt: skip


def words(reports: Path, materials: list[str]) -> Markup:
    """Why these models, the commands that use one, and what the simulator beside them is."""
    titles = {material: read(reports / material / "models.csv")[0] for material in materials}
    chosen = {material: chosen_of(titles[material]) for material in materials}
    usual = [material for material, model in chosen.items() if model == USUAL]
    lines: list[Text] = []
    if usual:
        title = titles[usual[0]][USUAL]
        export, _ = uses(usual[0] if len(usual) == 1 else "<material>", USUAL)
        text = "{} is the model to take, for {}; the one that is exported: <code>{}</code>. Which errs least on what: "
        text += "the page of every model, below."
        lines.append(Markup(text).format(title, WHY_USUAL, export))
    if others := [material for material, model in chosen.items() if model not in ("", USUAL)]:
        lines.append(
            f"Of {', '.join(others)} no spline was fitted: the first model by name that can be exported is shown."
        )
    for material in materials:
        if less := errs_less(reports / material / "models.csv"):
            lines.append(f"{material}: {less}")
    for material in materials:
        if apart := later_apart(reports / material / "models.md"):
            lines.append(f"{material}: {apart}")
    if named := next((titles[material][ALONE] for material in materials if ALONE in titles[material]), ""):
        lines.append(
            f"{named} is no model to take away: it needs the whole motion, so it can be neither exported nor asked. "
            "It is what a simulator with the named effects would err; where its error on later strokes is large, the "
            "named effects do not foresee them."
        )
    return together(paragraph(line) for line in lines)


def materials_table(reports: Path, materials: list[str], name: Name) -> Markup:
    """Each material's model to take with its errors, the diagnosed simulator's beside them, and why beneath."""
    rows: list[list[Text]] = [[name(material), *row(reports / material / "models.csv")] for material in materials]
    head = ["Material", "model to take", *MODEL_HEADS, *MODEL_HEADS, *MODEL_HEADS]
    over: list[tuple[Text, int]] = [
        ("", 2),
        ("forward: RMSE in mm (× floor)", 2),
        ("inverse: RMSE in turns (× floor)", 2),
    ]
    over.append(("the diagnosed simulator, forward", 2))
    return together([table(head, rows, texts=(0, 1), over=over, paged=True), words(reports, materials)])
