"""What a verdict says first: all lines up to the first empty one, which hold its warnings too."""

MOST = 2000  # letters that are shown of it


def headline(text: str) -> str:
    """The words of `verdict.txt` up to its first empty line, on one line; empty where it has none."""
    return " ".join(text.partition("\n\n")[0].split())[:MOST]
