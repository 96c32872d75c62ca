"""How many of a thing, in words."""


def counted(count: int, what: str) -> str:
    """So many of a thing: 1 line, 2 lines."""
    return f"{count} {what}{'' if count == 1 else 's'}"


def are(count: int) -> str:
    """The verb of so many things."""
    return "is" if count == 1 else "are"
