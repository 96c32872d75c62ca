"""Export a fitted model: a C99 header without dependencies, or two ONNX graphs."""

import argparse
import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..ground.command import command, program_name
from ..ground.errors import BadInput, program
from ..ground.input.outputs import file_to_write, folder_to_write
from ..ground.input.parser import Parser
from ..ground.stored.files import whole, write_text
from ..models.interface import about
from ..models.parts.divided import SPLITS
from ..models.parts.newer_recordings import beware_of_newer
from ..models.parts.saved_files import MODEL_FILE, dataset_beside, listed
from . import closing_words
from .all_points import fitted_to_all
from .asked_saved import model_of
from .c_header import header
from .interface import Source, names
from .source import Beside, opened, strings_apart

FORMATS = {"c": "the header's first comment", "onnx": "the graphs' metadata"}  # where an export has its remarks
TWO = "If one program uses two exports, give the second one its own --name."
REST = "Its zero, its runs, and what was recorded stand in {}."
MOST_STRINGS = 20  # that are exported where none is named
LONGEST = 31  # characters of a name's beginning, which C compilers must tell apart


def arguments(words: list[str]) -> argparse.Namespace:
    """The command line."""
    parser = Parser(prog=command("export"), description=__doc__)
    parser.ending = listed(names())
    parser.add_argument("file", type=Path, metavar="MODEL", help=MODEL_FILE)
    both = "may be given twice: both are made then"
    parser.add_argument("--format", required=True, choices=FORMATS, action="append", help=both)
    parser.add_argument(
        "--out",
        metavar="PATH",
        help="the header's file, which has a suffix such as .h, or the folder of header or graphs, which may be new; "
        "default: reports/<material>/<model>, or, of a model that lies elsewhere, its own folder",
    )
    parser.add_argument(
        "--name",
        default="tsa",
        help="what every name in the export begins with; default: %(default)s. If one program uses two exports, give "
        "the second one its own",
    )
    parser.add_argument("--model", help="the model's name; otherwise its folder's")
    parser.add_argument("--dataset", type=Path, help="for models that keep no ranges; otherwise the one beside them")
    parser.add_argument("--split", choices=SPLITS, help="whose training points give the ranges; otherwise the file's")
    anew = f"fit it anew to all points, and export that: the answers of {program_name('predict')} without --saved"
    parser.add_argument("--all-points", action="store_true", help=anew)
    of_string = (
        "one string alone: a calibrated model has numbers for each, and writes all of them, each in its folder, if "
        "none is named; another model is fitted anew to that string, with --all-points"
    )
    parser.add_argument("--string", help=of_string)
    options = parser.parse_args(words)
    options.format = [form for form in FORMATS if form in options.format]
    return options


def usual_folder(file: Path) -> Path:
    """The place of an export without one: in the reports of the model's material, else beside the model."""
    folder = Path(os.path.abspath(file)).parent
    if folder.parents[1:2] and folder.parents[1].name == "processed":
        folder = folder.parents[1].parent / "reports" / folder.parent.name / folder.name
    return Path(os.path.relpath(folder)) if folder.is_relative_to(Path.cwd()) else folder


HEADERS = (".h", ".c")  # what an existing file must end in to be replaced


@contextmanager
def writable(file: Path) -> Iterator[None]:
    """Raise BadInput for a model that loads and answers, but has content that cannot be exported."""
    try:
        yield
    except (ArithmeticError, ValueError, LookupError, TypeError, AttributeError) as error:
        problem = f"cannot be exported ({type(error).__name__}: {error})"
        raise BadInput(file, "model", problem, "train it again; should that not help, report it") from error


def _names_a_folder(out: str) -> bool:
    """Whether a path is a folder, or, where nothing is there, reads like one: it ends in a slash or has no suffix."""
    path = Path(out)
    return path.is_dir() or out.endswith(("/", os.sep)) or (bool(out) and not path.suffix and not path.exists())


def _header_to_write(out: Path, reads: list[Path]) -> None:
    """Raise BadInput where no header can be written, or where it would replace a file of another kind."""
    file_to_write(out, reads=reads)
    if out.exists() and out.suffix not in HEADERS:
        mend = f"name a file that ends in {' or '.join(HEADERS)}, or one that is not there"
        raise BadInput("--out", str(out), "is there and no header", mend)


def main() -> None:
    """Export."""
    options = arguments(sys.argv[1:])
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", options.name):
        raise BadInput("--name", options.name, "cannot begin a C name", "use letters, digits and _")
    if len(options.name) > LONGEST:
        raise BadInput(
            "--name", f"{options.name[:40]}…", f"has {len(options.name)} characters", f"use at most {LONGEST}"
        )
    is_folder = options.out is None or _names_a_folder(options.out)
    usual = usual_folder(options.file) / (options.string or "")
    options.out = usual if options.out is None else Path(options.out)
    if options.string and not options.all_points and _is_of_all(options.file, options.model):
        mend = "add --all-points: the model is then fitted anew to that string alone"
        raise BadInput("--string", options.string, "is no part of a model of all strings together", mend)
    strings = strings_apart(options.file, options.model) if options.string is None and is_folder else []
    if len(strings) > MOST_STRINGS:
        problem = f"it keeps {len(strings)} apart"
        raise BadInput(options.file, "string", problem, f"say --string with one of {', '.join(strings)}")
    places = [(string, options.out / string) for string in strings] if len(strings) > 1 else []
    if beware := beware_of_newer(options.dataset or dataset_beside(options.file)):
        print(beware, file=sys.stderr)
    for string, out in places or [(options.string, options.out)]:
        lines = _exported(options, out, is_folder, string)
        print("\n".join([f"{string}:", *lines] if places else lines))
    if places:
        print(f"Each of the {len(places)} strings has an export of its own; --string makes one alone.")
    if "c" in options.format:
        print(f"All of its names begin with {options.name}_. {TWO}")
    print(REST.format(" and in ".join(FORMATS[form] for form in options.format)))


def _is_of_all(file: Path, name: str | None) -> bool:
    """Whether a file's model has no numbers of its own for each string."""
    name = name or model_of(file)
    return name in names() and not about(name).each_string_apart


def _exported(options: argparse.Namespace, out: Path, is_folder: bool, string: str | None) -> list[str]:
    """Write the exports of one string, or of all, into a folder or as a header; returns lines that tell their content.

    All is computed before anything is written: a model that has no graphs leaves no header.
    """
    beside = Beside(options.dataset, options.split, string)
    if "onnx" in options.format:
        if "c" in options.format and not is_folder:
            raise BadInput(
                "--out", str(out), "is a file, and graphs lie in a folder", "name a folder, which may be new"
            )
        folder_to_write(out)
    if "c" in options.format:
        header_file = folder_to_write(out) / f"{options.name}.h" if is_folder else out
        _header_to_write(header_file, [options.file, *([options.dataset] if options.dataset else [])])
    file = fitted_to_all(options.file, options.model, beside) if options.all_points else options.file
    source = opened(file, options.model, beside)
    same = closing_words.in_python(source, file)
    graph_by_way = _graphs(source, options.name, file) if "onnx" in options.format else {}
    lines, tried = [], []
    if "c" in options.format:
        with writable(file):
            text = header(source, options.name)
        write_text(header_file, text)
        tried = closing_words.compiled(header_file, options.name)
        lines.append(f"{header_file}: {header_file.stat().st_size} bytes of text")
    for way, (graph, columns) in graph_by_way.items():
        path = out / f"{options.name}.{way}.onnx"
        with whole(path) as temporary:
            temporary.write_bytes(graph)
        lines.append(f"{path}: {path.stat().st_size} bytes. {columns}")
    return [*lines, *closing_words.lines(source), *tried, same]


def _graphs(source: Source, name: str, file: Path) -> dict[str, tuple[bytes, str]]:
    """The graph of each way, and its columns in words."""
    from .onnx_model import GIVEN, graphs  # a header needs no onnx

    with writable(file):
        graph_by_way = graphs(source, name)
    return {
        way: (graph.SerializeToString(), closing_words.columns(source, GIVEN[way]))
        for way, graph in graph_by_way.items()
    }


if __name__ == "__main__":
    program(main)()
