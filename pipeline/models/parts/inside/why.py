"""The reasons beside an answer, each of a kind: programs count kinds, a person reads the sentences."""

from dataclasses import dataclass
from enum import Enum, auto

from .beyond_range import also


class Kind(Enum):
    """What a reason is about: an answer without an interval, a wider one, or a number that nobody told."""

    OUTSIDE = auto()  # it was not recorded so
    BETWEEN = auto()  # it lies between recorded values of a condition
    ERRS_MORE = auto()  # its stroke errs more than others
    TOGETHER = auto()  # of a new string: what sets it apart changed together with something else
    IMPOSSIBLE = auto()  # the model's number cannot be, and is not given
    ASSUMED = auto()  # its stiffness is the usual one of its size
    NO_QUESTION = auto()  # the row asks nothing that can be answered


@dataclass(frozen=True)
class Why:
    """The reasons beside one answer, in the order in which they are read."""

    reasons: tuple[tuple[Kind, str], ...] = ()

    def also(self, kind: Kind, sentence: str) -> "Why":
        """The same with one reason more; unchanged where the sentence is empty."""
        return Why((*self.reasons, (kind, sentence))) if sentence else self

    def tells(self, kind: Kind) -> bool:
        """Whether one of the reasons is of a kind."""
        return any(each is kind for each, _ in self.reasons)

    def __str__(self) -> str:
        """The sentences, as the column `why` of the answers has them."""
        words = ""
        for _, sentence in self.reasons:
            words = also(words, sentence)
        return words
