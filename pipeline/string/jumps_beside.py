"""Changes of the zero between given runs and the other runs of the same string beside them."""

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from ..ground.errors import BadInput
from ..run.folder import find_runs, read_run, started_utc
from .from_raw import read
from .history import Recorded, in_order
from .jump import Jump
from .not_compared import uncompared
from .rests import Rests
from .tare_notes import tare_notes
from .zero import jumps_among

LAST = 4  # runs of a string that are compared with a new one

Reader = Callable[[Path], Recorded]


class Beside:
    """The rests of the runs beside others, each read once in a program; `known` runs are not read.

    `reader` reads the others: a program that holds recordings gives its own.
    """

    def __init__(self, rests_read: Iterable[Rests] = (), reader: Reader = read) -> None:
        self._reader = reader
        self._rests: dict[Path, Rests | None] = {rests.folder.resolve(): rests for rests in rests_read}

    def at(self, folder: Path) -> Rests | None:
        """The rests of a run, or None where it cannot be read."""
        place = folder.resolve()
        if place not in self._rests:
            try:
                self._rests[place] = Rests.of(self._reader(folder))
            except (BadInput, OSError, ValueError):
                self._rests[place] = None
        return self._rests[place]

    @property
    def unreadable(self) -> set[Path]:
        """The runs that should be read but could not."""
        return {place for place, rests in self._rests.items() if rests is None}

    def of_strings(self, place: Path, strings: set[str], but: set[Path]) -> list[Rests]:
        """Those of the runs in a folder of runs, `but` some, that name one of these strings."""
        rests_beside = [self.at(folder) for folder in runs_naming(place, strings, but)]
        return [rests for rests in rests_beside if rests]


def are_beside(runs: list[Rests]) -> bool:
    """Whether other runs lie beside these that name one of their strings; none of them is read."""
    places, strings = {rests.folder.resolve() for rests in runs}, {rests.run.string_id for rests in runs}
    return any(any(runs_naming(place, strings, places)) for place in {folder.parent for folder in places})


def jumps_into(runs: list[Rests], beside: Beside) -> list[Jump]:
    """Jumps of the zero into any of these runs, from one of them or from a run in the same folder as they.

    A run beside them that cannot be read tells nothing.
    """
    run_names = {rests.run.run for rests in runs}
    strings = {rests.run.string_id for rests in runs}
    every = list(runs)
    places = {rests.folder.resolve() for rests in runs}
    for place in sorted({folder.parent for folder in places}):
        every += [rests for rests in beside.of_strings(place, strings, places) if rests.run.run not in run_names]
    jumps_found = []
    for string in sorted(strings):
        jumps_found += jumps_among([rests for rests in every if rests.run.string_id == string])
    return [jump for jump in jumps_found if jump.run in run_names]


def advice_on(folder: Path, beside: Beside | None = None) -> list[str]:
    """The advice on the zero of a run that was just recorded: a sentence for each jump into it, or that none is seen.

    None where no other run of its string lies beside it, or where this one cannot be read. Of many others the last
    ones before it are read, so that nobody waits for a year of recordings.
    """
    try:
        run = read_run(folder)
        others = _last(list(runs_naming(folder.parent, {run.string_id}, {folder.resolve()})), started_utc(folder))
    except BadInput:
        return []
    beside = beside or Beside()
    before = [other for other in map(beside.at, others) if other]
    rests = beside.at(folder) if others else None
    if rests is None:
        return []
    every = in_order([*before, rests])
    jumped = [jump.advice for jump in jumps_among(every) if jump.run == run.run]
    return [*jumped, *(note for name, note in [*tare_notes(every), *uncompared(every)] if name == run.run)]


def _last(folders: list[Path], until_utc: str) -> list[Path]:
    """The last of some runs recorded before a time, or all where their order is unknown; BadInput."""
    if len(folders) <= LAST or not until_utc:
        return folders
    times = {folder: started_utc(folder) for folder in folders}
    if not all(times.values()):
        return folders
    return sorted((folder for folder in folders if times[folder] <= until_utc), key=times.__getitem__)[-LAST:]


def runs_naming(place: Path, strings: set[str], but: set[Path]) -> Iterator[Path]:
    """Runs in a folder of runs, `but` some, whose run.yaml names one of these strings."""
    return (folder for folder in find_runs(place) if folder.resolve() not in but and _names(folder, strings))


def _names(folder: Path, strings: set[str]) -> bool:
    """Whether a run's run.yaml names one of these strings."""
    try:
        text = (folder / "run.yaml").read_text(encoding="utf-8")
        return any(string in text for string in strings) and read_run(folder).string_id in strings
    except (BadInput, OSError, ValueError):
        return False
