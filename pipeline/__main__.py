"""The command `twistbench`: its first word names a program, which is imported then and told the words after it."""

import argparse
import importlib
import sys

from . import __version__
from .ground.command import HOUSE, INSTALLED, command
from .ground.errors import BadInput, program

PROGRAMS = {  # in the order of the work
    "new-run": "make a run folder: what was measured, and the recording if there is one",
    "import-run": "make a run folder of a file of another program",
    "capture": "record a rig at a serial port",
    "watch": "show a recording on a page of this machine while it grows",
    "rig": "be a synthetic rig behind a pseudo-terminal",
    "diagnose": "say where simulation and recording differ, and which physics is missing",
    "settle": "make the runs that decide what a diagnosis left open, one after the other",
    "simulate": "write what the simulator alone gives, improved by a diagnosis or not",
    "mend": "set a value of a run's run.yaml that a message names, or exchange two columns",
    "adopt": "put what a diagnosis found into a run's simulator, or take it out",
    "lifespan": "foretell how many strokes a string has left",
    "dataset": "put the points of runs of one material together, for fit-model and predict",
    "fit-model": "fit a model to a dataset, and save it for export",
    "predict": "answer questions by a model, with intervals",
    "export": "write a fitted model as a C header or as ONNX graphs",
}


@program
def main() -> None:
    """Run the program that the first word names; Raises BadInput for a word that names none."""
    listed = "\n".join(f"  {name:<12}{what}" for name, what in PROGRAMS.items())
    parser = argparse.ArgumentParser(
        prog=HOUSE if INSTALLED else f"python -m {HOUSE}",
        usage="%(prog)s PROGRAM …",
        description="A bench for twisted string actuators.",
        epilog=f"programs, each of which explains itself with --help:\n{listed}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=f"twistbench {__version__}")
    parser.add_argument("program", metavar="PROGRAM", help="one of the programs below; what follows is told to it")
    name: str = parser.parse_args(sys.argv[1:2]).program.replace("_", "-")
    if name not in PROGRAMS:
        raise BadInput("arguments", name, "is no program", f"use one of {', '.join(PROGRAMS)}")
    module = name.replace("-", "_")
    module_found = importlib.import_module(f"{__package__}.{module}")
    if hasattr(module_found, "__path__"):
        module_found = importlib.import_module(f"{module_found.__name__}.__main__")
    sys.argv = [command(module), *sys.argv[2:]]
    program(module_found.main)()


if __name__ == "__main__":
    main()
