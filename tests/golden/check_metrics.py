"""Compare the main job's tables with the published ones, and its diagnosis with the rig that it is of.

`python tests/golden/check_metrics.py reports` exits with 1 when a number leaves its band, and when the tables are of
another configuration than the default one, which alone makes the published ones. Bands are relative: the
recording is the same to the bit, so the models without randomness get 0.5 %; the trained ones get what processors of
other makes and other builds of torch may cost.
"""

import argparse
import csv
import json
import sys
from pathlib import Path

PUBLISHED = Path(__file__).parent / "published"
EXACT, TRAINED, TRAINED_MAXIMUM = 0.005, 0.15, 0.35
EFFECTS = {"radius_compaction", "plastic_elongation", "friction_hysteresis", "creep"}  # of rig/setups/paper.yaml
FEW = 3  # explanations that may tie
LEAVES = 1.3  # noise floors of unseen strokes: the first of what ties foresees them
MAKES = "`snakemake --cores 2`"  # without --configfile and --config
PAPER_RMS = 0.05  # of the traditional model's 18 numbers from the paper's
sys.path.insert(0, str(Path(__file__).parents[2]))

from pipeline.report.agreement import WORST as PAPER_WORST  # noqa: E402
from pipeline.report.layout import paper  # noqa: E402
from pipeline.report.layout.sidecar import STATUS  # noqa: E402


def read(path: Path) -> dict[tuple[str, str], list[float]]:
    """Numbers of a table by model and stroke; a row without numbers, of a stroke that was not recorded, is none."""
    with open(path, encoding="utf-8", newline="") as file:
        rows = [row for row in list(csv.reader(file))[1:] if all(row)]
    return {(row[0], row[1]): [float(cell) for cell in row[2:]] for row in rows}


def why_never(reports: Path) -> str:
    """Why these tables cannot be the published ones, whatever their numbers, and the mend; empty where they can be."""
    for number in (1, 2):
        path = reports / "synthetic" / f"table_{number}.csv"
        if not path.is_file():
            return f"{path} is not there: {MAKES} makes it"
        beside = path.with_name(f"{path.name}-metadata.json")
        about = json.loads(beside.read_text(encoding="utf-8")) if beside.is_file() else {}
        status = about.get("schema:creativeWorkStatus", STATUS["default"])
        if status != STATUS["default"]:
            of = about.get("schema:isBasedOn")
            name = f"{of} (checksum of its settings {about['schema:version']})"
            whose = f"another configuration, {name}" if of else "an unknown configuration"
            return (
                f"{path.parent}: these tables are of {whose} ({status}): so they cannot be the published ones, which "
                f"are of the default configuration; {MAKES} makes those"
            )
    return ""


def complaints(reports: Path) -> list[str]:
    """What is wrong with the tables of material `synthetic`, a sentence each."""
    faults, relative = [], []
    for number in (1, 2):
        name = f"table_{number}.csv"
        published, now = read(PUBLISHED / name), read(reports / "synthetic" / name)
        if published.keys() != now.keys():
            faults.append(f"{name}: its rows are not the published ones")
            continue
        for (model, stroke), expected in published.items():
            for column, (then, value) in enumerate(zip(expected, now[model, stroke], strict=True)):
                trained = TRAINED_MAXIMUM if column == 1 else TRAINED
                band = EXACT if model in ("Traditional model", "Calibrated model") else trained
                if abs(value - then) > band * then + 0.0006:
                    faults.append(
                        f"{name}: {model}, {stroke}, {paper.METRICS[column]}: {value} was {then} ± {band:.1%}"
                    )
        for stroke in paper.STROKES:
            for theirs, ours in zip(paper.TABLES[number]["inn"][stroke], now["INN model", f"n={stroke}"], strict=True):
                if ours >= theirs:
                    faults.append(f"{name}: INN model, n={stroke}: {ours} is not below the paper's {theirs}")
            traditional = zip(
                paper.TABLES[number]["traditional"][stroke], now["Traditional model", f"n={stroke}"], strict=True
            )
            relative += [ours / theirs - 1.0 for theirs, ours in traditional]
    rms = (sum(value**2 for value in relative) / max(len(relative), 1)) ** 0.5
    if rms > PAPER_RMS or max(map(abs, relative), default=1.0) > PAPER_WORST:
        worst = max(map(abs, relative), default=1.0)
        faults.append(f"Traditional model: {rms:.1%} rms and {worst:.1%} worst from the paper's 18 numbers")
    return faults


def misdiagnosis(reports: Path) -> list[str]:
    """What is wrong with the diagnosis of the synthetic rig, a sentence each.

    It must name some of the rig's own effects and nothing else (equal strokes do not part creep from plastic growth),
    and leave little more than noise on the strokes that no fit has seen. An ambiguous one says that one of its few
    explanations is right: one of them must hold nothing but the rig's own effects (one load does not part compaction
    from shaft wind-up).
    """
    path = reports / "diagnosis" / "synthetic-01" / "diagnosis.json"
    if not path.is_file():
        return [f"diagnosis: {path} is not there: {MAKES} makes it"]
    content = json.loads(path.read_text(encoding="utf-8"))
    named, fit = {entry["id"] for entry in content["mechanisms"]}, content["fit"]
    explanations = [named, *map(set, content["alternatives"])] if content["verdict"] == "ambiguous" else [named]
    faults = []
    if all(explanation - EFFECTS for explanation in explanations):
        faults += [f"diagnosis: the rig has no {name}" for name in sorted(named - EFFECTS)]
    if len(explanations) > FEW:
        faults.append(f"diagnosis: {len(explanations)} explanations are held, more than {FEW}")
    if not named:
        faults.append(f"diagnosis: {content['verdict']}, although the rig has effects")
    if fit["heldout"]["explained_mm"] > LEAVES * fit["noise_floor_mm"]:
        leftover_mm, floor = fit["heldout"]["explained_mm"], fit["noise_floor_mm"]
        faults.append(f"diagnosis: it leaves {leftover_mm} mm of unseen strokes, whose noise is {floor} mm")
    return faults


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("reports", type=Path, help="the folder that the main job made")
    reports_folder = parser.parse_args().reports
    never = why_never(reports_folder)
    wrong = [never] if never else complaints(reports_folder) + misdiagnosis(reports_folder)
    print(
        "\n".join(wrong)
        or "the tables are the published ones, within their bands, and the diagnosis names only what the rig has"
    )
    sys.exit(bool(wrong))
