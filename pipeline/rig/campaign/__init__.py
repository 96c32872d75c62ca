"""A synthetic campaign: many strings of several materials, on rigs whose dimensions and loads vary."""
