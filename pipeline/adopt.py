"""Adopt a diagnosis: its `simulation` goes into a run's `run.yaml`, and the other text of that file stays as it is."""

import shlex
import sys
from pathlib import Path

from pydantic import ValidationError

from .diagnosis.adoption import before_after
from .diagnosis.adoption.block import KEY, ORIGIN, adopted, bare
from .diagnosis.adoption.explain import explained, without_effects
from .diagnosis.adoption.other_runs import for_others
from .diagnosis.document.content import Verdict
from .diagnosis.fit.adopt import acts_from, adoptions, checked
from .diagnosis.prediction.later_run import adopted_by
from .diagnosis.prediction.simulation import read_diagnosis
from .diagnosis.recording.recorded_run import RecordedRun
from .diagnosis.words.language.quantity import listing
from .diagnosis.words.language.sections import section
from .diagnosis.words.language.vocabulary import Vocabulary
from .diagnosis.words.pages.adoption import adopted_predictions, hung, weighed_anew
from .diagnosis.words.pages.advice import instead
from .ground.command import command
from .ground.errors import BadInput, program
from .ground.input.complaint import short
from .ground.input.parser import Parser
from .ground.input.strict_yaml import LARGEST, parse_yaml
from .ground.names import SYNTHETIC
from .ground.stored.files import write_over
from .ground.stored.regular_file import read_regular
from .ground.words.wrapped_lines import wrapped
from .run.description import Adopted, Run
from .run.folder import has_recording, read_run
from .run.run_arguments import run_dir
from .run.samples import read_strokes

MOST = 5  # explanations that are named
HEADINGS = ("What changed", "What it means", "What comes next")


def check(content: Verdict, source: Path, folder: Path) -> tuple[list[str], list[str]]:
    """What adopting changes, in words: the errors on the run's recording, and the dimensions.

    A run without a recording takes any known names. Raises BadInput unless what a diagnosis names can act in the run.
    """
    for number, entry in enumerate(content["simulation"]):
        checked(entry, f"{KEY}[{number}]", str(source))
    if not has_recording(folder):
        return [], []
    run, samples, strokes = read_strokes(folder)
    bare = without_effects(run, samples, strokes)
    acts_from(content["simulation"], bare.drivers, str(source))
    adopting = run.model_copy(update={KEY: content["simulation"], ORIGIN: origin_of(content, source, run)})
    own_run = before_after.is_of(content, run.run)
    recorded, now = RecordedRun(run, samples, strokes, folder), adopted_by(adopting)
    errors = before_after.told(recorded, bare, adopted_by(run), now, source, own_run)
    own = before_after.on_unseen(content, Vocabulary.of(run.system), run.run)
    return [*errors, *before_after.begun_anew(content, run.run, folder), *own], before_after.dimensions(content)


def origin_of(content: Verdict, source: Path, run: Run) -> list[Adopted]:
    """What a run.yaml says of where its effects are from, once it has adopted a diagnosis. Raises BadInput."""
    try:
        against = instead(content, Vocabulary.of(run.system))
        return [Adopted.model_validate(each) for each in adoptions(content, str(source), run.run, against)]
    except ValidationError as error:
        problem = f"is not what adopting wrote ({short(error.errors()[0]['msg'])})"
        raise BadInput(source, ORIGIN, problem, "give a diagnosis.json as it was made") from None


def sentences(content: Verdict) -> list[str]:
    """What each effect does, in the words of the verdict that named it, a line each."""
    parts = [content.get("mechanisms"), content.get("beside")]
    entries = [entry for part in parts if isinstance(part, list) for entry in part if isinstance(entry, dict)]
    return [f"  {entry['id']}: {entry['sentence']}" for entry in entries if isinstance(entry.get("sentence"), str)]


def taken_out(folder: Path) -> str:
    """The command that takes what was adopted out of a run's run.yaml, as a line to print."""
    return f"  {command('adopt')} --remove {shlex.quote(str(folder))}"


def remove(folder: Path) -> str:
    """Take out of a run's `run.yaml` what was adopted, and say what that was. Raises BadInput."""
    run, path = read_run(folder), (folder / "run.yaml").resolve()
    text = read_regular(path, LARGEST, "run.yaml").decode("utf-8")
    new_text = bare(text, path)
    if new_text == text:
        return f"{folder / 'run.yaml'} holds nothing that was adopted; it stays as it is"
    write_over(path, new_text)
    names = listing(list(dict.fromkeys(entry["id"] for entry in run.simulation))) or "no effect"
    return (
        f"{folder / 'run.yaml'}: {KEY} and {ORIGIN} are taken out (they held {names}); all else in it stays as it was"
    )


@program
def main() -> None:
    """Command line."""
    program = command("adopt")
    others = f"       {program} --remove RUN_DIR\n       {program} --explain RUN_DIR"
    usage = f"{program} DIAGNOSIS.json RUN_DIR [--sure]\n{others}"
    parser = Parser(prog=program, usage=usage, description=__doc__)
    what, whose = "a diagnosis.json; its effects are adopted", "the run whose run.yaml takes them over"
    parser.add_argument("diagnosis", type=Path, nargs="?", metavar="DIAGNOSIS.json", help=what)
    parser.add_argument("run_dir", type=run_dir, nargs="?", metavar="RUN_DIR", help=whose)
    out = "take all that was adopted out of this run's run.yaml again"
    parser.add_argument("--remove", type=run_dir, metavar="RUN_DIR", help=out)
    means = "say what the numbers mean that this run's run.yaml has adopted"
    parser.add_argument("--explain", type=run_dir, metavar="RUN_DIR", help=means)
    sure = "adopt it though the verdict advises against it"
    parser.add_argument("--sure", action="store_true", help=sure)
    arguments = parser.parse_args()
    if (arguments.remove or arguments.explain) and arguments.diagnosis:
        parser.error("--remove and --explain take a run folder and nothing else")
    if arguments.remove:
        print(remove(arguments.remove))
        return
    if arguments.explain:
        show(explained(arguments.explain))
        return
    if arguments.run_dir is None:
        parser.error("give a diagnosis.json and the run's folder, or --remove and the run's folder")
    adopt(arguments.diagnosis, arguments.run_dir, arguments.sure)


def adopt(source: Path, folder: Path, sure: bool = False) -> None:
    """Put what a diagnosis names into a run's `run.yaml`, and say what that does.

    Raises BadInput, also where the verdict advises against it, unless a person is `sure`.
    """
    run, content, path = read_run(folder), read_diagnosis(source), (folder / "run.yaml").resolve()
    acting = [entry for entry in content["simulation"] if isinstance(entry, dict)]
    ids = list(dict.fromkeys(str(entry.get("id")) for entry in acting))
    names = listing(ids)
    if not content["simulation"]:
        print(f"{source} names no mechanism: there is nothing to adopt, and {folder / 'run.yaml'} stays as it is")
        return
    own = before_after.is_of(content, run.run)
    if own and (other := before_after.outdated(content, run)):
        raise BadInput(source, "parameters", f"was made with {other}", "diagnose the run again, and adopt that")
    words = Vocabulary.of(run.system)
    before_after.refuse_unadvised(content, words, source, sure)
    errors, dimensions = check(content, source, folder)
    if run.string and run.string.material == SYNTHETIC:
        print(
            "beware: the main job records this run anew, and then its run.yaml holds nothing adopted", file=sys.stderr
        )
    if not own:
        same = "the same string on the same rig" if words.twisted else "the same rig"
        caution = f"{source} is of {short(content['run'])}: what it names holds for {same} only"
        print(f"beware: {caution}", file=sys.stderr)
    origin = adoptions(content, str(source), run.run, instead(content, words))
    text = read_regular(path, LARGEST, "run.yaml").decode("utf-8")
    new_text = adopted(text, content["simulation"], path, origin)
    if parse_yaml(new_text, path) == parse_yaml(text, path):
        named = bool(content.get("mechanisms"))
        nothing = f" {source} names no further effect: the dimensions that it calibrated are not taken over."
        same = f"{folder / 'run.yaml'} holds {names} already, as {source} gives them; it stays as it is."
        print("\n".join(wrapped(f"{same}{'' if named else nothing}", "")))
        return
    write_over(path, new_text)
    doubt = before_after.against_advice(content, words, taken_out(folder))
    changed = [f"{folder / 'run.yaml'}: {KEY} holds {names} now; all that you wrote into it stays as it was"]
    changed += [*sentences(content), *dimensions]
    others, means = origin[-1]["tied"] if origin else [], errors
    if others:
        many = f"{len(others)} other explanation{'s were' if len(others) > 1 else ' was'} likely too"
        sets = [before_after.probable(ids, content) for ids in [origin[-1]["effects"], *others[:MOST]]]
        means.append(f"{many}: {listing(sets[1:], 'or')}. Adopted is {sets[0]}.")
    then = adopted_predictions(folder, words, hung(content, words), ids)
    then += [*for_others(content, run.run, folder, source), before_after.NEXT]
    then += ["What its numbers mean, if you are curious:", f"  {command('adopt')} --explain {shlex.quote(str(folder))}"]
    then += ["To take all of it out of run.yaml again:", taken_out(folder)] * (not doubt)
    if doubt:
        show([*doubt, before_after.KEPT])
        print()
    groups = zip(HEADINGS, (changed, [*means, weighed_anew(words)], then), strict=True)
    print("\n\n".join(section(head, lines) for head, lines in groups))


def show(lines: list[str]) -> None:
    """Print lines within the width of a page."""
    for line in lines:
        print("\n".join(wrapped(line, "")))


if __name__ == "__main__":
    main()
