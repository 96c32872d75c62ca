"""The files of a diagnosis → a cell, a line, a run's part of the pages: its verdict, its figure, its files."""

import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from markupsafe import Markup

from ...ground.units import unit_of
from ...ground.words.verdict_text import headline, to_do
from ..layout.verdict_content import Content
from ..layout.verdict_file import NAME, read_verdict
from ..web.glossary import word
from ..web.page import Text, link, paragraph, picture, together

VERDICTS = ("consistent", "parameters", "explained", "ambiguous", "unknown")
UNDECIDED = "not decided"
NAMING = ("explained", "ambiguous")  # verdicts that name physics
WORSE = ", but worse on unseen strokes: do not adopt"
NOT_SETTLED = ", but not settled"  # as `verdict.txt` calls what was named otherwise without the last strokes
NO_NUMBER = "–"
DIAGNOSED = "as diagnosed"  # the simulator with what a verdict names, as verdicts call it
SIZES = ("mismatch", "nominal", "calibrated", DIAGNOSED, "noise")
FILES = {
    "verdict.txt": "the verdict",
    "details.txt": "its reasons, and the next run step by step",
    NAME: "all numbers",
    "diagnosis.pdf": "the figure to print",
}


def content_of(folder: Path) -> Content | None:
    """The content of a diagnosis, or None where the recording was refused; raises BadInput where it is damaged."""
    path = folder / NAME
    return read_verdict(path) if os.path.lexists(path) else None


def verdict_of(content: Content | None) -> str:
    """The verdict in a word."""
    return UNDECIDED if content is None else str(content["verdict"])


def explanations(content: Content | None) -> list[list[str]]:
    """The ids of the best explanation, then those of each tied one."""
    if content is None or not content["mechanisms"]:
        return []
    return [[entry["id"] for entry in content["mechanisms"]], *content["alternatives"]]


def named_of(content: Content | None) -> Markup:
    """The ids that a verdict names, each with its meaning, and the number of tied explanations."""
    sets = explanations(content)
    best = Markup(" + ").join(word(id_) for id_ in sets[0]) if sets else Markup("")
    others = len(sets) - 1
    return best + (f", or {others} other explanation{'s' * (others > 1)}" if others > 0 else "")


def badge_of(content: Content | None) -> str:
    """The verdict on its badge, with a warning if its names may not last, or make the simulator worse."""
    verdict = verdict_of(content)
    if (
        content is not None
        and verdict == "explained"
        and _of_others(content)
        and content["evidence"]["chosen_without_them"]
    ):
        return f"{verdict}{NOT_SETTLED}"
    worse = content is not None and verdict in NAMING and "explained" in content["fit"].get("worse_than_nominal", [])
    return f"{verdict}{WORSE}" if worse else verdict


def tag(badge: str) -> Markup:
    """A verdict in its colour, with the warning that its badge has."""
    verdict = badge.removesuffix(WORSE).removesuffix(NOT_SETTLED)
    of = verdict if verdict in VERDICTS else "none"
    of = "doubted" if badge != verdict else of  # no colour of a success, and none of an error
    return Markup('<span class="verdict {}">{}{}</span>').format(of, word(verdict), badge[len(verdict) :])


def tag_of(folder: Path) -> Markup:
    """The verdict of a diagnosis's folder in its colour."""
    return tag(badge_of(content_of(folder)))


def sizes(content: Content | None) -> list[str]:
    """`SIZES`: the mismatch, the error on strokes that no fit has seen, and the noise floor, each with its unit."""
    if content is None:
        return [""] * len(SIZES)
    unit = _unit(content)
    fit: Mapping[str, Any] = content["fit"]
    mismatch: Mapping[str, Any] = content["mismatch"] or {}
    heldout = fit["heldout"] or {}
    numbers = [mismatch.get(f"rms_{unit}")]
    numbers += [heldout.get(f"{name}_{unit}") for name in ("nominal", "calibrated", "explained")]
    numbers.append(fit[f"noise_floor_{unit}"])
    cells = ["" if size is None else _said(size, unit) for size in numbers]
    if verdict_of(content) == "unknown" or _of_others(content):  # nothing is named that could have an error there
        cells[SIZES.index(DIAGNOSED)] = NO_NUMBER
    return cells


def why_no_number(content: Content | None) -> str:
    """Why `sizes` lacks the error of the named effects, and which effects have one; else empty."""
    if content is None:
        return ""
    if verdict_of(content) == "unknown":
        return "nothing is named"
    if not _of_others(content):
        return ""
    unit = _unit(content)
    error, chosen = (
        (content["fit"]["heldout"] or {}).get(f"explained_{unit}"),
        content["evidence"]["chosen_without_them"],
    )
    closest = " + ".join(content["evidence"].get("closest_without_them", []))
    instead = " + ".join(chosen or []) or closest or "no effect"
    does = "comes closest" if closest and not chosen else "is named"
    measured = "" if error is None else f"{_said(error, unit)} with {instead}, which "
    return f"{measured or f'{instead} '}{does} without these strokes"


def _unit(content: Content) -> str:
    """The ending of the keys of sizes."""
    return next(key for key in content["fit"] if key.startswith("noise_floor_")).removeprefix("noise_floor_")


def _said(size: float, unit: str) -> str:
    """A size with its unit, two digits."""
    return f"{float(f'{size:.2g}'):g} {unit_of(f'_{unit}')}"


def _of_others(content: Content) -> bool:
    """Whether the error on unseen strokes belongs to other effects, named without them, as in `verdict.txt`."""
    evidence = content.get("evidence") or {}
    chosen = evidence.get("chosen_without_them")
    named = {entry["id"] for entry in content["mechanisms"]}
    return bool(named) and chosen is not None and set(chosen or evidence.get("closest_without_them", [])) != named


def words_of(folder: Path) -> str:
    """The verdict as a person reads it."""
    path = folder / "verdict.txt"
    if not path.is_file():
        return f"{folder.name}: no verdict was written"
    return path.read_text(encoding="utf-8", errors="replace")


def to_do_of(folder: Path) -> str:
    """The next steps of a verdict, on one line; empty where it has none."""
    return " ".join(to_do(words_of(folder)).split())


def why_nothing(folder: Path) -> str:
    """The verdict's reason against adopting anything, in its own words; else empty."""
    reason = re.search(r"Adopt nothing: (.*?)(?=\.(\s|$))", to_do_of(folder))
    return reason.group(1) if reason else ""


def next_recording(folder: Path) -> str:
    """The sentence of a verdict that asks for another recording; empty where none does."""
    asked_for = re.search(r"Record the rig .*?[^.](?=\.(\s|$))", to_do_of(folder))
    return asked_for.group() if asked_for else ""


def part(reports: Path, run: str, up: str = "") -> Markup:
    """One run's first words, its figure, the other words and its files; `up` leads from the page to `reports/`."""
    folder = reports / "diagnosis" / run
    first, _, rest = words_of(folder).partition("\n\n")
    parts: list[Text] = [Markup("<pre>{}</pre>").format(first)]
    if (folder / "diagnosis.png").is_file():
        parts.append(picture(up + link("diagnosis", run, "diagnosis.png"), f"Diagnosis of {run}"))
    parts.append(Markup("<pre>{}</pre>").format(rest) if rest.strip() else "")
    rows_there = [
        Markup('<a href="{}">{}</a> ({})').format(up + link("diagnosis", run, name), name, words)
        for name, words in FILES.items()
        if (folder / name).is_file()
    ]
    parts.append(paragraph(Markup("Files: {}.").format(Markup(", ").join(rows_there))) if rows_there else "")
    return together(filter(None, parts))


def verdicts(folders: list[Path]) -> str:
    """One line for each diagnosis that has a verdict, for the end of the main job."""
    lines = []
    for folder in folders:
        if (folder / "verdict.txt").is_file():
            lines.append(headline(words_of(folder)))
    return "\n".join(lines)
