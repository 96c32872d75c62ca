"""Lines of numbers before any line names their columns: how many there are, and how to name the columns."""

from collections import Counter

from .likely_order import MOST_NAMES, Kept, likely_order
from .naming import Naming

CLOCKS = {"time_s": 1.0, "time_ms": 1e3, "time_us": 1e6}  # how many a second
PACE = 1.5  # a column that goes so many times faster or slower than a clock is none


class Unnamed:
    """Counts lines by how many numbers they have."""

    def __init__(self) -> None:
        self.count = 0
        self._counts: Counter[int] = Counter()
        self._ends: dict[int, tuple[float, float]] = {}  # by the count of numbers: the first and last first number
        self._example: dict[int, str] = {}
        self._kept: dict[int, Kept] = {}
        self._last: dict[int, list[str]] = {}

    def take(self, row: list[str], line: bytes) -> None:
        """Take note of a line and its numbers."""
        self.count += 1
        size, number = len(row), float(row[0])
        self._counts[size] += 1
        self._ends[size] = (self._ends.get(size, (number, number))[0], number)
        self._example[size] = line[:60].decode("ascii", "replace").strip()
        self._last[size] = row
        if size <= MOST_NAMES:
            self._kept.setdefault(size, Kept()).take(row)

    @property
    def size(self) -> int:
        """The most frequent count of numbers in a line; 0 without any."""
        return self._counts.most_common(1)[0][0] if self._counts else 0

    @property
    def example(self) -> str:
        """The last line with that count."""
        return self._example.get(self.size, "")

    def times(self) -> int:
        """How many lines have that count."""
        return self._counts[self.size]

    def clock(self, seconds: float) -> str:
        """The meaning of the first column if it runs like a clock over that many seconds, else nothing."""
        first, last = self._ends.get(self.size, (0.0, 0.0))
        pace = (last - first) / seconds if seconds > 0 else 0.0
        return next((name for name, rate in CLOCKS.items() if rate / PACE < pace < rate * PACE), "")

    def problem(self, seconds: float, recover: str, naming: Naming) -> tuple[str, str]:
        """What the lines are, and the mend with the command `recover`; they came within that many seconds."""
        if self.size == 1:
            mend = "let it print the time, the turns and the displacement in one line, such as 1250,3.5,2.75"
            return f"lines like {self.example!r} have one number, and a sample has more", mend
        came = f"{self.times()} lines of {self.size} numbers like {self.example!r} came"
        lost = "a header that was printed before the port was open is lost"
        clock = self.clock(seconds)
        own = naming.own if len(naming.own) == self.size else ()
        order = likely_order(naming.folder, own, self._kept[self.size]) if own and self.size in self._kept else ()
        mend = naming.mend(self.size, recover or "add", clock, order, self._last[self.size])
        return f"{came}, and no line that names their columns; {lost}", mend
