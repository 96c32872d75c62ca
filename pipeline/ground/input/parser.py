"""The command line of a program; for a misspelt option it tells the nearest one."""

import argparse
import difflib
import itertools
import sys
from collections.abc import Collection, Sequence
from typing import Any, NoReturn

from ..errors import bounded

LONGEST = 40  # characters of a word that are compared


class Parser(argparse.ArgumentParser):
    """An argument parser that names the nearest option for a misspelt one.

    Its help ends with the lines of `ending`, as they are: argparse would part paths at their hyphens.
    """

    _words: Sequence[str] = ()
    ending = ""

    def format_help(self) -> str:
        """As argparse does, then the ending."""
        return super().format_help() + (f"\n{self.ending}\n" if self.ending else "")

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """As argparse does; the words are kept for a complaint."""
        self._words = sys.argv[1:] if args is None else list(args)
        return super().parse_known_args(args, namespace)

    def typed_without(self, options: Collection[str]) -> list[str]:
        """The words that were typed, without these options; each of them takes a value, and may be cut short."""
        kept: list[str] = []
        words = iter(self._words)
        for word in words:
            name, equals, _ = word.partition("=")
            if word == "--":
                return [*kept, word, *words]
            if len(name) > 2 and name.startswith("--") and any(option.startswith(name) for option in options):
                if not equals:
                    next(words)
            else:
                kept.append(word)
        return kept

    def error(self, message: str) -> NoReturn:
        """End with exit status 2: usage, the fault, and the nearest option for each unknown one.

        A word of thousands of characters is cut.
        """
        super().error(bounded("; ".join([message, *self._meant()]), self._words))

    def _meant(self) -> list[str]:
        options = [option for option in self._option_string_actions if option.startswith("--")]
        words = itertools.takewhile(lambda word: word != "--", self._words)
        options_given = [word.partition("=")[0] for word in words if word.startswith("--")]
        sentences = []
        for word in dict.fromkeys(options_given):
            if not any(option.startswith(word) for option in options):  # a beginning is enough for argparse
                near = difflib.get_close_matches(word[:LONGEST], options, n=1)
                sentences += [f"did you mean {near[0]} by {word[:LONGEST]}?"] if near else []
        return sentences
