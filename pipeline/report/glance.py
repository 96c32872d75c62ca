"""The index's first lines: each material's best model beside the floor, each run's verdict and the run to make next."""

import csv
from pathlib import Path

from markupsafe import Markup

from .diagnoses import content_of, named_of, tag, verdict_of
from .web.page import Text, anchor, paragraph, together
from .web.table import table

FLOORS = ("floor", "floor_blind")
LONGEST = 90  # characters of a next run in a table; the whole of it stands beside the verdict


def best(models: Path, way: str) -> list[str]:
    """Title, RMSE and times the floor of the best model of one way within strokes; empty texts where there is none."""
    if not models.is_file():
        return ["", "", ""]
    with open(models, encoding="utf-8", newline="") as file:
        rows = [
            row
            for row in csv.DictReader(file)
            if (row["split"], row["map"], row["column"]) == ("within", way, "all") and row["model"] not in FLOORS
        ]
    if not rows:
        return ["", "", ""]
    least = min(rows, key=lambda row: float(row["median"]))
    return [least["title"], f"{float(least['median']):.3f}", f"{float(least['ratio']):.2f}" if least["ratio"] else ""]


def materials_table(reports: Path, materials: list[str]) -> Markup:
    """Each material's best model, its error and how many times the floor that is, both ways."""
    rows: list[list[Text]] = []
    for material in materials:
        name = Markup('<a href="#{}">{}</a>').format(anchor("material", material), material)
        rows.append([name, *best(reports / material / "models.csv", "forward")])
        rows[-1] += best(reports / material / "models.csv", "inverse")
    head = ["Material", "best model", "RMSE (mm)", "× floor", "best model", "RMSE (turns)", "× floor"]
    over = [("", 1), ("forward, within strokes", 3), ("inverse, within strokes", 3)]
    return table(head, rows, texts=(0, 1, 4), over=over)


def shortened(text: str) -> str:
    """The first words of a run to make: up to its first colon or semicolon, or as many words as fit."""
    first = min((text.split(sign)[0] for sign in (": ", "; ", ". ")), key=len).rstrip(".")
    if len(first) <= LONGEST:
        return first
    return first[:LONGEST].rsplit(" ", 1)[0] + " …"


def next_run(folder: Path) -> str:
    """The run that a diagnosis asks for, in a few words; empty where it asks for none."""
    content = content_of(folder) or {}
    return shortened(str(content.get("next_experiment") or ""))


def runs_table(reports: Path, runs: list[str]) -> Markup:
    """Each run's verdict, what it names and the run to make next."""
    rows: list[list[Text]] = []
    for run in runs:
        folder = reports / "diagnosis" / run
        name = Markup('<a href="#{}">{}</a>').format(anchor("run", run), run)
        rows.append([name, tag(verdict_of(folder)), named_of(folder), next_run(folder)])
    return table(["Run", "Verdict", "Left out of the simulator", "Next run"], rows, texts=(0, 1, 2, 3))


def glance(reports: Path, materials: list[str], runs: list[str]) -> Markup:
    """The opening of the index."""
    parts: list[Text] = [Markup('<h2 id="glance">At a glance</h2>')]
    if materials:
        parts.append(materials_table(reports, materials))
    if runs:
        parts.append(runs_table(reports, runs))
    if not materials and not runs:
        parts.append(paragraph("No run lies in raw/ yet."))
    return together(parts)
