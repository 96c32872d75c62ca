"""The commands that come next for a run folder that was just made or recorded."""

import shlex
from collections.abc import Sequence
from pathlib import Path

from ..ground.command import INSTALLED, command
from .folder import read_run

MAIN = "snakemake --cores 2"


def quick(material: str) -> str:
    """A line with the command that makes a material's reports in minutes, as the README has it."""
    command_line = f"{MAIN} --configfile pipeline/config/ci.yaml -- reports/{material}/index.html"
    return f"  quick, small fits that are no results: {command_line}"


def following(folder: Path, recorded: bool, others: Sequence[Path] = ()) -> list[str]:
    """What is done next with a run folder, a line each: the main job, of a checkout, finds runs in raw/ alone.

    A run is diagnosed together with the `others` of the same string, so that what is learnt holds for all of them.
    """
    diagnose = f"{command('diagnose')} {' '.join(shlex.quote(str(run)) for run in (*others, folder))}"
    if others:
        diagnose = f"{diagnose} --together --out {shlex.quote(str(Path('reports/mine') / folder.name))}"
    else:
        diagnose = f"{diagnose} --out reports/mine"
    if not INSTALLED and folder.parent.resolve() == Path("raw").resolve():
        string = read_run(folder).string
        small = [quick(string.material)] if string else []
        reports = [f"make its reports: {MAIN}", *small, f"  or ask only what the simulator leaves out: {diagnose}"]
    else:
        reports = [f"diagnose it{'' if INSTALLED else ', as snakemake reads raw/ alone'}: {diagnose}"]
        if read_run(folder).string:
            runs = " ".join(shlex.quote(str(run)) for run in (*others, folder))
            reports.append(f"  or put its points together, for models: {command('dataset')} {runs}")
    if recorded:
        return [f"Next: {reports[0]}", *reports[1:]]
    capture = f"{command('capture')} PORT {shlex.quote(str(folder))}"
    text = "  (add --text where the rig prints lines of numbers)"
    return [f"Next: record into it: {capture}", text, f"Then: {reports[0]}", *reports[1:]]
