"""Runs of strings → how many strokes each has left: lifespan.json, lifespan.png and sentences.

A forecast needs 12 complete strokes of a string to about the same twist under one load, in one run or in several
that are named together. With fewer the answer says how far the limits are now.
"""

from pathlib import Path

from ..ground.command import command
from ..ground.errors import BadInput, program
from ..ground.input.outputs import folder_to_write
from ..ground.input.parser import Parser
from ..ground.words.progress import clear, steps
from ..run.run_arguments import run_dir
from . import written
from .forecast.life_questions import Answer, model_error, stroke_loss
from .forecast.strokes_left import LEAST_STROKES
from .from_folders import others_beside, strings
from .stroke_health.health import Health
from .words import sentences
from .words.calibrate_again import calibrate_by
from .words.jump_said import jump_lines
from .words.page_lines import page


def ask(string_health: Health, loss: float, drift_mm: float) -> list[Answer]:
    """Both questions to a string's health."""
    return [stroke_loss(string_health, loss), model_error(string_health, drift_mm)]


@program
def main() -> int:
    """Command line."""
    on_a_rig = f"On the synthetic rig: {command('rig')} paper --link /tmp/rig --strokes 24"
    parser = Parser(prog=command("lifespan"), description=__doc__, epilog=on_a_rig)
    runs = f"raw/<run>, all of a string's: {LEAST_STROKES} equal strokes under one load, or more"
    parser.add_argument("run_dir", type=run_dir, nargs="+", help=runs)
    parser.add_argument("--loss", type=float, default=0.10, help="share of the stroke that may be lost")
    parser.add_argument("--drift-mm", type=float, default=1.0, help="error of the model that is borne, in mm")
    parser.add_argument("--level", type=float, default=0.9, help="probability that the interval shall hold")
    parser.add_argument(
        "--out", type=Path, required=True, help="the folder in which each string gets a folder; required"
    )
    arguments = parser.parse_args()
    for name, value, most in (
        ("loss", arguments.loss, 1.0),
        ("drift-mm", arguments.drift_mm, float("inf")),
        ("level", arguments.level, 1.0),
    ):
        if not 0.0 < value < most:
            raise BadInput(
                "arguments", f"--{name}", f"is {value:g}", f"give a number above 0{' and below 1' * (most == 1)}"
            )
    folder_to_write(arguments.out)
    scratch = next(folder for folder in (arguments.out, *arguments.out.absolute().parents) if folder.is_dir())
    for string_health in steps(strings(arguments.run_dir, scratch), "string"):
        answers = ask(string_health, arguments.loss, arguments.drift_mm)
        lines = written.write(string_health, answers, arguments.level, arguments.out)
        clear()
        if others := others_beside(string_health.string, arguments.run_dir):
            print(page(sentences.not_given(string_health.string, arguments.run_dir, others, arguments.out)))
        own = [folder for folder in arguments.run_dir if folder.resolve().name in string_health.runs]
        by = calibrate_by(string_health.material, own, arguments.out)
        jumps = jump_lines(string_health, own, arguments.out)
        print(page(sentences.sentences(string_health, answers, arguments.level, bool(others), by, jumps)))
        print(page("\n".join(f"  {line}" for line in lines)))
    return 0


if __name__ == "__main__":
    main()
