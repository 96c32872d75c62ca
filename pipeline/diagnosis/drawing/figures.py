"""One page of figures: recording over simulation, mismatch maps, explanations, held-out error, residual by driver."""

import textwrap
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.patches import Patch

from ...ground.kinematics import Array
from ...ground.stored.figure_file import write_page
from ..choice.outcome import Study
from ..document.content import Simulated, Verdict
from ..document.effects_named import Dimension
from ..document.made_keys import amount
from ..prediction.simulation import at_its_best_zero
from ..words.explanations import excursions
from ..words.held_out import holdout, unseen
from ..words.held_out.holdout import heading, included, others, settled_otherwise
from ..words.held_out.unseen import noises
from ..words.language.quantity import listing
from ..words.language.vocabulary import Vocabulary
from ..words.measured.dimensions import name_of
from ..words.measured.to_measure import to_measure
from ..words.pages import advice
from ..words.pages.adopted_doubts import against_advice
from ..words.pages.headline import NOT_SETTLED, still_holds, unfit
from ..words.pages.to_do import asks_to_measure
from . import driver_panels, panels
from .mismatch_map import map_of, map_signs, mismatch_map
from .overview import has_load, overview
from .panels import AFTER

SIZE_INCHES, DOTS = (9.6, 14.0), 220
TOGETHER = "\N{NO-BREAK SPACE}+\N{NO-BREAK SPACE}"  # a line breaks between explanations, not within
STILL_MISSING = "explained, but something is still missing"  # as the first line of the page says it
MOST, WIDEST = 6, 130  # panels of drivers, and letters in a line of the mark
WITHIN = (0.012, 0.0, 0.976, 1.0)  # of the page, from the left and from below: no label touches its edge
WIDE = 100  # characters of a line of the title


def title(content: Verdict, holds: bool = False, misses: bool = False) -> str:
    """The verdict in at most two lines that fit the page: the best explanation, and how many others tie.

    `holds`: what run.yaml has adopted still explains the recording; `misses`: something is still missing.
    """
    runs = [content["run"]] if isinstance(content["run"], str) else content["run"]
    name = " + ".join(runs)
    if len(name) > WIDE // 2:
        name = runs[0] if len(runs) == 1 else f"{runs[0]} and {len(runs) - 1} more"
    unsettled = content["verdict"] == "explained" and settled_otherwise(content)
    partly = content["verdict"] == "explained" and misses
    word = NOT_SETTLED if unsettled else STILL_MISSING if partly else content["verdict"]
    head, adopted_ids = f"{name}: {word}", included(content)
    ids = [entry["id"] for entry in content["mechanisms"]]
    kept = _kept(content, adopted_ids)
    if holds and len(f"{name}: {kept}") <= WIDE:
        return f"{name}: {kept}"
    if not ids:
        subtitle = f"beside what run.yaml has adopted: {TOGETHER.join(adopted_ids)}"
        return (
            f"{head}\n{subtitle if len(subtitle) <= WIDE else f'beside {len(adopted_ids)} adopted effects'}"
            if adopted_ids
            else head
        )
    alternatives = content["alternatives"]
    best = TOGETHER.join(ids)
    if not alternatives:
        return f"{head}\n{best}"
    more, count = f"or {TOGETHER.join(alternatives[0])}", len(alternatives)
    if count > 1 or len(f"{best}, {more}") > WIDE:
        more = f"or {'one of ' if count > 1 else ''}{count} other explanation{'s' * (count > 1)}"
    return f"{head}\n{best}, {more}"


def _kept(content: Verdict, adopted_ids: list[str]) -> str:
    """The sentence that `adopted_ids` still explain the recording, and is no test where they were fitted to it."""
    adopted = f"adopted {TOGETHER.join(adopted_ids)}"
    if holdout.against_advice(content):
        return f"{adopted}, against the advice of {'its' if len(adopted_ids) == 1 else 'their'} verdict"
    if holdout.status(content) in (holdout.SEEN, holdout.PARTLY):
        return f"{adopted}, fitted to {holdout.fitted_to(content)}"
    return f"{adopted} still hold{'s' * (len(adopted_ids) == 1)}"


def warning(content: Verdict, words: Vocabulary) -> str:
    """Lines: a run.yaml not to predict with, that nothing is to be adopted, and which dimensions moved far."""
    lines = [textwrap.fill(sentence.rstrip("."), WIDEST) for sentence in against_advice(content)]
    lines += [sentence for sentence in (unfit(content, words), excursions.in_short(content, words)) if sentence]
    if against := advice.against(content, words):
        lines.append(against[0].lower() + against[1:].partition(". ")[0].rstrip("."))
    names = [name_of(name) for name in to_measure(content)]
    if names:
        them = "it" if len(names) == 1 else "them"
        step = " (verdict.txt)" * asks_to_measure(content, words)
        lines += [f"calibration moved {listing(names)} far: measure {them} again first{step}"]
    return "\n".join(lines)


def page(study: Study, content: Verdict, path: Path, mark: str = "") -> None:
    """Draw the page and write it as PNG and as PDF, whole or not at all; `path` goes without an ending."""
    write_page(drawn(study, content, mark), path)


def as_adopted(study: Study, verdict: Verdict) -> Array | None:
    """The reading of the simulator as it was adopted, with its best zero; None where nothing was adopted.

    Shape (samples,), in the reading's unit.
    """
    problem = study.problem
    came = [adoption["dimensions"] for adoption in verdict.get("adopted", []) if adoption.get("dimensions")][-1:]
    if not came or f"adopted_{problem.system.channel.rpartition('_')[2]}" not in verdict["evidence"]:
        return None
    dimensions: dict[str, Dimension] = {name: {"value": dimension["fitted"]} for name, dimension in came[0].items()}
    run = str(verdict["run"])
    content: Simulated = {"parameters": dimensions, "simulation": verdict["simulation"]}
    return at_its_best_zero(problem, content, Path("run.yaml"), run)


def drawn(study: Study, content: Verdict, mark: str = "") -> Figure:
    """The page as a figure of matplotlib, known to no window and no notebook; `mark` stands beneath its title."""
    problem, drivers, floor = study.problem, study.problem.drivers, study.floor
    ending, unit = problem.system.channel.rpartition("_")[2], drivers.units.reading
    states = {"nominal": study.nominal, "calibrated": study.base, "as diagnosed": study.state}
    simulations = {name: problem.simulate(state) for name, state in states.items()}
    if np.array_equal(simulations["as diagnosed"], simulations["calibrated"]):  # nothing is named: draw nothing twice
        del simulations["as diagnosed"]
        adopted = as_adopted(study, content)
        if adopted is not None:  # nobody simulates with adopted effects and the dimensions of run.yaml
            simulations = {"calibrated": simulations["calibrated"], "as adopted": adopted}
        elif study.closest:
            simulations[panels.CLOSEST] = problem.simulate(study.closest)
    residuals = {name: problem.measured - values for name, values in list(simulations.items())[-2:]}
    figure = Figure(figsize=SIZE_INCHES, dpi=DOTS, layout=ConstrainedLayoutEngine(rect=WITHIN))
    vocabulary = Vocabulary.of(problem.system)
    figure.suptitle(title(content, still_holds(content, vocabulary), unseen.partly(content, vocabulary)), fontsize=11)
    warned = "\n".join(filter(None, (textwrap.fill(mark, WIDEST), warning(content, vocabulary))))
    rows = np.asarray(figure.subfigures(4, 1, height_ratios=[3.6 + 0.6 * has_load(drivers), 2.7, 3.6, 2.9]))
    top, maps, middle, bottom = rows
    if warned:
        top.suptitle(warned, fontsize=8.5, color=AFTER)
    before = content.get("without_last_strokes")
    seen_s = before["seen_s"] if before else None
    starts_s = problem.record.time_s[0]
    off_s = [(each.at_s - starts_s, each.at_s + each.lasts_s - starts_s) for each in study.gone_off]
    overview(top, drivers, problem.measured, simulations, vocabulary.reading, seen_s, off_s)
    for axes, (name, residual) in zip(maps.subplots(1, 2, sharey=True), residuals.items(), strict=True):
        limit = max(float(np.nanpercentile(np.abs(map_of(drivers, residual)[0]), 98)), 2.0 * floor)
        called = f"Recording − simulation, {name} (own scale)"
        image = mismatch_map(axes, drivers, residual, called, limit, vocabulary.motion)
        maps.colorbar(image, ax=axes, label=unit, pad=0.01)
    signs = map_signs(drivers, simulations["calibrated"])
    maps.legend(handles=signs, loc="outside lower center", ncols=len(signs), fontsize=7, frameon=False)
    ranked, unseen_axes = middle.subplots(1, 2, width_ratios=[3, 2])
    compared, single = noises(content, vocabulary)
    noise_band = amount(content["evidence"], f"floor_{ending}")  # the noise of the legends
    panels.ranking(ranked, content, ending, compared)
    floor_here = amount(content["fit"], f"noise_floor_{ending}")
    skip = int("as adopted" in simulations)
    names = others(content)
    panels.held_out(
        unseen_axes, content["fit"]["heldout"], floor_here, ending, unit, single, heading(content), skip, *names
    )
    ripple = next(
        (own["pitch_turns"] for act in study.state.acts for own in act.nonlinear if "pitch_turns" in own), 0.0
    )
    followed = list(driver_panels.listeners(drivers, ripple, vocabulary.motion).items())[:MOST]
    grid = driver_panels.filled(bottom, len(followed))
    for axes, (label, (signal, counts)) in zip(grid, followed, strict=True):
        slow = label in driver_panels.SLOW
        if slow and driver_panels.by_stroke(axes, drivers, signal, residuals, noise_band, label):
            continue
        kept = {name: residual[counts] for name, residual in residuals.items()}
        period = ripple if signal is drivers.motion else 0.0
        driver_panels.by_driver(axes, signal[counts], kept, noise_band, label, period)
    handles = [*grid[0].get_lines()[:2], Patch(fc=panels.BAND, ec="0.6", lw=0.5, label=f"± {compared}")]
    bottom.legend(handles=handles, loc="outside lower center", ncols=3, fontsize=7, frameon=False)
    bottom.suptitle(f"Mean residual by driver ({unit})", fontsize=9)
    return figure
