"""Length that does not come back: ledgers and sheets of a string's permanent elongation, and its stiffening."""

import numpy as np

from pipeline.ground.kinematics import Array
from pipeline.rig.authors.workshop.bench import Bench, Law, Part, added
from pipeline.rig.authors.workshop.curves import drawn_curve, histogram_draws, unit

LONGEST_MM = 6.0


def worked_sheet(bench: Bench, rng: np.random.Generator) -> Part:
    """Elongation read off a sheet over worked strokes, which flattens out."""
    bend = rng.uniform(1.5, 5.0)
    sheet = drawn_curve(rng, bend, 8)
    shape = -unit(sheet(bench.work / bench.work[-1]))
    return added("length", "elongation_mm", LONGEST_MM, shape, bend=bend)


def decades_of_work(bench: Bench, rng: np.random.Generator) -> Part:
    """So much elongation for each tenfold of worked strokes."""
    first = rng.uniform(0.1, 1.0)
    shape = -np.log10(1.0 + bench.work / first)
    return added("length", "elongation_per_decade_mm", LONGEST_MM, shape, first_strokes=first)


def ledger_of_bites(bench: Bench, rng: np.random.Generator) -> Part:
    """Each winding takes a bite near its top; later bites are smaller, with a scatter off a histogram."""
    count, ratio = int(bench.stroke.max()), rng.uniform(0.55, 0.93)
    bites = ratio ** np.arange(count) * histogram_draws(rng, np.array([0.6, 0.9, 1.1, 1.5]), np.array([2, 6, 2]), count)
    begin = rng.uniform(0.3, 0.7)
    elongation = np.zeros_like(bench.turns)
    for number, bite in enumerate(bites, 1):
        in_stroke = bench.stroke == number
        highest = float(bench.height[in_stroke].max()) if in_stroke.any() else 0.0
        pulled = np.where(
            in_stroke, np.clip((bench.height / max(highest, 1e-9) - begin) / (1.0 - begin), 0.0, 1.0), 0.0
        )
        pull = float(bench.load_ratio[in_stroke].mean()) if in_stroke.any() else 1.0
        elongation += bite * pull * np.maximum.accumulate(pulled)
    return added("length", "elongation_mm", LONGEST_MM, -unit(elongation), ratio=ratio, begins_at=begin)


def proof_loading(bench: Bench, rng: np.random.Generator) -> Part:
    """Only a tension beyond the greatest so far lengthens; how much stands on the proof-loading sheet."""
    helix, bend = rng.uniform(0.5, 1.5), rng.uniform(-1.0, 1.0)
    greatest = np.maximum.accumulate(bench.load_ratio * (1.0 + helix * np.square(np.tan(bench.helix_rad))))
    sheet = drawn_curve(rng, bend)
    shape = -unit(sheet(greatest / greatest[-1]))
    return added("length", "elongation_mm", LONGEST_MM, shape, helix_share=helix, bend=bend)


def stiffness_record(bench: Bench, rng: np.random.Generator) -> Part:
    """The stretch under load shrinks as the tally of worked strokes says."""
    bend = rng.uniform(2.0, 5.0)
    record = drawn_curve(rng, bend, 8)
    shape = bench.load_ratio * record(bench.work / bench.work[-1])
    return added("length", "stretch_taken_back_mm", LONGEST_MM, shape, bend=bend)


def settling_clock(bench: Bench, rng: np.random.Generator) -> Part:
    """The stretch under load shrinks with loaded time, by half of all at a half time."""
    half_s = rng.uniform(0.15, 0.6) * bench.time_s[-1]
    loaded_s = np.cumsum(bench.load_ratio) * bench.tick_s
    shape = bench.load_ratio * loaded_s / (loaded_s + half_s)
    return added("length", "stretch_taken_back_mm", LONGEST_MM, shape, half_time_s=half_s)


def _stretch(bench: Bench, of_load: Array, **parameters: float) -> Part:
    return added("length", "stretch_mm", LONGEST_MM, -(of_load - of_load[0]), **parameters)


def spring_tester_line(bench: Bench, rng: np.random.Generator) -> Part:
    """Stretch in proportion to the load, with the tester's linearity of one percent."""
    bow = rng.uniform(-0.01, 0.01)
    return _stretch(bench, bench.load_ratio + bow * np.square(bench.load_ratio), bow=bow)


def spring_tester_curve(bench: Bench, rng: np.random.Generator) -> Part:
    """Stretch against load through points drawn on the tester, steep at first."""
    bend = rng.uniform(1.0, 3.0)
    curve = drawn_curve(rng, bend)
    return _stretch(bench, curve(bench.load_n / (1.1 * bench.load_n.max())), bend=bend)


def crimp_card(bench: Bench, rng: np.random.Generator) -> Part:
    """Crimp that straightens: half of it at a half load."""
    half = rng.uniform(0.3, 1.2) * bench.load_n.mean()
    return _stretch(bench, bench.load_n / (bench.load_n + half), half_load_n=half)


PLASTIC: tuple[Law, ...] = (worked_sheet, decades_of_work, ledger_of_bites, proof_loading)
STIFFENING: tuple[Law, ...] = (stiffness_record, settling_clock)
ELASTIC: tuple[Law, ...] = (spring_tester_line, spring_tester_curve, crimp_card)
