"""A page on this machine that shows a recording while it grows; it reads files and writes none (docs/watch.md)."""
