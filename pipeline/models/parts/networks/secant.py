"""How the conditional INN is inverted, told once: the model does so, and what is exported of it, without torch."""

SECANTS = 4  # steps
FLATTEST, STEEPEST, NEAREST = 0.2, 5.0, 1e-5  # of the secant's slope and width, in standard deviations
