"""Models.csv of each material → the index's table: the model to take, its errors, and beside it the simulator's."""

import csv
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import NamedTuple

from markupsafe import Markup

from ...ground.model_errors import chosen_of, floor_in, is_apart, needs_motion
from ...ground.model_names import FLOORS, SIMULATOR
from ..shown.stroke_conditions import APART
from ..web.page import Text, paragraph, together
from ..web.sortable_table import table
from . import inverse_beside
from .fitted import times_floor
from .usual_model import RULE, RULES, uses, weighed

LATER = (
    "Later strokes are the last quarter of a string's strokes, which the fit of a model leaves out: of five the fifth."
    " The unseen strokes in the table of runs are the last 30 % of one run's strokes, which its diagnosis leaves out:"
    " of five the last two, with their holds and rests. Each of the two diagnoses sees other strokes and may name other"
    " effects, which foresee what follows differently. So the error of the diagnosed simulator can be several times as"
    " large in one table as in the other, a sign that the effects are not settled."
)
FAR = 10.0  # times the floor: an error so large is coloured
WAYS, SPLITS = ("forward", "inverse"), ("within", "later")
MODEL_HEADS = ["held-out points", "later strokes"]
Name = Callable[[str], Text]  # the name of a material as a link to its part
Errors = dict[tuple[str, str, str], tuple[float, str]]  # model, split and way → RMSE, and how it is said


class Models(NamedTuple):
    """The models of a material: their titles, and their errors on all points."""

    titles: dict[str, str]
    errors: Errors
    ratios: dict[tuple[str, str, str], float]  # by the same key → the error in floors
    floor_mm: float  # the noise of held-out points, 0 where it is not known
    apart: set[tuple[str, str, str]]  # keys of errors on strokes under other conditions, by which none is chosen
    whole_motion: set[str]  # models that answer along a whole motion alone, of which none is chosen

    @classmethod
    def read(cls, path: Path) -> "Models":
        """Those of a models.csv; none where the file is not there."""
        models = cls({}, {}, {}, floor_in(path), set(), set())
        if not path.is_file():
            return models
        with open(path, encoding="utf-8", newline="") as file:
            for line in csv.DictReader(file):
                if line["column"] != "all" or line["model"] in FLOORS:
                    continue
                models.titles[line["model"]] = line["title"]
                rmse = float(line["median"])
                times = f" ({times_floor(float(line['ratio']))} ×)" if line["ratio"] else ""
                key = line["model"], line["split"], line["map"]
                if is_apart(line):
                    models.apart.add(key)
                if needs_motion(line):
                    models.whole_motion.add(line["model"])
                if line["ratio"]:
                    models.ratios[key] = float(line["ratio"])
                models.errors[key] = rmse, f"{rmse:.3f}{times}"
        return models

    def inverse_turns(self) -> dict[tuple[str, str], float]:
        """The inverse errors by which models are compared, by model and split, in turns."""
        return self._compared(WAYS[1])

    def forward_mm(self) -> dict[tuple[str, str], float]:
        """The forward errors by which models are compared, by model and split, in mm."""
        return self._compared(WAYS[0])

    def _compared(self, way: str) -> dict[tuple[str, str], float]:
        errors = {key: rmse for key, (rmse, _) in self.errors.items() if key[2] == way and key not in self.apart}
        return {(model, split): rmse for (model, split, _), rmse in errors.items() if model not in self.whole_motion}

    def to_compare(self) -> dict[str, str]:
        """The titles of the models that can be taken."""
        return {model: title for model, title in self.titles.items() if model not in self.whole_motion}

    def chosen(self) -> str:
        """The model to take."""
        return chosen_of(self.to_compare(), self.forward_mm())

    def row(self) -> list[Text]:
        """Title of the model to take, its errors both ways on both splits, and the diagnosed simulator's forward."""
        chosen = self.chosen()
        keys = [(chosen, split, way) for way in WAYS for split in SPLITS]
        keys += [(SIMULATOR, split, WAYS[0]) for split in SPLITS]
        return [self.titles.get(chosen, ""), *(self.cell(key) for key in keys)]

    def cell(self, key: tuple[str, str, str]) -> Text:
        """An error as the table has it, coloured where it is far above the floor; empty where it is not known."""
        if key not in self.errors:
            return ""
        words = self.errors[key][1]
        return Markup('<span class="far">{}</span>').format(words) if self.ratios.get(key, 0.0) > FAR else words

    def weighed(self) -> str:
        """The other model that errs less than the one to take; empty if there is none."""
        return weighed(self.to_compare(), self.forward_mm(), self.floor_mm)

    def at_inverse(self) -> str:
        """The other model that is clearly better at the inverse, and by how much; empty if there is none."""
        chosen, titles, turns = self.chosen(), self.to_compare(), self.inverse_turns()
        if not inverse_beside.better(chosen, list(titles), turns):
            return ""
        return inverse_beside.sentences(chosen, titles, turns, self.forward_mm())


def later_apart(models: Path) -> str:
    """The remark on later strokes that differ in more than their number, from the models' page; else empty."""
    lines = models.read_text(encoding="utf-8").splitlines() if models.is_file() else []
    return next((line for line in lines if line.startswith(APART)), "")


def words(reports: Path, materials: Mapping[str, Models]) -> Markup:
    """The rule for these models, the commands that use one, and the meaning of the simulator's column."""
    by_model: dict[str, list[str]] = {}
    for material, models in materials.items():
        by_model.setdefault(models.chosen(), []).append(material)
    everywhere = "The page of every model, below, says which errs least on what."
    lines: list[Text] = [everywhere] if any(by_model) else []
    rules = Markup("").join(Markup("<li>{}</li>").format(rule) for rule in RULES)
    begins = [paragraph(LATER), paragraph(RULE), Markup("<ol>{}</ol>").format(rules)] if any(by_model) else []
    for model, chosen_for in by_model.items():
        if model:
            export, _ = uses(chosen_for[0] if len(chosen_for) == 1 else "<material>", model)
            title = materials[chosen_for[0]].titles[model]
            lines.append(Markup("The {} is exported by <code>{}</code>.").format(title, export))
    for material, models in materials.items():
        own = [models.weighed(), models.at_inverse(), later_apart(reports / material / "models.md")]
        if any(own):
            lines.append(Markup("<b>{}</b>: {}").format(material, " ".join(filter(None, own))))
    if named := next((models.titles[SIMULATOR] for models in materials.values() if SIMULATOR in models.titles), ""):
        lines.append(
            f"The {named[:1].lower()}{named[1:]} is no model to take away: it needs the whole motion, so it can be "
            "neither exported nor asked. Its error is that of a simulator with the effects that the diagnosis names. "
            "Where it is large on later strokes, these effects do not foresee them. "
            f"Red: more than {FAR:g} times the floor, the least possible error."
        )
    return together([*begins, *(paragraph(line) for line in lines)])


def materials_table(reports: Path, materials: list[str], name: Name) -> tuple[Markup, Markup]:
    """Each material's model to take with its errors, the diagnosed simulator's beside them; and why."""
    by_material = {material: Models.read(reports / material / "models.csv") for material in materials}
    rows: list[list[Text]] = [[name(material), *models.row()] for material, models in by_material.items()]
    head = ["Material", "model to take", *MODEL_HEADS, *MODEL_HEADS, *MODEL_HEADS]
    over: list[tuple[Text, int]] = [
        ("", 2),
        ("forward: RMSE in mm (× floor)", 2),
        ("inverse: RMSE in turns (× floor)", 2),
    ]
    over.append(("diagnosed simulator, forward: mm (× floor)", 2))
    return table(head, rows, texts=(0, 1), over=over, paged=True), words(reports, by_material)
