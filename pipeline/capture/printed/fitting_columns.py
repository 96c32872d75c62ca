"""Whether the named columns of printed lines are those of the run's channels."""

from pathlib import Path

from ...ground.errors import BadInput
from ...run.description import Run
from ...run.folder import read_run
from .lines_to_csv import CSV
from .near_names import mend_of


def unusable_columns(folder: Path) -> bool:
    """Whether the run is described and its channels do not match the columns' names."""
    try:
        check_channels(read_run(folder), folder, again=True)
    except BadInput as error:
        return error.file == str(folder / CSV)
    return False


def check_channels(run: Run, folder: Path, again: bool = False) -> None:
    """Raise BadInput where the named columns of printed lines are not those of the run's channels."""
    import pandas as pd  # for which no rig should wait

    from ...run.table.channels import Channels

    channels, first = Channels(run, folder / CSV, folder / "run.yaml", again), pd.read_csv(folder / CSV, nrows=1)
    try:
        channels.look(first)
        channels.samples(first)
    except BadInput as error:
        mend = mend_of(error.mend, [str(name) for name in first.columns], run, folder)
        raise BadInput(error.file, error.field, error.problem, mend) from None
