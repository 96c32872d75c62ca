"""Numbers without physics: percentiles, spans, regression, and checks of lengths and strokes."""
