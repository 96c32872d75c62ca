"""The model to take of a material where nobody says which: the one that the commands export and ask, and by which rule.

Errors here are forward RMSEs on all points of a split, `within` or `later`, by model and split, in mm. Models that
answer along a whole motion alone cannot be exported: they have none here.
"""

from collections.abc import Collection, Iterable, Mapping

import pandas as pd

from ...ground.model_errors import LESS, Errors, chosen_of

WHERE = {"later": "on later strokes", "within": "on held-out points inside strokes"}  # errors of a split
WORTH_SHARE = 0.2  # of the error of the model to take: so much less another one must err to be recommended beside it
WORTH_NOISE = 0.25  # of the noise of the points: a difference below is none that a rig shows
RULE = "The model to take is found so:"
RULES = (
    "Only models that can be exported are compared.",
    "Of these the one of the least forward error on later strokes is taken. Where no later stroke is left out, or few "
    "learnt strokes have their load or twist, it is the one of the least forward error on held-out points.",
    f"If the error of the spline is at most {LESS:g} times that least error, the spline is taken instead: it rises "
    "with the twist and is its own inverse.",
)


def errors_of(
    metrics: pd.DataFrame, is_apart: bool = False, whole_motion: Collection[str] = ()
) -> dict[tuple[str, str], float]:
    """Errors by which models are compared, by model and split, medians over the seeds, in mm.

    `is_apart`: the later strokes were recorded under other conditions than most learnt ones, and do not count.
    `whole_motion`: the models that answer along a whole motion alone, which are not compared.
    """
    whole = (metrics[["stroke", "phase", "angle_band"]] == "all").all(axis=1)
    mine = metrics[whole & (metrics["metric"] == "rmse") & (metrics["map"] == "forward")]
    mine = mine[~mine["model"].isin(whole_motion)]
    mine = mine[mine["split"] != "later"] if is_apart else mine
    middle = mine.groupby(["model", "split"])["value"].median()
    return {(str(model), str(split)): float(value) for (model, split), value in middle.items()}


def is_worth(less_mm: float, own_mm: float, floor_mm: float) -> bool:
    """Whether an error of `less_mm` in place of `own_mm` is worth a second model, where the noise is `floor_mm`."""
    return own_mm - less_mm >= max(WORTH_SHARE * own_mm, WORTH_NOISE * floor_mm)


def is_told_apart(less: float, own: float) -> bool:
    """Whether two errors of one unit are different numbers as they are printed, with three decimals."""
    return f"{less:.3f}" != f"{own:.3f}"


def weighed(titles: Mapping[str, str], errors_mm: Errors, floor_mm: float) -> str:
    """The excluded model that errs less than the chosen one on held-out points; empty if there is none.

    `floor_mm`: the noise of these points. It is recommended only where the difference is worth it.
    """
    chosen, split = chosen_of(titles, errors_mm), "within"
    others = [model for model in titles if model != chosen and (model, split) in errors_mm]
    best = min(others, key=lambda model: errors_mm[model, split], default="")
    if not best or (chosen, split) not in errors_mm or errors_mm[best, split] * LESS > errors_mm[chosen, split]:
        return ""
    if not is_told_apart(errors_mm[best, split], errors_mm[chosen, split]):
        return ""
    errs = f"{errors_mm[best, split]:.3f} mm against {errors_mm[chosen, split]:.3f} mm"
    sentence = f"On strokes like the recorded ones the {titles[best]} errs less forward: {errs}."
    if {(best, "later"), (chosen, "later")} <= set(errors_mm):
        later = f"{errors_mm[best, 'later']:.3f} mm against {errors_mm[chosen, 'later']:.3f} mm"
        sentence += f" On later strokes it errs by {later}."
    if not is_worth(errors_mm[best, split], errors_mm[chosen, split], floor_mm):
        return sentence
    return f"{sentence} Take the {titles[best]} if only strokes like the recorded ones will come."


def ranked(chosen: str, models: Iterable[str], errors_mm: Errors) -> str:
    """The forward error by which a model was chosen, and how it ranks; empty where no errors are known."""
    split = next((split for split in WHERE if (chosen, split) in errors_mm), "")
    if not split:
        return ""
    least_mm = min(errors_mm[model, split] for model in models if (model, split) in errors_mm)
    own_mm = errors_mm[chosen, split]
    if own_mm <= least_mm:
        return f"Its forward error {WHERE[split]} is the least of those that can be exported: {own_mm:.3f} mm."
    rank = f"at most {LESS:g} times the least of those that can be exported"
    return f"Its forward error {WHERE[split]}, {own_mm:.3f} mm, is {rank}."


def why(chosen: str, models: Iterable[str], errors_mm: Errors, floor_mm: float) -> str:
    """Why a model is the one to take, in a line for a terminal; empty where no errors are known.

    Where another model errs less on the points that the tables show, the line says so; `floor_mm` is their noise.
    """
    named = sorted(set(models))
    rank = ranked(chosen, named, errors_mm)
    if not rank:
        return ""
    line = f"model to take: {chosen}. {rank}"
    inside = [model for model in named if (model, "within") in errors_mm]
    best = min(inside, key=lambda model: errors_mm[model, "within"], default=chosen)
    if (chosen, "later") not in errors_mm or best == chosen or (chosen, "within") not in errors_mm:
        return line
    if not is_told_apart(errors_mm[best, "within"], errors_mm[chosen, "within"]):
        return line
    less = f"{errors_mm[best, 'within']:.3f} mm against {errors_mm[chosen, 'within']:.3f} mm"
    take = f"If your strokes stay as recorded, take {best}."
    clearly = is_worth(errors_mm[best, "within"], errors_mm[chosen, "within"], floor_mm)
    return f"{line} Inside strokes, which the tables show, {best} errs less: {less}.{f' {take}' if clearly else ''}"


def uses(material: str, model: str) -> tuple[str, str]:
    """The commands that export a model, of the split `within`, and that fit it anew and ask it, with intervals."""
    ask = f"python -m pipeline.predict processed/{material}/dataset.parquet questions.csv --model {model}"
    export = f"python -m pipeline.export processed/{material}/{model}/within-0.model --format c"
    return export, f"{ask} --out reports/mine/answers.csv"
