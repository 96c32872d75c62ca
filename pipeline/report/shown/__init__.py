"""Which strokes a page shows, of which runs and strings, and under which load and to which twist they were recorded."""
