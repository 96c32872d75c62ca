"""How a person starts a program of ours: in a checkout by `python -m pipeline.diagnose`, installed by its name."""

import shlex
from pathlib import Path

HOUSE = __package__.partition(".")[0]  # `pipeline` in a checkout, `twistbench` where it is installed
INSTALLED = HOUSE != "pipeline"
START = f"{HOUSE} " if INSTALLED else f"python -m {HOUSE}."  # of every command that a person is told to type
REMAKE = (
    f"make it again: {HOUSE} dataset" if INSTALLED else "run snakemake: it is made again"
)  # the workflow is in the checkout alone


def program_name(program: str) -> str:
    """The name of a program such as `new_run` in a sentence: pipeline.new_run, or installed twistbench new-run."""
    return f"{HOUSE} {program.replace('_', '-')}" if INSTALLED else f"{HOUSE}.{program}"


def command(program: str) -> str:
    """The command that starts a program, such as `new_run`, or `rig.record`, which has no short name."""
    return program_name(program) if INSTALLED and "." not in program else f"python -m {HOUSE}.{program}"


def recover_command(folder: Path) -> str:
    """The command that makes a recording usable, or reads its lines again."""
    return f"{command('capture')} --recover {shlex.quote(str(folder))}"


def make_command(file: Path) -> str:
    """The command that makes one file of the main job in a checkout; empty in an installation."""
    return "" if INSTALLED else f"snakemake --cores 2 -- {shlex.quote(str(file))}"


def quoted(text: str) -> str:
    """A word of a command line in quotes: double ones if it has single ones, and nothing that a shell interprets."""
    return f'"{text}"' if "'" in text and not set(text) & set('"$`\\!') else shlex.quote(text)
