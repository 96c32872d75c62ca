"""The parts of the reports, a material or a run each: every part has its own page, and few are on the index too."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from markupsafe import Markup

from ...ground.stored.files import write_text
from ..web.page import Text, anchor, document, folded, link, paragraph, together
from . import diagnoses, materials
from .rig_mark import Marks

FEW = 20  # parts of a kind that the index still shows itself; more would make it slow to open and long to read
FOLDER = "pages"  # below reports/
UP = "../"  # from there to reports/


class Parts:
    """All parts of one kind, `material` or `run`, in their order."""

    def __init__(self, kind: str, names: Sequence[str], body: Callable[[str, str], Markup]) -> None:
        """`body` is given a name and what leads from its page to `reports/`."""
        self.kind, self.names, self.body = kind, list(names), body
        self.few = len(self.names) <= FEW

    def page(self, name: str) -> str:
        """The address of a part's own page, from `reports/`; that of a material has a rule of its own."""
        return f"{FOLDER}/{anchor(self.kind, name)}.html" if self.kind == "run" else f"{link(name)}/index.html"

    def link(self, name: str, up: str = "") -> Markup:
        """A name that links to its part: on the index if it is there, else on its own page."""
        place = f"#{anchor(self.kind, name)}" if self.few and not up else up + self.page(name)
        return Markup('<a href="{}">{}</a>').format(place, name)

    def here(self, aside: Callable[[str], Text], level: int) -> list[Markup]:
        """The parts that the index shows itself, folded."""
        own = Markup('<p class="soft"><a href="{}">On a page of its own</a></p>')
        sections = []
        for name in self.names if self.few else []:
            below = together([self.body(name, ""), own.format(self.page(name))])
            sections.append(folded(anchor(self.kind, name), name, aside(name), below, level))
        return sections

    def write(self, folder: Path, marks: Marks, heads: Mapping[str, Text]) -> None:
        """Write every part's page into a folder, with the ways to the index, to the one before and to the next."""
        last = len(self.names) - 1
        for at, name in enumerate(self.names):
            ways = [Markup('<a href="{}index.html">All reports</a>').format(UP)]
            beside = {"before": at - 1, "next": at + 1}
            ways += [
                Markup('{}: <a href="{}">{}</a>').format(words, UP + self.page(self.names[to]), self.names[to])
                for words, to in beside.items()
                if 0 <= to <= last
            ]
            body = together(filter(None, [paragraph(heads.get(name, "")), self.body(name, UP)]))
            text = document(name, body, marks(name), above=Markup(" · ").join(ways))
            write_text(folder / Path(self.page(name)).name, text)


def of_materials(reports: Path, names: Sequence[str], strings: Mapping[str, Sequence[str]], runs: Parts) -> Parts:
    """The materials' parts; `strings` gives the runs of each."""

    def body(material: str, up: str) -> Markup:
        own = [runs.link(run, up) for run in strings.get(material, []) if run in run_names]
        return materials.part(reports, material, own, up)

    run_names = set(runs.names)
    return Parts("material", names, body)


def of_runs(reports: Path, names: Sequence[str]) -> Parts:
    """The parts of the runs that are diagnosed."""
    return Parts("run", names, lambda run, up: diagnoses.part(reports, run, up))
