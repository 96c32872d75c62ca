"""Which model to take of a material, why, how it errs, and how it is asked and exported."""
