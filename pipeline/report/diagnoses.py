"""Verdicts of the diagnosis → their part of index.html: a table of all runs, then each run's words and figures."""

import json
from pathlib import Path
from typing import Any

from markupsafe import Markup

from ..ground.schemas import unit_of
from .web.glossary import word
from .web.page import Text, anchor, folded, link, paragraph, picture, together
from .web.table import table

HEAD = ("Run", "Mismatch", "Nominal", "Calibrated", "Explained", "Noise")
VERDICTS = ("consistent", "parameters", "explained", "ambiguous", "unknown")
UNDECIDED = "not decided"
TIES = 2  # of the explanations that fit alike: a line names so many


def content_of(folder: Path) -> dict[str, Any] | None:
    """What a diagnosis wrote, or None where the recording was refused."""
    path = folder / "diagnosis.json"
    content: dict[str, Any] | None = json.loads(path.read_text(encoding="utf-8")) if path.is_file() else None
    return content


def verdict_of(folder: Path) -> str:
    """The verdict in a word."""
    content = content_of(folder)
    return UNDECIDED if content is None else str(content["verdict"])


def explanations(folder: Path) -> list[list[str]]:
    """What the best explanation names, then each that ties with it."""
    content = content_of(folder)
    if content is None or not content["mechanisms"]:
        return []
    return [[entry["id"] for entry in content["mechanisms"]], *content["alternatives"]]


def named_of(folder: Path) -> Markup:
    """What a verdict names, each id with its meaning, and how many other explanations tie with it."""
    sets = explanations(folder)
    best = Markup(" + ").join(word(id_) for id_ in sets[0]) if sets else Markup("")
    others = len(sets) - 1
    return best + (f", or {others} other explanation{'s' * (others > 1)}" if others > 0 else "")


def tag(verdict: str) -> Markup:
    """A verdict in its colour."""
    of = verdict if verdict in VERDICTS else "none"
    return Markup('<span class="verdict {}">{}</span>').format(of, word(verdict))


def sizes(folder: Path) -> list[str]:
    """The mismatch, the error on strokes that no fit has seen, and the noise floor, each with its unit."""
    content = content_of(folder)
    if content is None:
        return [""] * (len(HEAD) - 1)
    unit = next(key for key in content["fit"] if key.startswith("noise_floor_")).removeprefix("noise_floor_")
    held = content["fit"]["heldout"] or {}
    found = [(content["mismatch"] or {}).get(f"rms_{unit}")]
    found += [held.get(f"{name}_{unit}") for name in ("nominal", "calibrated", "explained")]
    found.append(content["fit"][f"noise_floor_{unit}"])
    return ["" if size is None else f"{float(f'{size:.2g}'):g} {unit_of(f'_{unit}')}" for size in found]


def words_of(folder: Path) -> str:
    """The verdict as a person reads it."""
    path = folder / "verdict.txt"
    return path.read_text(encoding="utf-8") if path.is_file() else f"{folder.name}: no verdict was written"


def one_run(reports: Path, run: str) -> Markup:
    """One run's words and figure, folded."""
    folder = reports / "diagnosis" / run
    parts: list[Text] = [Markup("<pre>{}</pre>").format(words_of(folder))]
    if (folder / "diagnosis.png").is_file():
        better = "diagnosis.pdf" if (folder / "diagnosis.pdf").is_file() else "diagnosis.png"
        source, target = link("diagnosis", run, "diagnosis.png"), link("diagnosis", run, better)
        parts.append(picture(source, f"Diagnosis of {run}", target))
    return folded(anchor("run", run), run, tag(verdict_of(folder)), together(parts), level=3)


def section(reports: Path, runs: list[str]) -> Markup:
    """HTML of the verdicts on runs, whose folders lie in `reports/diagnosis/`."""
    numbers: list[list[Text]] = []
    for run in runs:
        name = Markup('<a href="#{}">{}</a>').format(anchor("run", run), run)
        numbers.append([name, *sizes(reports / "diagnosis" / run)])
    parts: list[Text] = [
        paragraph("Nominal, calibrated and explained: the error on the last strokes, which no fit has seen."),
        table(HEAD, numbers),
        *(one_run(reports, run) for run in runs),
    ]
    return folded("diagnosis", "What the simulator leaves out", "each run's verdict, errors, figures", together(parts))


def bracketed(ids: list[str]) -> str:
    """An explanation beside others: in brackets where it has several mechanisms."""
    return f"({' + '.join(ids)})" if len(ids) > 1 else " + ".join(ids)


def verdicts(folders: list[Path]) -> str:
    """One line for each diagnosis that has a verdict, for the end of the main job."""
    lines = []
    for folder in folders:
        if (folder / "verdict.txt").is_file():
            sets = [bracketed(ids) for ids in explanations(folder)]
            more = [f"{len(sets) - 1 - TIES} more"] if len(sets) > 1 + TIES else []
            named = " or ".join([*sets[: 1 + TIES], *more])
            headline = " ".join(words_of(folder).partition("\n\n")[0].split())
            lines.append(f"{headline} {named}".rstrip())
    return "\n".join(lines)
