"""The files that a diagnosis is written to: JSON, words, figures, and what run.yaml can adopt."""

import json
from pathlib import Path

from ..ground.stored.checked_json import write_checked
from ..ground.stored.files import write_text
from ..systems import System
from .choice.outcome import Study
from .document.content import Verdict
from .fit.adopt import adoptions, block
from .words.language.vocabulary import Vocabulary
from .words.pages import advice, earlier
from .words.pages.details import details_text
from .words.pages.verdict import verdict_text

JSON = "diagnosis.json"


def write_words(content: Verdict, system: System, folders: list[Path], out: Path, doubts: list[str]) -> str:
    """Write the words of a diagnosis of runs, as JSON and as text, `doubts` first; return the words."""
    before = earlier.sentences(content, folders, out)  # it may lie where this one is written
    write_checked(out / JSON, json.dumps(content, indent=1, ensure_ascii=False) + "\n")
    texts_from = (content, system, folders, out, [*doubts, *before])
    words = verdict_text(*texts_from)
    write_text(out / "details.txt", details_text(*texts_from) + "\n")
    write_text(out / "verdict.txt", words + "\n")
    return words


def draw(study: Study, content: Verdict, path: Path, mark: str = "") -> None:
    """Draw the page of figures; what draws takes 40 MB, and is imported when the search has let go of more."""
    study.search.linear.let_go()
    from .drawing import figures

    figures.page(study, content, path, mark)


def write_block(content: Verdict, system: System, out: Path) -> None:
    """Write the `simulation` of a diagnosis that names something, ready to be pasted into run.yaml; else remove it."""
    path = out / "simulation.yaml"
    if content["mechanisms"] and content["simulation"]:
        against = advice.instead(content, Vocabulary.of(system))
        adopted = adoptions(content, str(out / JSON), str(content["run"]), against)
        write_text(path, block(content["simulation"]) + block(adopted, "adopted"))
    else:
        path.unlink(missing_ok=True)  # of an earlier diagnosis


def write_seconds(path: Path | None, seconds: dict[str, float]) -> None:
    """Write by run the CPU seconds that each diagnosis took, where that was asked for."""
    if path is not None:
        write_text(path, json.dumps({run: round(taken, 2) for run, taken in seconds.items()}) + "\n")
