"""Text of every report: the mark of its configuration, Markdown, the layout of the paper, the columns of a csv."""
