"""What the main job says at its end: the two tables of each material, where the figures are, and the verdicts."""

from pathlib import Path

from pipeline.report.diagnoses import verdicts


def summary(reports: Path, materials: list[str], runs: list[str]) -> str:
    """Both tables of every material as text, the places of the figures, and a line on each run's diagnosis."""
    text = []
    for material in materials:
        folder = reports / material
        if not all((folder / f"table_{number}.md").is_file() for number in (1, 2)):
            text.append(f"\n== {material}: no tables")
            continue
        text.append(f"\n== {material} " + "=" * max(0, 90 - len(material)))
        text += [(folder / f"table_{number}.md").read_text(encoding="utf-8") for number in (1, 2)]
        figures = [str(folder / f"figure_{number}.png") for number in (4, 5)]
        text.append(f"figures: {', '.join(path for path in figures if Path(path).is_file()) or 'not drawn'}")
        text.append(f"beside the paper: {folder / 'comparison.md'}")
        text.append(f"beside the floor: {folder / 'models.md'}")
    words = verdicts(reports, runs)
    if words:
        text.append("\n== what the simulator leaves out " + "=" * 62)
        text.append(f"{words}\nfigures: {reports / 'diagnosis' / '<run>' / 'diagnosis.png'}")
    return "\n".join(text) + "\n"
