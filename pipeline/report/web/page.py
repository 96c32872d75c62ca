"""The shell of every HTML page: title, the mark of its configuration, contents, body; nothing from the network."""

import re
from collections.abc import Iterable, Sequence
from pathlib import Path
from urllib.parse import quote

from markupsafe import Markup, escape

from ..layout.made_by import MadeBy, sentence

HERE = Path(__file__).parent
STYLE = Markup((HERE / "style.css").read_text(encoding="utf-8"))
SCRIPT = Markup((HERE / "page.js").read_text(encoding="utf-8"))
SHELL = Markup("""\
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
{style}</style>
</head>
<body>
{above}<h1>{title}</h1>
{mark}{contents}{body}{foot}
<script>
{script}</script>
</body>
</html>
""")
Text = str | Markup  # a str is escaped where it enters a page; Markup is HTML already
NEWLINE = Markup("\n")


def link(*parts: str) -> str:
    """A relative address of a file, whatever characters its folders' names hold."""
    return quote("/".join(parts))


def anchor(*parts: str) -> str:
    """The id of a place on a page: one word without characters that an address would need to escape."""
    return re.sub(r"[^\w.-]+", "-", "-".join(parts)).strip("-")


def together(parts: Iterable[Text]) -> Markup:
    """Parts of a page, one below the other."""
    return NEWLINE.join(parts)


def paragraph(text: Text) -> Markup:
    """A paragraph."""
    return Markup("<p>{}</p>").format(text)


def band(mark: MadeBy | None) -> Markup:
    """The band that says which configuration made the page; none where no configuration is asked."""
    if mark is None:
        return Markup("")
    return Markup('<p class="mark {}" role="note">{}</p>\n').format(mark.kind, sentence(mark, versioned=False))


def foot(mark: MadeBy | None) -> Markup:
    """The state of the configuration that made the page, for a comparison of two pages; empty if unknown."""
    if mark is None or not mark.name:
        return Markup("")
    return Markup('\n<p class="soft">Made by {}, {}.</p>').format(mark.name, mark.version)


def contents(places: Sequence[tuple[str, Text]]) -> Markup:
    """Links to places on the page."""
    lines = Markup("").join(Markup('<li><a href="#{}">{}</a></li>').format(at, words) for at, words in places)
    return Markup('<nav aria-label="contents"><ul>{}</ul></nav>\n').format(lines) if places else Markup("")


def folded(at: str, head: Text, aside: Text, body: Text, level: int = 2, is_open: bool = False) -> Markup:
    """A part of the page that opens on a click; `at` is its id."""
    shape = Markup('<details id="{at}"{open}><summary><h{level}>{head}</h{level}> <span>{aside}</span></summary>\n')
    opening = shape.format(at=at, open=Markup(" open") if is_open else "", level=level, head=head, aside=aside)
    return opening + escape(body) + Markup("\n</details>")


def picture(source: str, words: str, target: str = "", caption: Text = "") -> Markup:
    """A figure that a click enlarges, with what it shows in words, a caption and a link to a file to print."""
    better = Markup(' <a href="{}">To print: PDF</a>').format(target) if target else Markup("")
    below = Markup("<figcaption>{}{}</figcaption>").format(caption, better) if caption or better else Markup("")
    shape = Markup('<figure><a class="enlarge" href="{}"><img src="{}" alt="{}" loading="lazy"></a>{}</figure>')
    return shape.format(source, source, words, below)


def document(
    title: str, body: Text, mark: MadeBy | None = None, places: Sequence[tuple[str, Text]] = (), above: Text = ""
) -> str:
    """The whole page as text; `above` stands over the title and leads back."""
    return str(
        SHELL.format(
            title=title, style=STYLE, script=SCRIPT, mark=band(mark), contents=contents(places), body=body,
            above=paragraph(above) + NEWLINE if above else Markup(""), foot=foot(mark),
        )
    )  # fmt: skip
