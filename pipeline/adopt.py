"""Adopt a diagnosis: its `simulation` goes into a run's `run.yaml`, and the other text of that file stays as it is."""

import argparse
import json
import shutil
import sys
import textwrap
from pathlib import Path
from typing import Any

import yaml

from pipeline import adopted_error
from pipeline.complaint import short
from pipeline.diagnosis.adopt import adoptions, block, checked
from pipeline.diagnosis.engine import at_own_rate
from pipeline.diagnosis.words.quantity import listing
from pipeline.errors import BadInput, program
from pipeline.files import whole
from pipeline.ingest import read_samples
from pipeline.regular_file import read_regular
from pipeline.run_yaml import parse_run
from pipeline.runs import RECORDINGS, read_run
from pipeline.simulate import read_diagnosis
from pipeline.strict_yaml import LARGEST, parse_yaml

KEY, ORIGIN = "simulation", "adopted"


def with_block(text: str, entries: list[dict[str, Any]], named: str = KEY) -> str:
    """Text of a `run.yaml` with the key `named` replaced, or added after the last key; all other text is kept.

    `text` must be one mapping of YAML; whether the result says what it should is for the caller to check.
    """
    root: Any = yaml.compose(text, Loader=yaml.SafeLoader)
    there = next(((key, value) for key, value in root.value if key.value == named), None)
    if root.flow_style:  # a run.yaml written as JSON
        said = json.dumps(entries, ensure_ascii=False)
        if there:
            return text[: there[1].start_mark.index] + said + text[there[1].end_mark.index :]
        first = root.start_mark.index + 1
        return f'{text[:first]}"{named}": {said}, {text[first:]}'
    newline = "\r\n" if "\r\n" in text else "\n"
    indent = " " * root.value[0][0].start_mark.column
    lines = textwrap.indent(block(entries, named).rstrip("\n"), indent).replace("\n", newline)
    if there:
        return text[: there[0].start_mark.index] + lines.lstrip() + text[_end(there[1]) :]
    end = _end(root.value[-1][1])
    if not text[:end].endswith("\n"):
        end = text.find("\n", end) + 1 or len(text)
    before = text[:end] if text[:end].endswith("\n") else text[:end] + newline
    return before + lines + newline + text[end:]


def _end(node: yaml.Node) -> int:
    """Where the text of a node ends, without the comments and empty lines after it."""
    if isinstance(node, yaml.CollectionNode) and not node.flow_style and node.value:
        last = node.value[-1]
        return _end(last[1] if isinstance(last, tuple) else last)
    return int(node.end_mark.index)


def adopted(text: str, entries: list[dict[str, Any]], path: Path, origin: list[dict[str, Any]] | None = None) -> str:
    """The text with the entries, parsed to see that it says just that and else what it said; raises BadInput.

    `origin` is where they came from, as the run.yaml shall say it; an empty one replaces an older one only.
    """
    there = parse_yaml(text, path)
    keep = origin or (origin is not None and ORIGIN in there)
    wanted = {**there, KEY: entries, **({ORIGIN: origin} if keep else {})}
    try:
        made = with_block(text, entries)
        made = with_block(made, origin or [], ORIGIN) if keep else made
        right = parse_yaml(made, path) == wanted
    except (BadInput, yaml.YAMLError):
        right = False
    if not right:
        mend = f"put the block of simulation.yaml beside the diagnosis in its place by hand, under the key {KEY}"
        raise BadInput(path, KEY, "stands where it cannot be replaced without changing other text", mend)
    parse_run(wanted, path)
    return made


def check(content: dict[str, Any], source: Path, folder: Path) -> list[str]:
    """How far the simulator is off the run's recording, in words; one without a recording takes any known names.

    Raises BadInput unless what a diagnosis names can act in the run.
    """
    for number, entry in enumerate(content[KEY]):
        checked(entry, f"{KEY}[{number}]", str(source))
    if not any((folder / name).exists() for name in RECORDINGS):
        return []
    run, samples = read_samples(folder)
    bare = at_own_rate([run.model_copy(update={KEY: []})], [samples], thin=run.system.differentiates)
    return adopted_error.told(bare, run.run, run.simulation, content, source)


@program
def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.adopt", description=__doc__)
    parser.add_argument("diagnosis", type=Path, help="a diagnosis.json")
    parser.add_argument("run_dir", type=Path, help="the run whose run.yaml takes it over")
    arguments = parser.parse_args()
    source, folder = arguments.diagnosis, arguments.run_dir
    run, content = read_run(folder), read_diagnosis(source)
    path = (folder / "run.yaml").resolve()
    names = listing(list(dict.fromkeys(str(entry.get("id")) for entry in content[KEY] if isinstance(entry, dict))))
    if not content[KEY]:
        print(f"{source} names no mechanism: there is nothing to adopt, and {folder / 'run.yaml'} stays as it is")
        return
    errors = check(content, source, folder)
    if not adopted_error.is_of(content, run.run):
        said = f"{source} is of {short(content['run'])}: what it names holds for the same string on the same rig only"
        print(f"beware: {said}", file=sys.stderr)
    origin = adoptions(content, str(source))
    text = read_regular(path, LARGEST, "run.yaml").decode("utf-8")
    made = adopted(text, content[KEY], path, origin)
    if parse_yaml(made, path) == parse_yaml(text, path):
        print(f"{folder / 'run.yaml'} holds {names} already, as {source} gives them; it stays as it is")
        return
    with whole(path) as temporary:
        temporary.write_text(made, encoding="utf-8", newline="")
        shutil.copymode(path, temporary)
    print(f"{folder / 'run.yaml'}: {KEY} holds {names} now; all else in it stays as it was")
    others = origin[-1]["tied"] if origin else []
    if others:
        print(f"{len(others)} other explanation{'s' * (len(others) > 1)} tied with it: {ORIGIN} in run.yaml names them")
    for line in (*errors, adopted_error.WHY, adopted_error.NEXT):
        print(line)


if __name__ == "__main__":
    main()
