"""What the launcher says to the person who waits."""

import sys


def say(text: str) -> None:
    """One line on the error channel, so that a command's own output stays clean."""
    print(f"env: {text}", file=sys.stderr, flush=True)
