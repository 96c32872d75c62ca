"""The strokes that a page shows: the paper's if the material has them, else strokes spread over its own."""

from collections.abc import Iterable, Sequence

from ...ground.words.counts import consecutive

SHOWN = "Shown "


def there_of(strokes: Iterable[str | int]) -> list[int]:
    """The strokes that a column of metrics or points names, in order."""
    return sorted({int(stroke) for stroke in strokes if stroke != "all"})


def drawn(strokes: Sequence[int], wanted: Sequence[int]) -> list[int]:
    """The wanted strokes if all exist; else as many, spread from the first to the last."""
    if len(strokes) <= len(wanted):
        return list(strokes)
    if set(wanted) <= set(strokes):
        return list(wanted)
    last = len(strokes) - 1
    return sorted({strokes[round(place * last / (len(wanted) - 1))] for place in range(len(wanted))})


def tabled(strokes: Sequence[int], wanted: Sequence[int]) -> list[int]:
    """The wanted strokes that exist; if none does, strokes spread from the first to the last."""
    return [stroke for stroke in wanted if stroke in strokes] or drawn(strokes, wanted)


def tabled_and_last(strokes: Sequence[int], wanted: Sequence[int], most: int) -> list[int]:
    """All strokes if there are at most `most`; else those of a table, and the last."""
    return list(strokes) if len(strokes) <= most else sorted({*tabled(strokes, wanted), strokes[-1]})


def ranges(strokes: Sequence[int]) -> str:
    """The strokes in words: "1 to 8", "1 to 4 and 9"."""
    return listed([f"{run[0]} to {run[-1]}" if len(run) > 1 else f"{run[0]}" for run in consecutive(strokes)])


def listed(names: Sequence[str | int]) -> str:
    """Names in a sentence: "1", "1 and 5", "1, 5 and 9"; "none" of nothing."""
    *first, last = map(str, names or ["none"])
    return f"{', '.join(first)} and {last}" if first else last


def rows_of(material: str) -> str:
    """The file with the numbers of every stroke of a material."""
    return f"processed/{material}/metrics.parquet"


def shown_of(strokes: Sequence[int], wanted: Sequence[int], material: str) -> str:
    """A sentence on which of the material's strokes a table shows, and where all are.

    The paper's are named where one of them is not there.

    Empty where the table shows all strokes, the paper's among them. The file that it names is the one that the table
    was made of, so it is there wherever the table is.
    """
    rows = tabled(strokes, wanted)
    if not strokes or (len(rows) >= len(strokes) and set(wanted) <= set(strokes)):
        return ""
    are = f"{SHOWN}{'are strokes' if len(rows) > 1 else 'is stroke'} {listed(rows)}"
    papers = "" if set(wanted) <= set(strokes) else f" (the paper has {listed(wanted)})"
    if len(rows) >= len(strokes):
        return f"{are}, all that there are{papers}."
    return f"{are} of {ranges(strokes)}{papers}. All strokes are rows of {rows_of(material)}, column stroke."


def in_figure(strokes: Sequence[int], shown: Sequence[int], wanted: Sequence[int]) -> str:
    """A sentence on which strokes a figure shows, and which `wanted` ones the tables show; empty for none."""
    if not shown:
        return ""
    of_all = ", all that there are" if len(shown) == len(strokes) else f" of {ranges(strokes)}"
    rows = tabled(strokes, wanted)
    beside = "as in the tables" if list(shown) == rows else f"the tables show {_numbers(rows)}"
    return f"n is the number of the stroke. Shown: {_numbers(shown)}{of_all}; {beside}."


def _numbers(strokes: Sequence[int]) -> str:
    return f"n={', '.join(map(str, strokes))}"
