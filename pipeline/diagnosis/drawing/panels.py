"""The panels of a diagnosis' page: each draws one thing on the axes that it is given."""

from textwrap import fill
from typing import Any

from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

from ...ground.outside_library import is_outside
from ..document.content import HeldOut, Verdict, left_with_discrepancy
from ..document.explanations import ExplanationEntry, share_of
from ..document.made_keys import amount
from ..recording.drivers import Drivers
from ..words.explanations import explanation_table, probability, rivals
from ..words.held_out.holdout import included
from ..words.language.quantity import percent, size, times
from ..words.language.vocabulary import directions

BEFORE, AFTER, TIED, OTHER, MORE = "#2166ac", "#b2182b", "#ef8a62", "0.65", "0.85"
COLOUR = {BEFORE: "blue", AFTER: "red", TIED: "orange", OTHER: "grey", MORE: "a grey ring"}  # as the docs say them
CLOSEST = "closest, no name"  # what predicts the rig where nothing is named
SHADES = {"nominal": OTHER, "calibrated": BEFORE, "as diagnosed": AFTER, "as adopted": AFTER, CLOSEST: TIED}
BAND = "0.87"  # the noise
BINS = 24
TITLE_WIDE, LEGEND_WIDE = 34, 30  # characters
HIGHEST = 0.65  # of an axis' height: where the largest error on unseen strokes stands at most
A_LINE = 0.055  # of the same: so much lower for each further line of the legend
NAMED = "as diagnosed"
STANDINGS = {
    "named": (AFTER, "the best explanation"),
    "tied": (TIED, "likely as well"),
    "beaten": (OTHER, "less likely"),
    "not needed": (MORE, "less likely, with more effects"),
    "not enough": (TIED, "the best there is, and not enough"),
    "nothing": (BEFORE, "no mechanism, only calibration"),
}  # of an explanation: its colour, and what that means
KEPT = ("named", "tied")  # the rows that stand first
ADOPTED_ALONE, ADOPTED_ROW = "what is adopted, and calibration", "{} (adopted)"  # in place of calibration alone
STAND_IN = "x_…: fits the data, and is no physics of the library"
AS_GOOD = "at the noise only if formulas err by 10 %"  # beside what its diamond has there
MENDS = "likely as well: what red adds may only mend its formula"  # of a part of the best one, without probabilities
LEFT_OUT = "left out: fits worse, as it should if red is true"  # the rule where no probability is known
MORE_ALONE = "with a further effect that adds too little"  # where nothing is named
UNLIKELY, WORSE = "less likely", "fits worse"  # where the details have no table of them, and where nobody is likely
NOT_NAMED = "leaves least, and is not named"  # where none has to be
WITH_DISCREPANCY = "left if each effect may differ from its formula by 10 %"
NO_MORE = "One more effect: none takes enough away"  # on a run that has adopted effects
MOTION = {"turns": "twist", "deg": "angle", "rad": "angle", "m": "position", "mm": "position", "": "motion"}  # by unit


def ways(drivers: Drivers) -> tuple[str, str]:
    """The two directions of motion, as an axis calls them."""
    return ("winding", "unwinding") if drivers.units.motion == "turns" else directions(drivers.units.motion)


def briefly(explanation: ExplanationEntry) -> str:
    """The remark beside an explanation's point: its probability, and why a probable one is no name."""
    share = explanation.get("probability")
    parts = [] if share is None else [percent(share) if share else "less than 1 %"]
    return ", ".join(parts + ["its effects cancel"] * bool(explanation.get("balanced")))


def ranking(axes: Axes, content: Verdict, ending: str, noise: str = "noise") -> None:
    """The residuals of the explanations, in noise floors, coloured by standing; `noise` is the noise floor."""
    adopted = set(included(content))
    all_explanations = content["evidence"]["explanations"]
    listed = all_explanations
    if content.get("verdict") in ("explained", "ambiguous"):  # the rows that details.txt has
        in_table = explanation_table.others_shown(content)
        passed_over = ("beaten", "not needed")
        listed = [each for each in all_explanations if each["standing"] not in passed_over or each in in_table]
    others = [explanation for explanation in listed if not adopted & set(explanation["ids"])]
    unknown = content.get("verdict") == "unknown"
    shown = sorted(others, key=lambda each: (bool(each["ids"]), each["standing"] in KEPT, share_of(each)))  # from below
    floor = amount(content["evidence"], f"floor_{ending}")
    left_floors = [max(rivals.left_of(explanation, content, ending) / floor, 1e-3) for explanation in shown]
    standing_of = [_standing(each, shown[-1], unknown) for each in shown]
    colours = [STANDINGS[standing][0] for standing in standing_of]
    faces = ["white" if colour == MORE else colour for colour in colours]
    edges = [OTHER if colour == MORE else colour for colour in colours]
    axes.hlines(range(len(shown)), 1.0, left_floors, colors=colours, lw=2.5)  # a ratio's base is 1: the noise
    axes.scatter(left_floors, range(len(shown)), c=faces, edgecolors=edges, linewidths=1.5, s=48, zorder=2.5)
    with_discrepancy = [
        min(left_with_discrepancy(explanation, ending) / floor, rms)
        for explanation, rms in zip(shown, left_floors, strict=True)
    ]
    decide = not rivals.all_below_noise(content, ending)
    if decide:
        axes.plot(with_discrepancy, range(len(shown)), "D", ms=3.5, mfc="white", mec="k", mew=0.7, zorder=3)
    weighed = any(explanation.get("probability") is not None for explanation in shown)
    alone = fill(ADOPTED_ROW.format(rivals.called(included(content))), TITLE_WIDE) if adopted else rivals.called([])
    names = [rivals.called(explanation["ids"]) if explanation["ids"] else alone for explanation in shown]
    axes.set_yticks(range(len(shown)), names, fontsize=7)
    for place, (explanation, rms) in enumerate(zip(shown, left_floors, strict=True)):
        beside = briefly(explanation) or (probability.not_weighed(explanation["ids"]) if weighed else "")
        too = explanation["ids"] and decide and not weighed and with_discrepancy[place] <= rivals.NOISY < rms
        beside = beside or AS_GOOD * bool(too and explanation["standing"] not in KEPT)
        axes.text(1.15 * max(rms, 1.0), place, beside, va="center", fontsize=6.5, color="0.3")  # never over its bar
    line = axes.axvline(1.0, color="k", ls="--", lw=0.8)
    shown_standings = set(standing_of)
    standings = [name for name in STANDINGS if name in shown_standings]
    meanings = {name: STANDINGS[name][1] for name in STANDINGS}
    meanings |= {"nothing": ADOPTED_ALONE} if adopted else {}
    meanings |= {} if "named" in shown_standings else {"not needed": MORE_ALONE}
    meanings |= {"beaten": UNLIKELY if weighed else WORSE} if unknown or not weighed else {}
    meanings |= {"beaten": LEFT_OUT} if not weighed and "named" in shown_standings else {}
    tied = [set(each["ids"]) for each in shown if each["standing"] == "tied"]
    best = [set(each["ids"]) for each in shown if each["standing"] == "named"]
    only_parts = not weighed and bool(tied) and all(ids < whole for ids in tied for whole in best)
    meanings |= {"tied": MENDS} if only_parts and best else {}
    meanings |= {} if unknown else {"not enough": NOT_NAMED}
    handles: list[Any] = [
        Line2D([], [], ls="", marker="o", ms=6, mfc="white", mec=OTHER, mew=1.5, label=meanings[name])
        if STANDINGS[name][0] == MORE
        else Patch(color=STANDINGS[name][0], label=meanings[name])
        for name in standings
    ]
    if decide:
        handles.append(Line2D([], [], ls="", marker="D", ms=3.5, mfc="white", mec="k", mew=0.7, label=WITH_DISCREPANCY))
    handles.append(Line2D([], [], color=line.get_color(), ls="--", lw=0.8, label=noise))
    if any(is_outside(id_) for explanation in shown for id_ in explanation["ids"]):
        handles.append(Line2D([], [], ls="", label=STAND_IN))
    axes.legend(handles=handles, fontsize=6.5, frameon=False, loc="upper center", bbox_to_anchor=(0.4, -0.17), ncols=2)
    axes.set(
        xscale="log",
        xlim=(0.5 * min(1.0, *left_floors, *(with_discrepancy if decide else [])), 2.6 * max(2.0, *left_floors)),
        xlabel="rms left ÷ noise",
    )
    plain(axes.xaxis)
    no_more = bool(content.get("simulation")) and not shown_standings & {"named", "tied", "not enough"}
    title = NO_MORE if no_more else f"Explanations: what each leaves{', and its probability' * weighed}"
    axes.set_title(title, fontsize=10)


def _standing(explanation: ExplanationEntry, first: ExplanationEntry, unknown: bool) -> str:
    """How an explanation fared, as its colour says it. Where nothing is named, only the `first` is the best one."""
    of_others = unknown and explanation["standing"] == "not enough" and explanation is not first
    return "beaten" if of_others else str(explanation["standing"])


def plain(axis: Axis) -> None:
    """A logarithmic axis with plain numbers: 0.5, 1, 2, 5, 10."""
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axis.set_minor_formatter(NullFormatter())


def held_out(
    axes: Axes, errors: HeldOut | None, floor: float, ending: str, unit: str, noise: str = "noise",
    title: str = "Error on unseen strokes", skip: int = 0, without: str = "", closest: str = "",
) -> None:  # fmt: skip
    """Error on the strokes that were held out, with the floor, called `noise`; `ending` is that of the keys.

    `without` is what was named without those strokes, where the verdict names other effects: the last error is its, is
    drawn hollow, and has its name in the legend. `closest` is what predicts them where nothing was named without them:
    the last error is its then.
    """
    axes.set_title(fill(title, TITLE_WIDE), fontsize=10)
    if not errors:
        axes.text(0.5, 0.5, "too few strokes to hold any out", ha="center", transform=axes.transAxes)
        axes.set(xticks=[], yticks=[])
        return
    values = [amount(errors, f"{name}_{ending}") for name in ("nominal", "calibrated", "explained")]
    names = list(SHADES)[skip : 2 if values[2] == values[1] else 3]  # what is the same is drawn once
    values, places = values[skip : skip + len(names)], range(len(names))
    hollow = [bool(without or closest) and name == NAMED for name in names]
    colours = [TIED if closest and name == NAMED else SHADES[name] for name in names]
    stems = axes.vlines(places, floor, values, colors=colours, lw=2.5)
    stems.set(linestyle=[":" if is_other else "-" for is_other in hollow])
    faces = ["white" if other else colour for other, colour in zip(hollow, colours, strict=True)]
    axes.scatter(places, values, c=faces, edgecolors=colours, linewidths=1.5, s=55, zorder=2.5)
    for place, value in enumerate(values):
        label = f"{size(value, unit)}\n{times(value / floor)} × noise"
        axes.annotate(label, (place, value), (0, 7), textcoords="offset points", ha="center", fontsize=7.5)
    below = CLOSEST.replace(" ", "\n", 1) if closest else "other\neffects" if without else NAMED.replace(" ", "\n")
    lines = 0
    if any(hollow):
        which = f"{CLOSEST}: {closest}" if closest else f"named without these strokes: {without}"
        axes.plot(
            [], [], ls=":", marker="o", ms=5, mfc="white", color=colours[-1], label=(label := fill(which, LEGEND_WIDE))
        )
        lines = label.count("\n")
    axes.set(
        xticks=places, xticklabels=[below if name == NAMED else name for name in names], xlim=(-0.6, len(names) - 0.4)
    )
    axes.axhline(floor, color="k", ls="--", lw=0.8, label=noise)
    low, high = 0.5 * min(*values, floor), max(*values, floor)
    room = low * (high / low) ** (
        1.0 / (HIGHEST - A_LINE * lines)
    )  # for the label of the highest point, and the legend above that
    axes.set(yscale="log", ylabel=f"rms ({unit})", ylim=(low, max(3.0 * high, room)))
    axes.tick_params(axis="x", labelsize=8)
    plain(axes.yaxis)
    axes.legend(fontsize=7, frameon=False, loc="upper center")
