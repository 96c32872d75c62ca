"""The words of the pages: a list at the end, and the meaning of a word under the pointer."""

from markupsafe import Markup

from ...ground.words.glossary import MEANING, TERMS
from .page import folded, together


def word(text: str) -> Markup:
    """A word that shows its meaning under the pointer; text that the glossary does not know stays as it is."""
    if text not in MEANING:
        return Markup("{}").format(text)
    return Markup('<abbr title="{}">{}</abbr>').format(MEANING[text], text)


def glossary() -> Markup:
    """All words, folded."""
    parts = [
        Markup("<h3>{}</h3>\n<dl>\n{}\n</dl>").format(
            head, together(Markup("<dt>{}</dt><dd>{}</dd>").format(word, words) for word, words in terms.items())
        )
        for head, terms in TERMS.items()
    ]
    return folded("glossary", "Glossary", "what the words of the pages mean", together(parts))
