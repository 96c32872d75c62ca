"""The points of a dataset that a split trains on, and the points that it holds out."""

from pathlib import Path

import pandas as pd

from ...ground.errors import BadInput

SPLITS = ("within", "later")


def divided(dataset: pd.DataFrame, split: str, source: Path | str) -> tuple[pd.DataFrame, pd.DataFrame]:
    """Training and held-out points of a split, with their row numbers in the dataset as index.

    Both are empty for a split that the dataset leaves out. Raises BadInput, naming the source, when one is.
    """
    dataset = dataset.reset_index(drop=True)
    train, test = (dataset[dataset[split] == part] for part in ("train", "test"))
    for part, points in (("train", train), ("test", test)):
        if points.empty and (dataset[split] != "").any():
            raise BadInput(source, split, f'no point is "{part}"', "use the other split, or record more strokes")
    return train, test
