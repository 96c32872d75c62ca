"""The command that comes next for a run folder that was just made or recorded."""

import shlex
from collections.abc import Sequence
from pathlib import Path

from ..ground.command import INSTALLED, command

MAIN = "snakemake --cores 2"
QUICK = "quick, with small fits that are no results: snakemake --cores 2 --configfile pipeline/config/ci.yaml -- tables"


def following(folder: Path, recorded: bool, others: Sequence[Path] = ()) -> str:
    """What is done next with a run folder: the main job, which is in the checkout, finds runs in raw/ alone.

    A run is diagnosed together with the `others` of the same string, so that what is learnt holds for all of them.
    """
    diagnose = f"{command('diagnose')} {' '.join(shlex.quote(str(run)) for run in (*others, folder))}"
    if others:
        diagnose = f"{diagnose} --together --out {shlex.quote(str(Path('reports/mine') / folder.name))}"
    else:
        diagnose = f"{diagnose} --out reports/mine"
    alone = f"or ask only what the simulator leaves out: {diagnose}"
    in_raw = not INSTALLED and folder.parent.resolve() == Path("raw").resolve()
    if not recorded:
        capture = f"{command('capture')} PORT {shlex.quote(str(folder))}"
        then = f"then make its reports with: {MAIN} ({QUICK}), {alone}" if in_raw else f"then diagnose it by {diagnose}"
        return f"record into it with: {capture} (add --text where the rig prints lines of numbers); {then}"
    if in_raw:
        return f"make its reports with: {MAIN} ({QUICK}), {alone}"
    return f"diagnose it by {diagnose}" if INSTALLED else f"snakemake reads raw/ alone: diagnose it by {diagnose}"
