"""Change a value in a run's run.yaml, or exchange two columns; other text stays.

channels.displacement_mm.scale=-1        the displacement's sign is turned
channels.motor_turns.unit=deg            the column is read in another unit
--exchange motor_turns displacement_mm   each is read from the other's column
tare=run                                 the zero was moved since the run before
"""

import argparse
import sys
from pathlib import Path

from .ground.command import command
from .ground.errors import BadInput, program
from .ground.input.parser import Parser
from .ground.input.strict_yaml import LARGEST, parse_yaml
from .ground.stored.files import write_over
from .ground.stored.regular_file import read_regular
from .ground.words.counts import counted
from .run.changed_yaml import Change, exchanged, with_changes
from .run.folder import is_recorded
from .run.mend_command import with_command
from .run.next_command import following
from .run.run_arguments import run_dir
from .run.samples import questions, read_strokes
from .string.same_string import others_recorded


def change(word: str) -> Change:
    """The key and the value of a word KEY=VALUE; raises BadInput."""
    key, equals, value = word.partition("=")
    if not (key and equals):
        mend = "write KEY=VALUE, as in channels.displacement_mm.scale=-1 or tare=run"
        raise BadInput("the command line", word, "says no value of a key", mend)
    return key, parse_yaml(value, Path(key))


def mend(folder: Path, words: list[str], pair: list[str] | None) -> list[str]:
    """Change the run.yaml in a folder, and say what was changed, a line each; raises BadInput."""
    path = (folder / "run.yaml").resolve()
    text = read_regular(path, LARGEST, "run.yaml").decode("utf-8", errors="replace")
    changes = [*map(change, words), *(exchanged(text, pair[0], pair[1], folder) if pair else [])]
    new_text, sentences = with_changes(text, changes, folder)
    write_over(path, new_text)
    return [f"{folder / 'run.yaml'}: {sentence}." for sentence in sentences]


@program
def main() -> None:
    """Command line."""
    usage = "%(prog)s RUN_DIR KEY=VALUE [KEY=VALUE …]\n       %(prog)s RUN_DIR --exchange CHANNEL CHANNEL"
    how = argparse.RawDescriptionHelpFormatter
    parser = Parser(prog=command("mend"), usage=usage, description=__doc__, formatter_class=how)
    parser.add_argument("run_dir", type=run_dir, metavar="RUN_DIR", help="the run whose run.yaml is changed")
    sets = "a value of tare, channels, file, tolerance, string or rig, and what it is from now on"
    parser.add_argument("changes", nargs="*", metavar="KEY=VALUE", help=sets)
    both = "exchange the columns of two channels"
    parser.add_argument("--exchange", nargs=2, metavar="CHANNEL", help=both)
    arguments = parser.parse_args()
    if not (arguments.changes or arguments.exchange):
        parser.error("give KEY=VALUE, or --exchange and two channels")
    folder = arguments.run_dir
    print("\n".join([*mend(folder, arguments.changes, arguments.exchange), "All else in it stays as it was."]))
    if not is_recorded(folder):
        return
    run, samples, strokes = read_strokes(folder)
    for question in questions(run, samples, folder):
        print(f"warning: {with_command(question, folder)}", file=sys.stderr)
    print(f"It can be used: {len(samples)} samples, {counted(strokes['stroke'].max(), 'stroke')}.")
    print("\n".join(following(folder, True, others_recorded(folder, run))))


if __name__ == "__main__":
    main()
