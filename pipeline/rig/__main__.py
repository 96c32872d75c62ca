"""Serve one recording of a synthetic rig over a pseudo-terminal, as fast as the host reads it."""

import argparse
import math
import sys
from pathlib import Path

from pipeline.errors import program
from pipeline.rig.device import Device
from pipeline.rig.line import line, serve
from pipeline.rig.setup import names, read_setup
from pipeline.rig.simulate import simulate


@program
def main() -> int:
    """Make the link, then serve; exit 1 when nobody acknowledges the recording."""
    parser = argparse.ArgumentParser(prog="python -m pipeline.rig", description=__doc__)
    parser.add_argument("setup", metavar="SETUP", help=f"a YAML file, or one of {', '.join(names())}")
    parser.add_argument("--link", type=Path, required=True, help="name of the serial port that is made")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--pace", type=float, default=math.inf, help="times real time (default: as fast as it goes)")
    arguments = parser.parse_args()
    if arguments.seed < 0 or not arguments.pace > 0:
        parser.error("--seed must be 0 or more, --pace above 0")
    device = Device(simulate(read_setup(arguments.setup), arguments.seed))
    with line(arguments.link) as end:
        print(f"rig: {arguments.setup} is at {arguments.link}", flush=True)
        try:
            served = serve(end, device, arguments.pace)
        except KeyboardInterrupt:
            return 130
    if not served:
        print("rig: the host did not acknowledge the end of the recording", file=sys.stderr)
    return 0 if served else 1


if __name__ == "__main__":
    main()
