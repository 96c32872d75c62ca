"""Lines that a rig prints, one by one: which are samples, which name the columns, and which are other text."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from ...ground.words.counts import are, counted
from .fields import MAX_LINE, clock_at, fields, is_known, labelled, names_of, numbers, points
from .lines_without_names import Unnamed
from .naming import Naming

LISTED = 1000  # so many places are kept; all are counted
GREETINGS = 5  # so many lines of text are kept
REMEMBERED = 50  # so many lines that can be headers
USUALLY = Naming()
TEXT = re.compile(rb"\s*[A-Za-z\[<>*=!-]")
READABLE = re.compile(rb"[\s\x20-\x7e]*")


class Splitter:
    """Lines out of chunks of any size; of a line that is too long, only enough is kept to see that."""

    def __init__(self) -> None:
        self._rest = b""
        self.tail_bytes = 0  # since the last line's end

    def feed(self, chunk: bytes) -> list[bytes]:
        """Whole lines that end in a chunk."""
        *whole, rest = chunk.split(b"\n")
        if not whole:
            self._rest, self.tail_bytes = self._rest + rest[: MAX_LINE + 2], self.tail_bytes + len(rest)
            self._rest = self._rest[: MAX_LINE + 2]
            return []
        whole[0] = self._rest + whole[0]
        self._rest, self.tail_bytes = rest[: MAX_LINE + 2], len(rest)
        return whole


@dataclass
class Lines:
    """The lines printed so far; the columns are called `columns` if given, else as in the fitting header.

    A header is a line of names that is followed by lines of as many numbers. A later one that names the same columns in
    another order puts the fields back into the first one's; one that names others ends what can be read, until the
    first comes again. A line may as well have a name before each number. Greetings, banners and messages are passed
    over and counted, wherever they stand.
    """

    columns: tuple[str, ...] = ()
    clock: str | int | None = None  # the column that run.yaml reads as the time, by its name or index
    good: int = 0
    text: int = 0  # lines of words
    bad: int = 0  # lines that are neither words nor a sample
    noise: int = 0  # of these, such as are no text at all
    count: int = 0
    bad_lines: list[int] = field(default_factory=list)
    greetings: list[str] = field(default_factory=list)
    decimal_commas: int = 0
    swapped: int = 0  # headers with the columns in another order
    others: int = 0  # headers with other columns
    last: list[str] = field(default_factory=list)  # the last sample
    wrong: tuple[int, str, str] = (0, "", "")  # the last line of numbers that is none: how many, between them, the line

    def __post_init__(self) -> None:
        self.given = bool(self.columns)
        self.unnamed = Unnamed()
        self.headers: list[tuple[tuple[str, ...], str]] = []  # lines that can be
        self._printed: tuple[str, ...] = ()
        self._likely: tuple[str, ...] = ()
        self._labels: tuple[str, ...] = ()  # of the last line that has a name before each number
        self._order: list[int] | None = None
        self._foreign = False

    @property
    def time_at(self) -> int:
        """Which column is the device's time, -1 if none is."""
        return clock_at(self.columns, self.clock)

    def take(self, line: bytes) -> list[str] | None:
        """The fields of a sample, in the order of the columns and with decimal points, if the next line is a sample."""
        self.count += 1
        if not line.strip() or line.lstrip().startswith(b"#"):
            return None
        labels = labelled(line)
        if labels and self._printed and set(labels) != set(self._printed):
            self._pass_over(line)
            return None
        if labels and tuple(labels) != self._labels:
            self._labels = tuple(labels)
            self._header(self._labels, ",", ",".join(labels).encode())
        parts, between = (list(labels.values()), ",") if labels else fields(line)
        header = names_of(parts)
        if header:
            self._header(header, between, line)
            return None
        row = points(parts)
        if numbers(row) is None:
            self._pass_over(line)
            return None
        if self.count == 1:
            return None  # perhaps the second half of a line: half a number looks like a number
        if not self.columns or (self.given and not self._printed):
            self._find_header(len(row), between)
        if len(row) != len(self.columns) or self._foreign:
            self.wrong = (len(row), between, line[:60].decode("ascii", "replace").strip())
            if self._expected:
                self._bad()
            else:
                self.unnamed.take(row, line)
            return None
        self.good += 1
        self.decimal_commas += row != parts
        self.last = row if self._order is None else [row[at] for at in self._order]
        return self.last

    @property
    def _expected(self) -> tuple[str, ...]:
        """The columns, or those of a header that no line of numbers has matched yet."""
        return self.columns or self._likely

    def _header(self, header: tuple[str, ...], between: str, line: bytes) -> None:
        if not self._printed:
            self.headers = [*self.headers, (header, between)][-REMEMBERED:]
            may_name = self.wrong[0] in (0, len(header))  # else it is a remark: as many numbers as that came in no line
            self._likely = header if is_known(header) and may_name else self._likely
            self._pass_over(line)
        elif set(header) == set(self._printed):
            self._order = None if header == self._printed else [header.index(name) for name in self._printed]
            self._foreign = False
            self.swapped += self._order is not None
        elif set(header) & set(self._printed) and not self.given:
            self._foreign = True
            self.others += 1
        else:
            self._pass_over(line)

    def _find_header(self, count: int, between: str) -> None:
        """Find the last header with as many names as the first line of numbers has; a greeting is no header."""
        for header, its in reversed(self.headers):
            if len(header) == count and (is_known(header) or its == between != " "):
                self._printed = header
                self.columns = self.columns or header
                self.text -= sum(fields == header for fields, _ in self.headers)
                header_text = between.join(header)
                self.greetings = [
                    greeting
                    for greeting in self.greetings
                    if re.sub(r"\s", "", greeting) != re.sub(r"\s", "", header_text)
                ]
                return

    def _pass_over(self, line: bytes) -> None:
        if not TEXT.match(line) or len(line) > MAX_LINE:
            self.noise += len(line) > MAX_LINE or not READABLE.fullmatch(line)
            self._bad()
            return
        self.text += 1
        if len(self.greetings) < GREETINGS:
            line_text = line[:80].decode("ascii", "replace").strip()
            self.greetings.append("".join(character if character.isprintable() else "?" for character in line_text))

    def _bad(self) -> None:
        self.bad += 1
        self.bad_lines += [self.count] if len(self.bad_lines) < LISTED else []

    def reading(self, values: Sequence[str]) -> str:
        """What each column is read as, with the `values` of the last sample, and how many lines are not read."""
        commas = ", its decimal commas as points" if self.decimal_commas else ""
        return f"reads {', '.join(values)}{commas}; {self.counts()}"

    @property
    def not_read(self) -> int:
        """How many lines are not samples."""
        return self.text + self.bad + self.unnamed.count

    def counts(self) -> str:
        """How many lines are samples, and how many are not."""
        if not self.columns and self.unnamed.count:
            kept = self.unnamed.count
            words = f"{counted(kept, 'line')} of numbers {are(kept)} kept, and nothing names the columns"
            return words + (f"; {counted(self.text, 'line')} of text, {self.bad} bad" if self.text + self.bad else "")
        before = f", {self.unnamed.count} before their names" if self.unnamed.count else ""
        read = f"{counted(self.good, 'line')} {are(self.good)} read, {self.not_read} {are(self.not_read)} not"
        return f"{read} ({self.text} of text, {self.bad} bad{before})"

    def problem(self, seconds: float = 0.0, recover: str = "", naming: Naming = USUALLY) -> tuple[str, str]:
        """Why no line is read, and the mend with the command `recover`; the lines came within that many seconds."""
        count, between, line = self.wrong
        if not count:
            mend = "check what the rig prints" if not self.noise else "check --baud, and what the rig prints"
            return f"{counted(self.text + self.bad, 'line')} came, and none of numbers", mend
        if self._foreign:
            return "the rig has named other columns since", "reset it, or end the run and begin another"
        columns = self._expected
        if not columns:
            return self.unnamed.problem(seconds, recover, naming)
        mend = naming.mend(count, recover or "add")
        if between == "," and count > len(columns):
            mend = "if these are decimal commas, print decimal points or put ; between the numbers; else " + mend
        return f"lines like {line!r} have {count} numbers, and the columns are {', '.join(columns)}", mend
