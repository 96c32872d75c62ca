"""Lines of numbers that came before anything named their columns: how many, and the names that they could have."""

from collections import Counter

LIKELY = ("motor_turns", "displacement_mm", "load_n", "temperature_c", "motor_current_a")
CLOCKS = {"time_s": 1.0, "time_ms": 1e3, "time_us": 1e6}  # how many a second
PACE = 1.5  # a column that goes so many times faster or slower than a clock is none
UNSURE = "(time_s where it prints seconds)"


class Unnamed:
    """Counts them by how many numbers they have."""

    def __init__(self) -> None:
        self.count = 0
        self._counts: Counter[int] = Counter()
        self._ends: dict[int, tuple[float, float]] = {}  # by the count of numbers: the first and last first number
        self._example: dict[int, str] = {}

    def take(self, row: list[str], line: bytes) -> None:
        """Take note of a line and its numbers."""
        self.count += 1
        size, number = len(row), float(row[0])
        self._counts[size] += 1
        self._ends[size] = (self._ends.get(size, (number, number))[0], number)
        self._example[size] = line[:60].decode("ascii", "replace").strip()

    @property
    def size(self) -> int:
        """How many numbers most of them have; 0 without any."""
        return self._counts.most_common(1)[0][0] if self._counts else 0

    @property
    def example(self) -> str:
        """The last of those."""
        return self._example.get(self.size, "")

    def times(self) -> int:
        """How many of them there are."""
        return self._counts[self.size]

    def clock(self, seconds: float) -> str:
        """What the first column is if it went on as a clock does in so many seconds, else nothing."""
        first, last = self._ends.get(self.size, (0.0, 0.0))
        pace = (last - first) / seconds if seconds > 0 else 0.0
        return next((name for name, rate in CLOCKS.items() if rate / PACE < pace < rate * PACE), "")

    def columns(self, seconds: float) -> str:
        """An option that names them, with a name for each number; with a remark where their clock is not known."""
        clock = self.clock(seconds)
        return named(self.size, clock or "time_ms") + ("" if clock or self.size < 3 else f" {UNSURE}")


def named(size: int, clock: str = "time_ms") -> str:
    """An option that names so many columns as a rig may have them."""
    names = [*([clock] if size != 2 else []), *LIKELY]
    names += [f"column_{at}" for at in range(len(names) + 1, size + 1)]
    return f"--columns {','.join(names[: max(2, size)])}"
