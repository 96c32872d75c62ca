"""The strokes that a page shows, with their runs and strings, their load and their twist."""
