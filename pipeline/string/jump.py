"""A change of the rest between two runs of a string, in words: a jump of the zero, or what the string did itself."""

from dataclasses import dataclass
from pathlib import Path

from ..ground.words.counts import counted
from ..ground.words.jump_notes import OFF
from ..run.mend_command import tare_command
from .recovered import NOTHING, Recovered

# How far off the zero is, in the median, where a string took something back: less than that is no move.
KNOWN_MM = 0.05
# How far off it is in nine of ten breaks, of the strings of docs/models.md that are worst: more is asked about.
NINE_OF_TEN_MM = 0.26
TAKEN_OFF = "taken off the displacement before the tables and models are made."  # a moved zero is


@dataclass(frozen=True)
class Jump:
    """A run's rest that differs from the one before it: by `jump_mm`, with a noise floor of `floor_mm`.

    `unrecorded` strokes were done in between by what run.yaml says: the change may be theirs. What the string took back
    in the break is `own`: the zero was moved by the rest. Of a zero that was `checked` it is no jump: all is the
    string's.
    """

    before: str
    run: str
    jump_mm: float
    floor_mm: float
    unrecorded: int = 0
    taken_off: bool = False  # by `tare: run` in the run's run.yaml
    own: Recovered = NOTHING
    checked: bool = False  # by `tare: checked` in the run's run.yaml
    folder: Path = Path()  # of the run
    anew: tuple[str, str] | None = None  # the last run before it that says `tare: run`, and the one before that

    @property
    def entry(self) -> dict[str, str | float]:
        """The entry in a diagnosis' `zero_jumps`."""
        return {"before": self.before, "run": self.run, "jump_mm": self.jump_mm, "floor_mm": self.floor_mm}

    @property
    def may_be_wear(self) -> bool:
        """Whether the string may have changed so: its zero was checked, or strokes were not recorded."""
        return self.checked or (self.unrecorded > 0 and not self.taken_off)

    @property
    def is_unconfirmed(self) -> bool:
        """Whether no run.yaml says what the zero did."""
        return not (self.taken_off or self.checked)

    @property
    def moved_mm(self) -> float:
        """By how much the zero was moved."""
        return self.jump_mm - self.own.mm

    @property
    def is_own(self) -> bool:
        """Whether all of it is what the string took back, as far as that is known: then it is no jump.

        Whoever says what the zero did knows more than the estimate, and strokes in between were not measured with it.
        """
        is_asked = self.is_unconfirmed and not self.unrecorded
        return self.own.mm > 0.0 and abs(self.moved_mm) <= (NINE_OF_TEN_MM if is_asked else KNOWN_MM)

    @property
    def own_note(self) -> str:
        """What is told of a change that is the string's own; empty where the estimate leaves nothing of note."""
        if abs(self.moved_mm) <= KNOWN_MM:
            return ""
        return (
            f"At rest {self.run} reads {self._more} than {self.before} at its end: the string took back about "
            f"{self.own.mm:.2g} mm, and the {self.moved_mm:+.2g} mm left are within what such an estimate is off "
            f"({NINE_OF_TEN_MM:g} mm in nine of ten breaks). Nothing to do, unless you touched the sensor or a clamp "
            f"(then: {tare_command(self.folder, 'run')})."
        )

    @property
    def _more(self) -> str:
        return f"{_two_digits(abs(self.jump_mm))} mm {'more' if self.jump_mm > 0 else 'less'}"

    @property
    def sentence(self) -> str:
        """The observed change, in words."""
        floors = f"{_two_digits(abs(self.jump_mm) / self.floor_mm)} times the noise ({self.floor_mm:.2g} mm)"
        were = "was" if self.unrecorded == 1 else "were"
        between = f"{counted(self.unrecorded, 'stroke')} that {were} not recorded" if self.unrecorded else "no stroke"
        jumps = "At rest" if self.checked else "The zero jumps between two runs of one string: at rest"
        return (
            f"{jumps} {self.run} reads {self._more} than {self.before} at its end, {floors}, with {between} in between."
        )

    @property
    def in_short(self) -> str:
        """What a page says on which nothing depends on it: all of it only where nobody has said what the zero did."""
        if self.taken_off:
            return (
                f"run.yaml of {self.run} says `tare: run`: its zero was set anew since {self.before}, by "
                f"{self.moved_mm:+.2g} mm as its rests tell."
            )
        if self.checked:
            reads = f"At rest {self.run} reads {self._more} than {self.before} at its end"
            return f"{reads}. Its run.yaml says `tare: checked`: so the change is the string's own."
        return self.advice

    @property
    def advice(self) -> str:
        """The observed change, and what to do if the zero was moved, or was not, or that it was done."""
        if self.taken_off:
            return f"{self.sentence} run.yaml of {self.run} says `tare: run`. {taken_off(self.jump_mm, self.own)}"
        if self.checked:
            return f"{self.sentence} run.yaml of {self.run} says `tare: checked`: so the change is the string's own."
        own, and_own = "", ""
        if self.own.mm:
            moved_so = (
                f"So the zero was moved by {self.moved_mm:+.2g} mm, if at all: on simulated strings that was {OFF}."
            )
            own = f" {self.own.sentence} {moved_so}"
            and_own = " and what the string took back"
        since = ""
        if self.anew:
            since = " It is compared with the zero since {}'s own tare: one back where {} had it is a jump too."
            since = since.format(*self.anew)
        moved, stayed = (tare_command(self.folder, tare) for tare in ("run", "checked"))
        ended = f"from where {self.before} ended{and_own}"
        return (
            f"{self.sentence}{own}{since} If the sensor or a clamp was moved or set to zero, write `tare: run` in "
            f"run.yaml of {self.run} ({moved}): it is then tared on its own rest, {ended}. If they were "
            f"checked and did not move, write `tare: checked` ({stayed}): the change is then the string's own."
        )


def taken_off(change_mm: float, own: Recovered) -> str:
    """What is taken off for the `tare: run` of a run: the change of its rest, less what the string did itself."""
    if not own.mm:
        return f"So this change is {TAKEN_OFF}"
    return f"{own.sentence} So the zero was moved by {change_mm - own.mm:+.2g} mm, and that is {TAKEN_OFF}"


def _two_digits(value: float) -> str:
    """A number with two digits and no exponent: 150, 5100, 0.28."""
    return f"{float(f'{value:.2g}'):,.10g}"
