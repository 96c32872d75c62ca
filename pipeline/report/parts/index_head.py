"""The index's first lines: each material's model to take, how many runs ended how, each run's verdict."""

from collections import Counter
from collections.abc import Callable, Mapping
from pathlib import Path

from markupsafe import Markup

from ..layout.verdict_content import Content
from ..model_to_take.to_take import materials_table
from ..web.glossary import word
from ..web.page import Text, folded, paragraph, together
from ..web.sortable_table import table
from . import jumps
from .diagnoses import (
    DIAGNOSED,
    NAMING,
    NOT_SETTLED,
    SIZES,
    UNDECIDED,
    VERDICTS,
    WORSE,
    badge_of,
    content_of,
    named_of,
    next_recording,
    sizes,
    tag,
    verdict_of,
    why_no_number,
    why_nothing,
)

LONGEST = 180  # characters of a next run in a table; the whole of it stands beside the verdict
WHAT = (
    "This page shows what was made of the recordings in raw/. For each material: the model to take, and "
    "how large its error is. For each run: what the simulator leaves out, and which run to make next."
)
RULES_ASIDE = "by which rule the model to take is found, what later strokes are, which model errs less on what"
AMBIGUOUS = " Ambiguous is no fault: several explanations fit what was recorded, and the next run decides."
UNSEEN = 3  # of the sizes are errors on strokes that no fit has seen
Name = Callable[[str], Text]  # the name of a material or a run as a link to its part


def shortened(text: str) -> str:
    """The first words of a run to make: up to its first colon or semicolon, or as many as fit."""
    first = min((text.split(sign)[0] for sign in (": ", "; ", ". ")), key=len).rstrip(".")
    if len(first) <= LONGEST:
        return first
    return first[:LONGEST].rsplit(" ", 1)[0] + " …"


def next_run(content: Content | None, folder: Path) -> Text:
    """The run that a diagnosis proposes, or the recording that its verdict asks for, in a few words; else empty.

    Words that are cut off are whole in a title.
    """
    whole = str((content or {}).get("next_experiment") or next_recording(folder))
    words = shortened(whole)
    return Markup('<span title="{}">{}</span>').format(whole, words) if words.endswith(" …") else words


def advice(verdict: str, folder: Path) -> str:
    """The advice against adopting, its reason, and the verdict's other words; empty where adopting is advised."""
    why = why_nothing(folder)
    fits = "explains what was recorded, but " if verdict in NAMING else ""
    return f"{fits}adopt nothing: {why}" if why else ""


def runs_table(reports: Path, contents: Mapping[str, Content | None], of: Mapping[str, str], name: Name) -> Markup:
    """Each run's material, verdict, what it names, its sizes and the run to make next."""
    rows: list[list[Text]] = []
    for run, content in contents.items():
        folder = reports / "diagnosis" / run
        names = Markup("<br>").join(filter(None, [named_of(content), advice(verdict_of(content), folder)]))
        rows.append([name(run), of.get(run, ""), tag(badge_of(content)), names])
        numbers: list[Text] = [*sizes(content)]
        if why := why_no_number(content):
            place = SIZES.index(DIAGNOSED)
            numbers[place] = Markup('{}<br><span class="why">{}</span>').format(numbers[place], why)
        rows[-1] += [*numbers, next_run(content, folder)]
    head: list[Text] = ["Run", "Material", "Verdict", "Left out of the simulator", *map(word, SIZES), "Next run"]
    over: list[tuple[Text, int]] = [("", 5), ("rms error on unseen strokes (the last 30 %)", UNSEEN), ("", 2)]
    return table(head, rows, texts=(0, 1, 2, 3, len(head) - 1), over=over, paged=True)


def counted(contents: Mapping[str, Content | None]) -> Markup:
    """How many runs ended with which verdict; a click on one shows its runs alone."""
    counts = Counter(badge_of(content) for content in contents.values())
    shape = Markup('<a href="#runs" data-only="{0}">{1:,} {2}</a>')
    badges = [
        badge for verdict in (*VERDICTS, UNDECIDED) for badge in (verdict, verdict + NOT_SETTLED, verdict + WORSE)
    ]
    return Markup(" · ").join(shape.format(badge, counts[badge], tag(badge)) for badge in badges if counts[badge])


def glance(
    reports: Path,
    materials: list[str],
    runs: list[str],
    of: Mapping[str, str],
    material_name: Name,
    run_name: Name,
    jumped: jumps.Notes = jumps.NONE,
) -> Markup:
    """The opening of the index; `of` gives a run's material, `jumped` the remark on a material's zero."""
    contents = {run: content_of(reports / "diagnosis" / run) for run in runs}
    parts: list[Text] = [paragraph(WHAT) if materials or runs else "", Markup('<h2 id="glance">At a glance</h2>')]
    below_runs: list[Text] = []
    if materials:
        aside = f"{len(materials):,}: the model to take, and its error beside the least possible one (× floor)"
        named = {material: material_name(material) + jumps.hint(material, jumped) for material in materials}
        of_materials, rules = materials_table(reports, materials, named.__getitem__)
        parts.append(folded("materials", "Materials", aside, of_materials, level=3, is_open=True))
        below_runs.append(folded("rules", "How to read the materials", RULES_ASIDE, rules, level=3))
    if jumped:
        parts.append(jumps.section(jumped))
    if runs:
        ambiguous = any(verdict_of(content) == "ambiguous" for content in contents.values())
        parts.append(paragraph(Markup("Verdicts: {}.{}").format(counted(contents), AMBIGUOUS * ambiguous)))
        aside = f"{len(runs):,}: what the simulator leaves out, run by run; mismatch and noise are rms"
        parts.append(folded("runs", "Runs", aside, runs_table(reports, contents, of, run_name), level=3, is_open=True))
    parts += below_runs
    if not materials and not runs:
        parts.append(paragraph("No run lies in raw/ yet."))
    return together(filter(None, parts))
