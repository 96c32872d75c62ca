"""The words of a command in a file, which argparse reads (`@FILE`): a shell takes at most 128 kB per command.

A file is named after its content. So a command changes when its words do, and who reads it reads what was meant.
"""

import hashlib
from collections.abc import Iterable
from pathlib import Path

from ..stored.files import write_text

SIGN = "@"  # an argument parser's fromfile_prefix_chars


def by_file(words: Iterable[str], folder: Path, start: Path | str = "") -> str:
    """Write words, one a line, into a file of a folder, and return the word that stands for all of them.

    `start` is where the command starts, if that is elsewhere: `folder` is meant from there. Raises ValueError for a
    word of several lines.
    """
    words = list(words)
    text = "".join(f"{word}\n" for word in words)
    if text.splitlines() != words:
        raise ValueError("a word of several lines cannot stand in a file of words")
    path = folder / hashlib.sha256(text.encode()).hexdigest()[:16]
    if not Path(start, path).is_file():
        write_text(Path(start, path), text)
    return f"{SIGN}{path}"


def spread(words: Iterable[str]) -> list[str]:
    """Words, with those of a file in place of the word that stands for them."""
    all_words: list[str] = []
    for word in words:
        if word.startswith(SIGN) and Path(word[1:]).is_file():
            all_words += Path(word[1:]).read_text(encoding="utf-8").splitlines()
        else:
            all_words.append(word)
    return all_words
