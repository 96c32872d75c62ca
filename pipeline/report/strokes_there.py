"""Which strokes a page shows: the paper's where the material has them, else strokes spread over those that it has."""

from collections.abc import Iterable, Sequence

NOT_SHOWN = "Not shown"
SHOWN = "Shown are"


def there_of(strokes: Iterable[str | int]) -> list[int]:
    """The strokes that a column of metrics or points names, in order."""
    return sorted({int(stroke) for stroke in strokes if stroke != "all"})


def drawn(strokes: Sequence[int], wanted: Sequence[int]) -> list[int]:
    """The wanted strokes where all are there; else as many, from the first to the last that is there."""
    if len(strokes) <= len(wanted):
        return list(strokes)
    if set(wanted) <= set(strokes):
        return list(wanted)
    last = len(strokes) - 1
    return sorted({strokes[round(place * last / (len(wanted) - 1))] for place in range(len(wanted))})


def tabled(strokes: Sequence[int], wanted: Sequence[int]) -> list[int]:
    """The wanted strokes that are there; where none is, strokes from the first to the last."""
    return [stroke for stroke in wanted if stroke in strokes] or drawn(strokes, wanted)


def ranges(strokes: Sequence[int]) -> str:
    """The strokes in words: "1 to 8", "1 to 4 and 9"."""
    runs: list[list[int]] = []
    for stroke in strokes:
        if runs and stroke == runs[-1][-1] + 1:
            runs[-1].append(stroke)
        else:
            runs.append([stroke])
    spans = [f"{run[0]} to {run[-1]}" if len(run) > 1 else f"{run[0]}" for run in runs]
    return ", ".join(spans[:-1]) + (" and " if len(spans) > 1 else "") + spans[-1] if spans else "none"


def missing_of(strokes: Sequence[int], wanted: Sequence[int]) -> str:
    """A sentence on the wanted strokes that the material does not have; empty where it has all of them."""
    missing = ", ".join(f"n={stroke}" for stroke in wanted if stroke not in strokes)
    known = f"stroke{'s' * (len(strokes) > 1)} {ranges(strokes)}"
    return f"{NOT_SHOWN}: {missing}. The material has {known}." if missing else ""


def rows_of(material: str) -> str:
    """The file that holds the numbers of every stroke of a material."""
    return f"processed/{material}/metrics.parquet"


def shown_of(strokes: Sequence[int], wanted: Sequence[int], material: str) -> str:
    """A sentence on which of a material's strokes a table shows, why these, and where all are; empty if it shows all.

    The file that it names is the one that the table was made of, so it is there wherever the table is.
    """
    tabled_strokes = tabled(strokes, wanted)
    if len(tabled_strokes) >= len(strokes):
        return ""
    named = ", ".join(f"n={stroke}" for stroke in tabled_strokes)
    reason = "the paper's rows" if set(tabled_strokes) <= set(wanted) else "spread over them, as none of the paper's is"
    whole = f"{len(strokes)} strokes, {ranges(strokes)}"
    return f"{SHOWN} {named} of the {whole}: {reason}. All strokes are rows of {rows_of(material)}, column stroke."


def in_figure(strokes: Sequence[int], shown: Sequence[int], wanted: Sequence[int]) -> str:
    """A sentence on which strokes a figure shows, and which of the `wanted` the tables do; empty of no stroke."""
    if not shown:
        return ""
    of_all = ", all that there are" if len(shown) == len(strokes) else f" of {ranges(strokes)}"
    rows = tabled(strokes, wanted)
    beside = "as in the tables" if list(shown) == rows else f"the tables show {_numbers(rows)}"
    return f"n is the number of the stroke. Shown: {_numbers(shown)}{of_all}; {beside}."


def _numbers(strokes: Sequence[int]) -> str:
    return f"n={', '.join(map(str, strokes))}"
