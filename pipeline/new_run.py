"""A new run folder: `run.yaml` from what was measured, and the recording beside it if there is one already."""

import argparse
import os
import shutil
from pathlib import Path
from typing import Any

import yaml

from pipeline.errors import BadInput, program
from pipeline.files import write_text
from pipeline.run_yaml import STRING_ACTUATORS, parse_run
from pipeline.runs import RECORDINGS


def make_run(content: dict[str, Any], recording: Path | None, out: Path) -> Path:
    """Write `out/<run>/run.yaml`, checked, with a copy of the recording; whole or not at all. Raises BadInput."""
    folder = out / str(content["run"])
    parse_run(content, folder / "run.yaml")
    if (folder / "run.yaml").exists() or (folder.exists() and recording is not None):
        raise BadInput(folder, "run", "is there already", "choose another name; runs are never overwritten")
    text = yaml.safe_dump(content, sort_keys=False, allow_unicode=True)
    if folder.exists():  # recorded before it was described
        write_text(folder / "run.yaml", text)
        return folder
    suffix = "".join(recording.suffixes[-2:]) if recording and recording.suffix == ".gz" else ""
    name = f"recording{suffix or (recording.suffix if recording else '')}"
    if recording is not None and (not recording.is_file() or name not in RECORDINGS[1:]):
        mend = f"give a file that ends like {', '.join(RECORDINGS[1:])}, or use python -m pipeline.import_run"
        raise BadInput(recording, "--recording", "is not there or not of a known kind", mend)
    temporary = folder.with_name(f".{folder.name}.{os.getpid()}")
    try:
        temporary.mkdir(parents=True)
        (temporary / "run.yaml").write_text(text, encoding="utf-8")
        if recording is not None:
            shutil.copyfile(recording, temporary / name)
        os.rename(temporary, folder)
    finally:
        shutil.rmtree(temporary, ignore_errors=True)
    return folder


def arguments_to_content(arguments: argparse.Namespace) -> dict[str, Any]:
    """The `run.yaml` that the command line asks for, without what was not given."""
    string = {key: getattr(arguments, key) for key in ("material", "radius_mm", "length_mm", "stiffness_n_per_mm")}
    string |= {"id": arguments.string_id, "strokes_before": arguments.strokes_before}
    rig = {key: getattr(arguments, key) for key in ("torsion_zone_mm", "separator_mm", "load_n")}
    content: dict[str, Any] = {"run": arguments.run, "actuator": arguments.actuator}
    content["string"] = {key: value for key, value in string.items() if value is not None}
    content["rig"] = {key: value for key, value in rig.items() if value is not None}
    return content


@program
def main() -> None:
    """Make one run folder."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("run", help="name of the run, as in uhmwpe-20261121-01")
    parser.add_argument("--actuator", choices=STRING_ACTUATORS, default="separator")
    parser.add_argument("--material", required=True)
    for name in ("radius-mm", "length-mm", "stiffness-n-per-mm"):
        parser.add_argument(f"--{name}", type=float, required=True)
    for name in ("torsion-zone-mm", "separator-mm", "load-n"):
        parser.add_argument(f"--{name}", type=float)
    parser.add_argument("--string-id", help="name of this very string, if more than one run is made with it")
    parser.add_argument("--strokes-before", type=int)
    parser.add_argument("--recording", type=Path, help="a .csv, .csv.gz or .parquet with the contract's channels")
    parser.add_argument("--out", type=Path, default=Path("raw"))
    arguments = parser.parse_args()
    folder = make_run(arguments_to_content(arguments), arguments.recording, arguments.out)
    recorded = any((folder / name).exists() for name in RECORDINGS)
    following = "snakemake --cores 2" if recorded else f"python -m pipeline.capture PORT {folder}"
    print(f"{folder} is there; {'make its reports' if recorded else 'record into it'} with: {following}")


if __name__ == "__main__":
    main()
