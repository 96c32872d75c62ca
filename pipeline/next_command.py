"""The command that comes next for a run folder that was just made."""

from pathlib import Path


def following(folder: Path, recorded: bool) -> str:
    """What is done next with a run folder: the main job finds runs in raw/ alone."""
    if not recorded:
        command = f"python -m pipeline.capture PORT {folder}"
        return f"record into it with: {command} (add --text where the rig prints lines of numbers)"
    if folder.parent.resolve() == Path("raw").resolve():
        return "make its reports with: snakemake --cores 2"
    return f"snakemake reads raw/ alone: diagnose it by python -m pipeline.diagnose {folder} --out reports/diagnosis"
