"""A new run folder: `run.yaml` from what was measured, and the recording beside it if there is one already."""

import argparse
import shlex
import sys
from pathlib import Path
from typing import Any, get_args

from .foreign.as_options import OtherForm
from .foreign.made_run import make_run
from .ground.command import command
from .ground.errors import program
from .ground.input.outputs import folder_to_write
from .ground.input.parser import Parser
from .ground.input.strict_yaml import parse_yaml
from .ground.names import checked, run_name
from .run.copied_run import as_in, with_given
from .run.description import STRING_ACTUATORS, Tare, parse_run
from .run.doubts.tolerances_given import read_back
from .run.folder import has_recording
from .run.needed_options import lacking, load_taken
from .run.next_command import following
from .run.run_arguments import run_dir
from .run.run_yaml import RunYaml
from .string.jumps_beside import advice_on
from .string.known_strings import string_id
from .string.same_string import others_recorded, tares


def arguments_to_content(arguments: argparse.Namespace) -> RunYaml:
    """The `run.yaml` that the command line asks for, without what was not given; raises BadInput for bad YAML in it."""
    string: Any = {key: getattr(arguments, key) for key in ("material", "radius_mm", "length_mm", "stiffness_n_per_mm")}
    string |= {"id": arguments.string_id, "strokes_before": arguments.strokes_before}
    rig = {key: getattr(arguments, key) for key in ("torsion_zone_mm", "separator_mm", "load_n")}
    content: RunYaml = {"run": arguments.run}
    if arguments.actuator or not arguments.like:
        content["actuator"] = arguments.actuator or STRING_ACTUATORS[0]
    sizes: Any = {key: value for key, value in string.items() if value is not None}
    content["string"] = sizes
    content["rig"] = {key: value for key, value in rig.items() if value is not None}
    if arguments.tare:
        content["tare"] = arguments.tare
    if arguments.file is not None:
        content["file"] = parse_yaml(arguments.file, Path("--file"))
    if arguments.channels is not None:
        content["channels"] = parse_yaml(arguments.channels, Path("--channels"))
    if arguments.tolerance is not None:
        content["tolerance"] = parse_yaml(arguments.tolerance, Path("--tolerance"))
    if not arguments.like:
        return content
    out = arguments.out or arguments.like.parent
    files = {"recording": arguments.recording, "out": None if out == Path("raw") else out}
    return with_given(as_in(arguments.like), content, arguments.like, files)


def with_string_id(content: RunYaml, out: Path) -> RunYaml:
    """The content with the name of a string that has a run in `out`, where a person says that it is the same."""
    run = parse_run(content, out / str(content["run"]) / "run.yaml")
    if run.string is None or run.string.id is not None:
        return content
    terminal = sys.stdin is not None and sys.stdin.isatty() and sys.stdout.isatty()
    id_ = string_id(run.string, out, run.run, input if terminal else None)
    return {**content, "string": {**(content["string"] or {}), "id": id_}} if id_ else content


@program
def main() -> None:
    """Make one run folder."""
    parser = Parser(prog=command("new_run"), usage="%(prog)s [options] run", description=__doc__)
    parser.add_argument("run", help="name of the run, as in uhmwpe-20261121-01")
    kinds = "separator (default), or twisted_pair: two strings without a separator"
    like = "a run of the same string on the same rig: takes all from its run.yaml but its tare and what is given"
    parser.add_argument("--like", type=run_dir, metavar="RUN_DIR", help=like)
    parser.add_argument("--actuator", choices=STRING_ACTUATORS, help=kinds)
    parser.add_argument("--material", metavar="NAME", help="needed without --like")
    for name in ("radius-mm", "length-mm"):
        parser.add_argument(f"--{name}", type=float, metavar="MM", help="needed without --like")
    parser.add_argument("--stiffness-n-per-mm", type=float, metavar="K", help="leave it out where nobody measured it")
    for name, meaning in (
        ("torsion-zone-mm", "length that twists; needed with a separator"),
        ("separator-mm", "how far the separator holds the strings apart; needed with a separator"),
        ("load-n", "load where no channel load_n tells it; default: 0"),
    ):
        parser.add_argument(f"--{name}", type=float, metavar=name.rsplit("-")[-1].upper(), help=meaning)
    parser.add_argument("--string-id", metavar="ID", help="name of this string, if several runs are made with it")
    parser.add_argument(
        "--strokes-before", type=int, metavar="N", help="strokes done before its first recording; default: 0"
    )
    columns = "needed are the columns time_s, motor_turns, displacement_mm, or what --channels names"
    parser.add_argument("--recording", type=Path, metavar="FILE", help=f"text, also .gz, or .parquet; {columns}")
    channels = "what is where: '{time_s: t, motor_turns: {column: a, unit: rad}}'"
    parser.add_argument("--channels", metavar="YAML", help=channels)
    parser.add_argument("--file", metavar="YAML", help="as in run.yaml: '{delimiter: \";\", header: false}'")
    parser.add_argument(
        "--tolerance",
        metavar="YAML",
        help="'{radius: 0.02, length_mm: 0.5}', radius as a share",
    )
    tare = "run: the zero was moved since the run before; checked: it was not; default: string"
    parser.add_argument("--tare", choices=get_args(Tare), metavar="HOW", help=tare)
    parser.add_argument("--sure", action="store_true", help="the recording is right, however odd it looks")
    parser.add_argument(
        "--out",
        type=Path,
        metavar="DIR",
        help="where the run's folder is made; default: raw, or beside the run it is like",
    )
    arguments = parser.parse_args()
    out = arguments.out or (arguments.like.parent if arguments.like else Path("raw"))
    checked(run_name, arguments.run, "the command line", "run")  # before a mend repeats it
    if wanting := lacking(arguments):
        parser.error(wanting)
    folder_to_write(out)
    content = with_string_id(arguments_to_content(arguments), out)
    try:
        folder = make_run(content, arguments.recording, out, arguments.sure, material_known=arguments.like is not None)
    except OtherForm as error:
        raise error.by_command(parser.typed_without(error.values)) from None
    recorded = has_recording(folder)
    run = parse_run(content, folder / "run.yaml")
    others = others_recorded(folder, run, arguments.like)
    print(f"{folder} is there{'' if recorded else '; nothing is recorded in it yet'}.")
    print("\n".join(following(folder, recorded, others)))
    print(read_back(run) + (f"\n{tares(folder, run, others)}" if others else ""))
    if arguments.recording is None and (load := load_taken(run)):
        print(load)
    if "tolerance" not in content:
        print("How well you measured its dimensions belongs into its run.yaml, as `tolerance` (docs/import.md).")
    for sentence in advice_on(folder) if recorded else []:
        print(f"{'note' if run.tare == 'checked' else 'warning'}: {sentence}", file=sys.stderr)
    effects = ", ".join(entry["id"] for entry in content.get("simulation", []))
    if effects:
        mend = f"{command('adopt')} --remove {shlex.quote(str(folder))}"
        print(f"It took over what {arguments.like} had adopted ({effects}). To take that out: {mend}")


if __name__ == "__main__":
    main()
