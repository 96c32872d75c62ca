"""Which mark the page of a material or a run wears: that of what made its own numbers, not of all reports.

A diagnosis is made with no setting of a configuration: the page of a run has a mark only where the synthetic rig that
a configuration sets up recorded it.
"""

import argparse
import json
from collections.abc import Collection
from dataclasses import dataclass

from ..ground.errors import BadInput
from ..ground.names import SYNTHETIC
from .made_by import MadeBy, unpacked

KEYS = ("material", "synthetic", "rig")


@dataclass(frozen=True)
class PartMarks:
    """The marks of the pages: `material` of any, `synthetic` of the synthetic rig's, `rig` of its runs, `rigs`."""

    material: MadeBy
    synthetic: MadeBy
    rig: MadeBy | None
    rigs: Collection[str] = ()

    def of(self, kind: str, name: str) -> MadeBy | None:
        """The mark of a part's page; None where no configuration had a hand in it."""
        if kind == "material":
            return self.synthetic if name == SYNTHETIC else self.material
        return self.rig if name in self.rigs else None


def add_part_marks(parser: argparse.ArgumentParser) -> None:
    """Let a program be told the marks of its parts."""
    keys = ", ".join(KEYS)
    parser.add_argument("--part-marks", metavar="JSON", help=f"marks of the pages of parts: {keys}; default: as above")


def part_marks(text: str | None, whole: MadeBy, rigs: Collection[str]) -> PartMarks:
    """The marks of a command line, all like the `whole` where none were given; raises BadInput for what is none."""
    if text is None:
        return PartMarks(whole, whole, whole, rigs)
    try:
        material, synthetic, rig = (unpacked(json.dumps(json.loads(text)[key])) for key in KEYS)
    except (ValueError, TypeError, KeyError) as error:
        mend = "leave it out, or let the workflow give it"
        raise BadInput("arguments", "--part-marks", f"holds no marks ({error})", mend) from None
    return PartMarks(material, synthetic, rig if rig.rig else None, rigs)
