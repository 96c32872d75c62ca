"""Numbers without physics: percentiles, spans, regression, and whether two lengths or a stroke can be."""
