"""The end of a loop: `settled.json`, and the words and next steps for a person."""

import json
import shlex
from collections.abc import Sequence
from pathlib import Path

from ..ground.command import command
from ..ground.stored.files import write_text
from ..ground.words.verdict_text import MAY_ADOPT, record_asked, to_do
from .choose import Budget
from .proposed import StepVerdict
from .step import Place, Step
from .tie import probable

NAME = "settled.json"
OPTIONAL = "Optional"  # begins a step of a verdict that nobody has to take
ADOPT = "adopt what the last verdict names, for each run:"
BEFORE = "before adopting, "  # what the steps below it say by their order


def settled(place: Place, steps: Sequence[Step], runs: Sequence[Path], budget: Budget, why: str, sentence: str) -> None:
    """Write why the loop ended, the verdict of its last step, the runs and the spent budget; and print it."""
    verdict, budget_left = place.diagnosis(steps[-1].number), budget.left(steps)
    mechanisms = [entry["id"] for entry in verdict["mechanisms"]]
    spent = {"runs": budget.runs - budget_left.runs, "strokes": budget.strokes - budget_left.strokes}
    content = {
        "why": why,
        "sentence": sentence,
        "verdict": verdict["verdict"],
        "mechanisms": mechanisms,
        "alternatives": verdict["alternatives"],
        "runs": [str(run) for run in runs],
        "spent": {**spent, "minutes": round(budget.minutes - budget_left.minutes, 3)},
    }
    write_text(place.out / NAME, json.dumps(content, indent=1, ensure_ascii=False) + "\n")
    named = f": {sure_and_large(verdict)}" if mechanisms else ""
    folder = place.folder(steps[-1].number)
    lines = [
        f"settled: {sentence}{named}" if why == "verdict" else f"ended, not settled: {sentence}",
        f"  the last verdict: {folder / 'verdict.txt'}",
        f"  how it ended: {place.out / NAME}",
        *_next(folder, verdict["verdict"], runs),
    ]
    if why != "verdict" and (more := going_on(sentence, budget)):
        lines.append(f"  or: {more}")
    print("\n".join(lines), flush=True)


def sure_and_large(verdict: StepVerdict) -> str:
    """The effects of a verdict with their probability and size: `creep (94 %), 0.14 mm rms`."""
    sizes = [(entry["id"], entry["rms_mm"]["value"]) for entry in verdict["mechanisms"] if "rms_mm" in entry]
    large = [f"{f'{id_} ' * (len(sizes) > 1)}{value:.2g} mm rms" for id_, value in sizes]
    return ", ".join([probable([entry["id"] for entry in verdict["mechanisms"]], verdict), *large])


def going_on(sentence: str, budget: Budget) -> str:
    """How to go on where the budget ended the loop, by the option in the sentence; else nothing."""
    now = {"--runs": budget.runs, "--minutes": budget.minutes, "--strokes": budget.strokes}
    short = [f"{option} above {value:g}" for option, value in now.items() if option in sentence]
    return f"start it again with the same words and {' and '.join(short)}: it goes on from here" if short else ""


def _recording(asked_for: str) -> str:
    """The recording that a verdict's page asks for, or proposes as an optional step."""
    if asked_for.startswith(OPTIONAL):
        run = (asked_for.partition(": ")[2] or asked_for).replace(BEFORE, "")
        return f"optional, to be surer of a name: {run} (how: details.txt beside the last verdict)"
    return f"record once more, as the last verdict asks: {asked_for}"


def _next(folder: Path, verdict: str, runs: Sequence[Path]) -> list[str]:
    """What a person does after the loop, in its order, a line each."""
    page = folder / "verdict.txt"
    text = page.read_text(encoding="utf-8") if page.is_file() else ""
    asked_for = record_asked(text)
    recording = [_recording(asked_for)] if asked_for else []
    if verdict in ("explained", "parameters"):
        words = [*command("adopt").split(), str(folder / "diagnosis.json")]
        adopt = [f"      {shlex.join([*words, str(run)])}" for run in runs]
        lets = MAY_ADOPT in to_do(text) if text else True
        steps = [*recording, *(["\n".join([ADOPT, *adopt])] if lets else [])]
        if len(steps) > 1:
            return ["  next, in this order:", *(f"    {place}. {step}" for place, step in enumerate(steps, start=1))]
        start = "" if recording else "nothing to record; "
        against = "" if lets else "; the last verdict does not advise to adopt it" if recording else "nothing to adopt"
        return [f"  next: {start}{''.join(steps)}{against}"]
    if verdict == "consistent":
        return [f"  next: {''.join(recording) or 'nothing to record: the simulator fits as it is'}"]
    names = [*map(str, runs), "NEW_RUN", "--together", "--out", "NEW_FOLDER"]
    diagnose = shlex.join([*command("diagnose").split(), *names])
    reads = "what it could be" if verdict == "unknown" else "what tells the explanations apart"
    return [f"  next: read there {reads}. After another run made by hand: {diagnose}"]
