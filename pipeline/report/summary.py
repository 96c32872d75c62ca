"""What the main job says at its end: the two tables of each material, and where the figures are."""

from pathlib import Path


def summary(reports: Path, materials: list[str]) -> str:
    """Both tables of every material as text, then the places of the figures."""
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
    return "\n".join(text) + "\n"
