"""How many of a thing, and which, in words."""

from collections.abc import Iterable, Mapping, Sequence


def counted(count: int, what: str) -> str:
    """A count with its noun: 1 line, 2 lines."""
    return f"{count} {what}{'' if count == 1 else 's'}"


def are(count: int) -> str:
    """The verb for a count: is, or are."""
    return "is" if count == 1 else "are"


def listing(words: Sequence[str], last: str = "and") -> str:
    """Words as a list: a; a and b; a, b and c."""
    if len(words) < 2:
        return "".join(words)
    return f"{', '.join(words[:-1])} {last} {words[-1]}"


def consecutive(numbers: Iterable[int]) -> list[list[int]]:
    """Rising numbers in groups of consecutive ones: [1, 2, 3], [5]."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    return runs


def mends(times_by_rule: Mapping[str, int]) -> list[str]:
    """How often each rule that mends time stamps was needed: 1 repeated time stamp, 2 backward time stamps."""
    return [counted(times, rule.replace("_", " ").removesuffix("s")) for rule, times in times_by_rule.items()]
