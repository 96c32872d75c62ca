"""The inversion of the conditional INN, defined once: the model and the exports, without torch, share it."""

SECANTS = 4  # steps
FLATTEST, STEEPEST, NEAREST = 0.2, 5.0, 1e-5  # of the secant's slope and width, in standard deviations
