"""The model to take of a material where nobody says which: the one that the commands export and ask, and why it."""

from collections.abc import Iterable

USUAL = "spline"  # the one to take where it is there: the page on models says why
WHY_USUAL = "it rises with the twist, is its own inverse and foresees later strokes"
ALONE = "diagnosed"  # needs the whole motion: it is neither exported nor asked


def chosen_of(models: Iterable[str]) -> str:
    """Which of some models to take where nobody says which; empty where there is none."""
    known = sorted(set(models) - {ALONE})
    return USUAL if USUAL in known else known[0] if known else ""


def uses(material: str, model: str) -> tuple[str, str]:
    """The commands that export a model and that ask it, of the split `within`."""
    file = f"processed/{material}/{model}/within-0.model"
    ask = f"python -m pipeline.predict processed/{material}/dataset.parquet questions.csv --saved {file}"
    return f"python -m pipeline.export {file} --format c", f"{ask} --out reports/mine/answers.csv"
