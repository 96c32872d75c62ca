"""What a run folder is: `raw/<run>/` with `run.yaml` and one recording; find it, read it, check it."""

import json
from collections.abc import Hashable, Iterator
from pathlib import Path
from typing import Any

import yaml

from pipeline.errors import BadInput
from pipeline.run_yaml import Run, parse_run

CAPTURED = ("recording.frames", "recording.lines")  # what the capture program writes while it runs
RECORDINGS = ("recording.frames", "recording.parquet", "recording.csv", "recording.csv.gz")


class KeyTwice(yaml.MarkedYAMLError):
    """A key that stands twice in one mapping, of which YAML would silently take the last."""


class OnceLoader(yaml.SafeLoader):
    """YAML's safe loader, which refuses a key that stands twice."""

    def construct_mapping(self, node: yaml.MappingNode, deep: bool = False) -> dict[Hashable, Any]:
        """Mapping of a node; raises KeyTwice."""
        seen = set()
        for key, _ in node.value:
            if isinstance(key, yaml.ScalarNode) and key.value in seen:
                raise KeyTwice(problem=key.value, problem_mark=key.start_mark)
            seen.add(key.value if isinstance(key, yaml.ScalarNode) else id(key))
        return super().construct_mapping(node, deep)


def read_run(folder: Path | str) -> Run:
    """Read and check `run.yaml` of a run folder; raises BadInput."""
    path = Path(folder) / "run.yaml"
    try:
        text = path.read_text(encoding="utf-8")
    except (FileNotFoundError, NotADirectoryError):
        raise BadInput(path, "run.yaml", "is missing", "write it: python -m pipeline.new_run shows how") from None
    except UnicodeDecodeError:
        raise BadInput(path, "run.yaml", "is not UTF-8 text", "save it as UTF-8") from None
    try:
        content = yaml.load(text, OnceLoader)
    except KeyTwice as error:
        place = f"line {error.problem_mark.line + 1}" if error.problem_mark else "the file"
        raise BadInput(path, place, f"says {error.problem!r} a second time", "keep one of the two") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        place = f"line {mark.line + 1}" if mark else "the file"
        raise BadInput(path, place, "is not YAML", "check its indentation, colons and quotes") from None
    return parse_run(content, path)


def recording_path(folder: Path | str) -> Path:
    """The one recording of a run folder; raises BadInput when there is none, more than one, or it is unfinished."""
    folder = Path(folder)
    if unfinished(folder):
        mend = f"wait for the capture to end, or run python -m pipeline.capture --recover {folder}"
        raise BadInput(folder, "capture.json", "is missing, so the recording is unfinished", mend)
    found = [folder / name for name in RECORDINGS if (folder / name).is_file()]
    if not found:
        raise BadInput(folder, "recording", "is missing", f"put one of {', '.join(RECORDINGS)} there")
    if len(found) > 1:
        names = " and ".join(path.name for path in found)
        raise BadInput(folder, "recording", f"is there more than once ({names})", "keep one")
    return found[0]


def unfinished(folder: Path) -> bool:
    """Whether a capture into a run folder is under way, or was cut off."""
    return any((folder / name).is_file() for name in CAPTURED) and not (folder / "capture.json").is_file()


def capture_info(folder: Path | str) -> dict[str, Any]:
    """Content of `capture.json`, or nothing for a run that the capture program did not record; raises BadInput."""
    path = Path(folder) / "capture.json"
    if not path.is_file():
        return {}
    try:
        info = json.loads(path.read_text(encoding="utf-8"))
    except ValueError:
        info = None
    if not isinstance(info, dict):
        raise BadInput(path, "capture.json", "is not what the capture program writes", "restore it, or use --recover")
    return info


def find_runs(raw: Path | str) -> Iterator[Path]:
    """Run folders under `raw/`, sorted by name: those with a `run.yaml` or a recording, hidden ones left out."""
    folders = (path for path in sorted(Path(raw).glob("[!.]*")) if path.is_dir())
    return (path for path in folders if any((path / name).is_file() for name in ("run.yaml", *CAPTURED, *RECORDINGS)))
