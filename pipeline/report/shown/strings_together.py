"""Which strokes of a table or figure are of several strings at once, in words."""

from collections.abc import Sequence

import pandas as pd

from ...ground.words.counts import counted

TOGETHER = "Strings together"
NAMED = 4  # strings that are named


def together(dataset: pd.DataFrame | None, strokes: Sequence[int]) -> str:
    """A sentence on shown strokes that come from several strings, since each string counts its own; else empty."""
    if dataset is None:
        return ""
    strings = dataset.groupby("stroke")["string"].agg(lambda names: sorted(set(map(str, names))))
    of_stroke = {stroke: strings[stroke] for stroke in strokes if stroke in strings.index}
    if not any(len(names) > 1 for names in of_stroke.values()):
        return ""
    every = sorted({name for names in of_stroke.values() for name in names})
    counts = {stroke: len(names) for stroke, names in of_stroke.items()}
    named = ", ".join(every[:NAMED]) + (f" and {len(every) - NAMED} more" if len(every) > NAMED else "")
    if len(set(counts.values())) == 1:
        hold = "holds that stroke" if len(counts) == 1 else "hold that stroke each"
        rows = f"{', '.join(f'n={stroke}' for stroke in counts)} {hold} of {len(every)} strings"
    else:
        (first, most), *others = counts.items()
        rows = ", ".join(
            [f"n={first} holds that stroke of {counted(most, 'string')}", *(f"n={n} of {m}" for n, m in others)]
        )
    return f"Strings together: {rows} ({named}), as every string counts its own."
