"""The fault table of docs/faults.md: `python tests/faults/fault_table.py` plays every fault and writes it."""

import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(Path(__file__).parent)]

from bench import Bench, Row  # noqa: E402
from device_faults import FAULTS as DEVICE  # noqa: E402
from host_faults import FAULTS as HOST  # noqa: E402
from line_faults import FAULTS as LINE  # noqa: E402
from text_faults import FAULTS as TEXT  # noqa: E402

PAGE = ROOT / "docs" / "faults.md"
FAULTS: dict[str, Callable[[Bench], Row]] = LINE | HOST | DEVICE | TEXT
HEAD = """# What goes wrong, and what the capture says

Each line is a test of `tests/faults/` in which the real program records a scripted rig over a pseudo-terminal: 66
frames (60 samples at 50 Hz, two strokes) unless said otherwise. Written from the tests' results by
`python tests/faults/fault_table.py`; `tests/faults/test_faults.py` fails when a line is not what its test gives.
In every one the recording holds exactly the bytes that were read, each sample in it is the one that was sent, and
frames sent = received + lost. How long it bears 5 kHz is measured by `benchmarks/load.py`; `benchmarks/fuzz_decoder.py`
looks for bytes that it cannot bear. Rigs that print text print 60 lines of numbers; every byte of them is kept, and
what is read of them stands in recording.csv.

| fault | what arrived | what was reported | what was lost |
|---|---|---|---|
"""


def play(fault: Callable[[Bench], Row]) -> Row:
    """Play one fault in a folder of its own, which others may read."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        bench = Bench(Path(folder))
        try:
            return fault(bench)
        finally:
            bench.close()


def line(name: str, row: Row) -> str:
    """A line of the table."""
    cells = (name, row.arrived, row.reported, row.lost)
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |\n"


def parts(text: str) -> tuple[str, str]:
    """The page's part that is written here, and the rest, which is not."""
    table, mark, rest = text.partition("\n## ")
    return table, mark + rest


if __name__ == "__main__":
    table = HEAD + "".join(line(name, play(fault)) for name, fault in FAULTS.items())
    PAGE.write_text(table + parts(PAGE.read_text())[1])
