"""HTML tables that a click sorts."""

from collections.abc import Sequence

from markupsafe import Markup

from .page import Text


def table(
    head: Sequence[Text], rows: Sequence[Sequence[Text]], caption: Text = "", texts: Sequence[int] = (0,),
    over: Sequence[tuple[Text, int]] = (), paged: bool = False,
) -> Markup:  # fmt: skip
    """A table; columns `texts` hold words, the others numbers; `over` gives heads above heads, each with its width.

    A rule under such a head shows its columns.

    A `paged` one shows some of its rows at a time.
    """
    shape = [Markup(' class="text"') if column in texts else Markup("") for column in range(len(head))]
    names = Markup("").join(Markup("<th{}>{}</th>").format(of, name) for of, name in zip(shape, head, strict=True))
    ruled = Markup('<th class="over" colspan="{}"><span>{}</span></th>')
    wide = Markup("").join(
        ruled.format(width, name) if name else Markup('<th class="bare" colspan="{}"></th>').format(width)
        for name, width in over
    )
    above = Markup("<tr>{}</tr>\n").format(wide) if over else Markup("")
    lines = Markup("\n").join(
        Markup("<tr>{}</tr>").format(
            Markup("").join(Markup("<td{}>{}</td>").format(of, cell) for of, cell in zip(shape, row, strict=True))
        )
        for row in rows
    )
    caption_line = Markup("<caption><span>{}</span></caption>\n").format(caption) if caption else Markup("")
    return Markup(
        '<div class="scroll"><table class="{}">\n{}<thead>\n{}<tr>{}</tr>\n</thead>\n'
        "<tbody>\n{}\n</tbody></table></div>"
    ).format("sortable paged" if paged else "sortable", caption_line, above, names, lines)
