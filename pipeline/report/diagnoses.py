"""Verdicts of the diagnosis → their part of index.html: a table of all runs, then each run's words and figures."""

import html
import json
from pathlib import Path
from typing import Any
from urllib.parse import quote

from pipeline.schemas import unit_of

TIES = 2  # of the explanations that fit alike: a cell names so many
HEAD = ("Run", "Verdict", "Left out", "Mismatch", "Nominal", "Calibrated", "Explained", "Noise", "Next run")


def row(folder: Path) -> list[str]:
    """A run's cells: its verdict, what it names, the mismatch, and the error on strokes that no fit has seen."""
    path = folder / "diagnosis.json"
    if not path.is_file():
        return [folder.name, "not decided", *[""] * (len(HEAD) - 2)]
    content: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    unit = next(key for key in content["fit"] if key.startswith("noise_floor_")).removeprefix("noise_floor_")
    said = unit_of(f"_{unit}")
    named = " + ".join(entry["id"] for entry in content["mechanisms"])
    ties = [" + ".join(other) for other in content["alternatives"]]
    others = "".join(f" or {tie}" for tie in ties[:TIES]) + (f" or {len(ties) - TIES} more" if ties[TIES:] else "")
    held = content["fit"]["heldout"] or {}
    sizes = [(content["mismatch"] or {}).get(f"rms_{unit}")]
    sizes += [held.get(f"{name}_{unit}") for name in ("nominal", "calibrated", "explained")]
    sizes.append(content["fit"][f"noise_floor_{unit}"])
    return [
        folder.name,
        content["verdict"],
        named + others,
        *("" if size is None else f"{float(f'{size:.2g}'):g} {said}" for size in sizes),
        (content.get("next_experiment") or "").partition(":")[0],
    ]


def section(reports: Path, runs: list[str]) -> str:
    """HTML of the verdicts on runs, whose folders lie in `reports/diagnosis/`."""
    head = "".join(f"<th>{name}</th>" for name in HEAD)
    text = ["<h2 id=diagnosis>What the simulator leaves out</h2>"]
    text.append("<p>Nominal, calibrated and explained: the error on the last strokes, which no fit has seen.</p>")
    text.append(f"<table class=verdicts>\n<tr>{head}</tr>")
    for run in runs:
        name, *cells = (html.escape(cell) for cell in row(reports / "diagnosis" / run))
        data = "".join(f"<td>{cell}</td>" for cell in cells)
        text.append(f'<tr><td><a href="#diagnosis-{name}">{name}</a></td>{data}</tr>')
    text.append("</table>")
    for run in runs:
        folder, name = reports / "diagnosis" / run, html.escape(run)
        text.append(f'<h3 id="diagnosis-{name}">{name}</h3>')
        text.append(f"<pre>{html.escape((folder / 'verdict.txt').read_text(encoding='utf-8'))}</pre>")
        if (folder / "diagnosis.png").is_file():
            link = f"diagnosis/{html.escape(quote(run))}/diagnosis"
            text.append(f'<a href="{link}.pdf"><img src="{link}.png" alt="Diagnosis of {name}"></a>')
    return "\n".join(text)


def verdicts(reports: Path, runs: list[str]) -> str:
    """One line a run that has a verdict, for the end of the main job."""
    folders = [reports / "diagnosis" / run for run in runs]
    lines = []
    for folder in folders:
        if (folder / "verdict.txt").is_file():
            words = (folder / "verdict.txt").read_text(encoding="utf-8").splitlines()[0]
            lines.append(f"{words} {row(folder)[2]}".rstrip())
    return "\n".join(lines)
