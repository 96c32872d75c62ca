"""The results of a public rig's recordings → its page: where they differ, why, how much better, with figures."""

import argparse
import html
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import pandas as pd

from ...ground.errors import BadInput, program
from ...ground.stored.figure_file import write_figure
from ...ground.stored.files import whole, write_text
from ...ground.units import unit_of
from ...real.rigs import Rig, read_rigs
from ...real.runs_to_make import ALL_OTHERS
from ..web.page import STYLE, link
from .figures import figure
from .results import CARRIED, TITLES, Result, apart, expected_words, read_results
from .verdict_doubts import found_answer

WIDE = """
body { max-width: 76rem } table { font-size: 13px } .scroll { overflow-x: auto } td.left, th.left { text-align: left }
.best { font-weight: 600 } tr.middle td { border-top: 2px solid #999; font-weight: 600 }
td:nth-child(2) { text-align: right } td.text, th { text-align: left !important }
"""


def table(head: list[str], rows: list[list[str]], texts: int = 1, over: str = "") -> str:
    """An HTML table of cells that are HTML already, `over` above its head; the first `texts` columns are text."""
    names = "".join(f"<th>{name}</th>" for name in head)
    lines = [
        "<tr>"
        + "".join(f"<td{' class=text' if at < texts else ''}>{cell}</td>" for at, cell in enumerate(row))
        + "</tr>"
        for row in rows
    ]
    return f"<div class=scroll><table>\n{over}<tr>{names}</tr>\n" + "\n".join(lines) + "\n</table></div>"


def sizes(values: dict[str, float], methods: list[str]) -> list[str]:
    """Cells of the methods' errors, the smallest in bold."""
    shown = [values[method] for method in methods if method in values]
    return [
        "" if method not in values
        else f"<span class=best>{values[method]:.3g}</span>" if values[method] == min(shown)
        else f"{values[method]:.3g}"
        for method in methods
    ]  # fmt: skip


def where(results: list[Result]) -> str:
    """The place of the mismatch of each recording, and its explanation."""
    head = ["Recording", "Verdict", "Left out", "Ties", "Mismatch", "Noise", "Where", "Strokes", "Phase", "It follows"]
    rows = []
    for result in results:
        name = f'<a href="#{html.escape(anchor(result))}">{html.escape(result.name)}</a>'
        if result.content is None:
            rows.append([name, "not decided", *[""] * 8])
            continue
        mismatch: Mapping[str, Any] = result.content["mismatch"] or {}
        box = mismatch.get("location") or {}
        ends = next((key for key in box if key not in ("strokes", "phase", "share")), "")
        place = f"{box[ends][0]:.3g} to {box[ends][1]:.3g} {unit_of(ends)}" if ends else ""
        cells = [
            result.content["verdict"], result.named, str(len(result.content["alternatives"]) or ""),
            f"{result.mismatch:.3g} {result.spoken}" if result.mismatch is not None else "",
            f"{result.noise_floor:.3g} {result.spoken}",
            place, "–".join(map(str, box.get("strokes", []))), str(box.get("phase", "")),
            str(mismatch.get("driver") or ""),
        ]  # fmt: skip
        rows.append([name, *(html.escape(cell) for cell in cells)])
    return table(head, rows, texts=3)


def better(results: list[Result], unit: str) -> str:
    """How much better each recording is predicted, beside the black boxes, on strokes that no fit has seen."""
    rows = [[html.escape(result.name), *sizes(result.heldout, list(TITLES))] for result in results if result.heldout]
    middle = pd.DataFrame([result.heldout for result in results if not result.together]).median().to_dict()
    rows.append(["median", *sizes(middle, list(TITLES))])
    note = ""
    if any(result.together for result in results):
        note = (
            "<p>Held out of recordings together are the last of them, whole ones too; these get their zero on their"
            " first second. The median is over single recordings.</p>"
        )
    return table([f"rms error ({html.escape(unit)})", *TITLES.values()], rows) + note


def relative(results: list[Result]) -> str:
    """The residual over the reading itself, where a diagnosis gives it."""
    rows, filters = [], set()
    for result in results:
        residuals: Mapping[str, Any] | None = ((result.content or {}).get("fit") or {}).get("relative_residual")
        if residuals:
            filters.add(residuals["filter"])
            rows.append([html.escape(result.name), *(f"{100 * residuals[name]:.1f} %" for name in list(TITLES)[:3])])
    if not rows:
        return ""
    filter_text = html.escape("; ".join(sorted(filters)))
    note = f"<p>Relative residual: rms of what is left over rms of the reading. Filter: {filter_text}.</p>"
    return note + table(["Recording", *list(TITLES.values())[:3]], rows)


def answers(rig: Rig, results: list[Result]) -> str:
    """Parameters that the literature knows, beside ours."""
    rows = []
    for result in results:
        for answer in rig.answers:
            interval = found_answer(result.content, answer) if result.content else None
            if interval:
                value, low, high = interval
                cells = [result.name, answer.what, f"{answer.value:g} {answer.unit}", f"{value:.4g} {answer.unit}"]
                cells += [f"{low:.4g} to {high:.4g}", f"{100 * (value / answer.value - 1):+.1f} %"]
                rows.append([html.escape(cell) for cell in cells] + ["yes" if low <= answer.value <= high else "no"])
    head = ["Recording", "Parameter", "Published", "Found", "90 % interval", "Apart", "Inside"]
    return "<h3>Published parameters</h3>" + table(head, rows, texts=2) if rows else ""


def transferred(carried: pd.DataFrame, unit: str) -> str:
    """Errors on a recording after learning from others, zero set on the first second, motors homed."""
    if carried.empty:
        return "<p>There is one recording of each thing: nothing to carry over.</p>"
    rows, best = [], []
    for carried_part, source in zip(apart(carried), ("one other", ALL_OTHERS), strict=True):
        for group, errors in carried_part.groupby("group"):
            middle = errors.groupby("method")[["rms", "centred_rms"]].median()
            count = str(len(errors) // errors["method"].nunique())
            rows.append([html.escape(str(group)), source, count, *sizes(middle["rms"].to_dict(), CARRIED)])
            best.append([html.escape(str(group)), source, count, *sizes(middle["centred_rms"].to_dict(), CARRIED)])
    head = ["Group", "Learnt from", "Cases", *(TITLES[name] for name in CARRIED)]
    zeros = "zero set on the first second, simulators homed"
    text = f"<p>Median rms error ({html.escape(unit)}), {zeros}:</p>{table(head, rows, texts=2)}"
    return text + f"<p>The same with the best zero:</p>{table(head, best, texts=2)}"


def anchor(result: Result) -> str:
    """The place of a verdict on the page."""
    return f"together-{result.group}" if result.together else result.name


def page(name: str, rig: Rig, results: list[Result], pairs: pd.DataFrame, unit: str) -> str:
    """The page's HTML; links are relative to the folder that it lies in."""
    source = f'<a href="{html.escape(rig.repository)}">{html.escape(rig.repository)}</a>, {html.escape(rig.where)}'
    published = [[html.escape(cell) for cell in (number.what, number.value, number.source)] for number in rig.published]
    expected = {f"{claim.said}{f' ({expected_words(claim)})' if claim.names else ''}" for claim in rig.expected}
    text = [
        f"<!doctype html>\n<html lang=en><meta charset=utf-8><title>{html.escape(name)}</title>",
        f"<style>{STYLE}{WIDE}</style>",
        f"<p><a href=index.html>All public rigs</a></p><h1>{html.escape(rig.title)}</h1>",
        f"<p>Source: {source} ({html.escape(rig.licence)}). Base model: {html.escape(rig.base)}.</p>",
        f"<p>The literature: {html.escape('; '.join(sorted(expected)))}.</p>",
        "<h2>Where simulation and recording differ, and what explains it</h2>", where(results),
        "<h2>How much better: strokes that no fit has seen</h2>", better(results, unit), relative(results),
        f'<img src="{link(f"{name}.png")}" alt="Errors of every method">',
        "<h3>Published figures</h3>", table(["Of what", "Value", "Source"], published, texts=3),
        f"<p>{html.escape(rig.note)}</p>", answers(rig, results),
        "<h2>Learnt on some recordings, asked about another</h2>", transferred(pairs, unit),
        "<h2>Each verdict</h2>",
    ]  # fmt: skip
    for result in results:
        heading = f'<h3 id="{html.escape(anchor(result))}">{html.escape(result.name)}</h3>'
        text.append(f"{heading}<pre>{html.escape(result.words)}</pre>")
        if (result.folder / "diagnosis.png").is_file():
            parts = (name, "together", result.group) if result.together else (name, result.folder.name)
            source = link(*parts, "diagnosis.png")
            text.append(f'<a href="{source}"><img src="{source}" alt="Diagnosis"></a>')
    return "\n".join(text) + "\n"


@program
def main() -> None:
    """Write a rig's page, its figure and its rows of the table over all rigs."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.report.real.page", description=__doc__)
    parser.add_argument("rig")
    for name in ("verdicts", "together", "black-boxes", "transfer"):
        parser.add_argument(f"--{name}", type=Path, nargs="*", default=[])
    for name in ("out", "figure", "table"):
        parser.add_argument(f"--{name}", type=Path, required=True)
    arguments = parser.parse_args()
    rigs = read_rigs()
    if arguments.rig not in rigs:
        raise BadInput("arguments", "rig", f"{arguments.rig!r} is not a known rig", f"use {', '.join(rigs)}")
    rig = rigs[arguments.rig]
    no_pairs = pd.DataFrame(columns=["group", "learnt_from", "asked_about", "method", "rms", "centred_rms", "unit"])
    pairs = pd.concat([pd.read_csv(path) for path in arguments.transfer]) if arguments.transfer else no_pairs
    results = read_results(arguments.verdicts, arguments.together, arguments.black_boxes, pairs)
    unit = next((result.spoken for result in results if result.unit), "")
    write_text(arguments.out, page(arguments.rig, rig, results, pairs, unit))
    drawn = figure(results, pairs, unit)
    write_figure(drawn, arguments.figure, dpi=160)
    plt.close(drawn)
    rows = pd.DataFrame([{"rig": arguments.rig, **result.row(rig)} for result in results])
    with whole(arguments.table) as temporary:
        rows.to_csv(temporary, index=False, float_format="%.5g")


if __name__ == "__main__":
    main()
