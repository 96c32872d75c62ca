"""How a person starts a program of ours: a checkout's by `python -m pipeline.diagnose`, an installed one's by name."""

import shlex
from pathlib import Path

HOUSE = __package__.partition(".")[0]  # `pipeline` in a checkout, `twistbench` where it is installed
INSTALLED = HOUSE != "pipeline"
START = f"{HOUSE} " if INSTALLED else f"python -m {HOUSE}."  # of every command that a person is told to type
REMAKE = "make it again" if INSTALLED else "run snakemake: it is made again"  # the workflow is in the checkout alone


def program_name(program: str) -> str:
    """What a sentence calls a program, such as `new_run`: pipeline.new_run, or installed twistbench new-run."""
    return f"{HOUSE} {program.replace('_', '-')}" if INSTALLED else f"{HOUSE}.{program}"


def command(program: str) -> str:
    """What a person types to start a program, such as `new_run`, or `rig.record`, which has no short name."""
    return program_name(program) if INSTALLED and "." not in program else f"python -m {HOUSE}.{program}"


def recover_command(folder: Path) -> str:
    """What a person types to make a recording usable, or to read its lines again."""
    return f"{command('capture')} --recover {shlex.quote(str(folder))}"


def make_command(file: Path) -> str:
    """What a person types in a checkout to make one file of the main job; empty where it is installed."""
    return "" if INSTALLED else f"snakemake --cores 2 -- {shlex.quote(str(file))}"


def quoted(text: str) -> str:
    """A word of a command line in quotes, in double ones where it has single ones and nothing that a shell reads."""
    return f'"{text}"' if "'" in text and not set(text) & set('"$`\\!') else shlex.quote(text)
