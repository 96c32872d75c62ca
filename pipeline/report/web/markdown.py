"""Markdown → an HTML page: the same words, tables that sort, contents, links to pages instead of to Markdown."""

import re
from collections.abc import Sequence

from markdown_it import MarkdownIt
from markdown_it.renderer import RendererHTML
from markdown_it.token import Token
from markdown_it.utils import EnvType, OptionsDict
from markupsafe import Markup

from ..layout.made_by import MadeBy
from .page import anchor, document

INDEX = Markup(
    '<a href="../index.html">all reports</a> (made by the main job, snakemake --cores 2; it may be missing or older '
    "than this page)"
)  # the same from whatever job, so that a page is the same bytes
RANGE, UNBROKEN = re.compile(r"(?<=\d)–(?=\d)"), "\u2060–\u2060"  # no line ends between lowest and highest
SPREAD = re.compile(rf"(\d(?:</strong>)?) (\([\d.]+{UNBROKEN}[\d.]+\))</td>")  # behind a number: on a line of its own
DEEPEST = 2  # headings below are not in the contents


def _table_open(_: RendererHTML, tokens: Sequence[Token], at: int, options: OptionsDict, env: EnvType) -> str:
    return '<div class="scroll"><table class="sortable dense">\n'


def _table_close(_: RendererHTML, tokens: Sequence[Token], at: int, options: OptionsDict, env: EnvType) -> str:
    return "</table></div>\n"


def parser() -> MarkdownIt:
    """CommonMark with tables. HTML inside Markdown is text, and no link runs a script."""
    markdown = MarkdownIt("commonmark", {"html": False}).enable("table")
    markdown.add_render_rule("table_open", _table_open)
    markdown.add_render_rule("table_close", _table_close)
    return markdown


def _numeric(cells: list[str]) -> bool:
    return all(re.match(r"[*]*[-−+±]?\d", cell) for cell in cells if cell) and any(cells)


def _align(tokens: list[Token]) -> None:
    """Columns of words begin at the left; those whose cells all begin with a number end at the right."""
    start = 0
    for end, token in enumerate(tokens):
        if token.type == "table_open":
            start = end
        if token.type != "table_close":
            continue
        rows: list[list[tuple[Token, str]]] = []
        for place in range(start, end):
            if tokens[place].type == "tr_open":
                rows.append([])
            if tokens[place].type in ("th_open", "td_open"):
                rows[-1].append((tokens[place], tokens[place + 1].content.strip()))
        for column in range(len(rows[0])):
            if not _numeric([row[column][1] for row in rows[1:]]):
                for row in rows:
                    row[column][0].attrSet("class", "text")


def web_page(text: str, mark: MadeBy | None) -> str:
    """The page of a Markdown text whose first line is its title; it lies one folder below index.html."""
    markdown = parser()
    tokens = markdown.parse(text)
    _align(tokens)
    title, places = "", []
    for at, token in enumerate(tokens):
        if token.type == "heading_open":
            words = tokens[at + 1].content
            if token.tag == "h1" and not title:
                title = "".join(child.content for child in tokens[at + 1].children or [])
                token.hidden = tokens[at + 2].hidden = True
                tokens[at + 1].children = []
            elif int(token.tag[1:]) <= DEEPEST:
                name = "".join(child.content for child in tokens[at + 1].children or []) or words
                token.attrSet("id", anchor(name))
                places.append((anchor(name), name))
        for child in token.children or []:
            child.content = RANGE.sub(UNBROKEN, child.content)
            address = str(child.attrGet("href") or "")
            if child.type == "link_open" and "://" not in address and address.endswith(".md"):
                child.attrSet("href", address.removesuffix(".md") + ".html")
    rendered = SPREAD.sub(r"\1<br><small>\2</small></td>", markdown.renderer.render(tokens, markdown.options, {}))
    body = Markup(rendered)
    return document(title, body, mark, places, above=INDEX)
