"""Figures 4 and 5 of the paper, what stands beneath them, and how every figure looks."""
