"""The model to take of a material where nobody says which: the one that the commands export and ask, and why it."""

from collections.abc import Iterable, Mapping

USUAL = "spline"  # the one to take where it is there: the page on models says why
WHY_USUAL = "it rises with the twist, is its own inverse and foresees later strokes"
LESS = 1.1  # times as large: from there on an error is told to be larger
ALONE = "diagnosed"  # needs the whole motion: it is neither exported nor asked


def chosen_of(models: Iterable[str]) -> str:
    """Which of some models to take where nobody says which; empty where there is none."""
    known = sorted(set(models) - {ALONE})
    return USUAL if USUAL in known else known[0] if known else ""


def to_take(title: str) -> str:
    """The sentence that names the usual model as the one to take."""
    return f"{title} is the model to take, for {WHY_USUAL}"


def weighed(titles: Mapping[str, str], errors_mm: Mapping[tuple[str, str], float]) -> str:
    """Which model of those to take away errs less than the chosen one on held-out points; empty where none does.

    `errors_mm` are forward RMSEs by model and split, `within` and `later`, in mm.
    """
    chosen, split = chosen_of(titles), "within"
    others = [model for model in titles if model not in (ALONE, chosen) and (model, split) in errors_mm]
    best = min(others, key=lambda model: errors_mm[model, split], default="")
    if not best or (chosen, split) not in errors_mm or errors_mm[best, split] * LESS > errors_mm[chosen, split]:
        return ""
    errs = f"{titles[best]} errs less, {errors_mm[best, split]:.3f} mm against {errors_mm[chosen, split]:.3f} mm"
    sentence = f"On strokes like the recorded ones {errs} (forward)"
    if {(best, "later"), (chosen, "later")} <= set(errors_mm):
        later = f"{errors_mm[best, 'later']:.3f} mm against {errors_mm[chosen, 'later']:.3f} mm"
        sentence += f"; on later strokes it has {later}"
    alone = f"Where only strokes like these will come, take the {titles[best]}: its file is exported in the same way"
    return f"{sentence}. {alone}."


def uses(material: str, model: str) -> tuple[str, str]:
    """The commands that export a model and that ask it, of the split `within`."""
    file = f"processed/{material}/{model}/within-0.model"
    ask = f"python -m pipeline.predict processed/{material}/dataset.parquet questions.csv --saved {file}"
    return f"python -m pipeline.export {file} --format c", f"{ask} --out reports/mine/answers.csv"
