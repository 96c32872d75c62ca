"""The legend above a panel of the life's page, which names no line that a panel above it has named."""

from collections.abc import Collection

from matplotlib.axes import Axes

COLUMNS = 3  # of a legend
ABOVE = (18.0, 30.0)  # points over a panel: its head, over a legend of one row, and of two
OWN = ("limit, ", "law fitted, ")  # how entries begin that every panel has of its own


def legend(axes: Axes, named: Collection[str] = ()) -> tuple[list[str], float]:
    """Draw the legend of a panel, without what is `named` above it, but for its limit and its law.

    Returns what it names, and how many points over the panel a head lies free of it.
    """
    handles, labels = axes.get_legend_handles_labels()
    entries = [at for at, label in enumerate(labels) if label not in named or label.startswith(OWN)]
    names = [labels[at] for at in entries]
    # beside the axes: on them it would lie over lines
    axes.legend(
        [handles[at] for at in entries], names, fontsize=7.5, loc="lower right", bbox_to_anchor=(1.0, 1.0),
        ncols=COLUMNS, borderaxespad=0.1,
    )  # fmt: skip
    return names, ABOVE[len(names) > COLUMNS]
